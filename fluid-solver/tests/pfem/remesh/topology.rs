//! Surfaces merge and break.

use super::{Fluid, Seeds};
use crate::support::{momentum, tank};
use fluid_solver::backend::pfem::wall::{Grip, Shape, Wall, patches};

const H: f64 = 0.02;

/// Pieces of fluid that share no node.
fn pieces(fluid: &Fluid) -> usize {
    let mut piece: Vec<usize> = (0..fluid.cloud.place.len()).collect();
    fn root(piece: &[usize], mut node: usize) -> usize {
        while piece[node] != node {
            node = piece[node];
        }
        node
    }
    for cell in &fluid.cloud.cells {
        let roots = cell.map(|node| root(&piece, node as usize));
        let least = roots.into_iter().min().unwrap();
        for other in roots {
            piece[other] = least;
        }
    }
    let wet = fluid.cloud.wet();
    (0..piece.len()).filter(|&node| wet[node] && piece[node] == node).count()
}

#[test]
fn a_falling_drop_and_a_pool_become_one_and_nothing_is_gained() {
    let walls = tank::<2>([0.6, 1.0], Grip::Slip);
    let mut seeds = Seeds::new(&walls);
    seeds.add_box([0.6, 0.2], H, 3, |x| x);
    let first = seeds.cloud.place.len();
    seeds.add_disc([0.3, 0.39], 0.08, H, [0.0, -1.0]);
    let mut fluid = seeds.mesh(H, 0.9);
    fluid.shift(first, [0.0, -0.1]);
    assert_eq!(pieces(&fluid), 2);
    let mut struck = 0;
    for step in 0..30 {
        let events = fluid.drift(0.001);
        struck += u32::from(events.closed > 0);
        assert_eq!(pieces(&fluid), if struck == 0 { 2 } else { 1 }, "step {step}");
        // The gap is 0.01; it closes at 0.1 h.
        assert!(struck > 0 || step < 12);
        assert!(struck == 0 || step > 6, "step {step}");
    }
    fluid.check();
    assert!(fluid.volume_error().abs() < 5e-3, "{}", fluid.volume_error());
}

#[test]
fn a_sheet_that_thins_breaks_into_drops_that_carry_its_volume() {
    let mut seeds = Seeds::new(&[]);
    seeds.add_box([0.4, 0.04], H, 1, |x| [x[0] - 0.2, x[1] - 0.02]);
    let mut fluid = seeds.mesh(H, 1.2);
    let (mut released, mut largest) = (0, 0.0f64);
    // A neck at the middle, twice as wide as h.
    for _ in 0..400 {
        let events = fluid.carry(0.01, |x, _| {
            [(40.0 * x[0]).clamp(-1.0, 1.0) * 0.05, if x[0].abs() < 0.025 { -2.0 * x[1] } else { 0.0 }]
        });
        released += events.released + events.broken;
        largest = largest.max(fluid.volume_error().abs());
    }
    fluid.check();
    assert!(released > 0);
    assert!(pieces(&fluid) >= 2, "{}", pieces(&fluid));
    assert!(largest < 5e-3, "{largest}");
}

#[test]
fn surfaces_that_have_crossed_are_counted_once() {
    let mut seeds = Seeds::new(&[]);
    seeds.add_disc([-0.15, 0.0], 0.1, H, [1.0, 0.0]);
    let first = seeds.cloud.place.len();
    seeds.add_disc([0.15, 0.013], 0.1, H, [-1.0, 0.0]);
    let mut fluid = seeds.mesh(H, 0.9);
    assert_eq!(pieces(&fluid), 2);
    let before = momentum(&fluid.cloud);
    // They jump over the gap, and overlap by 0.02.
    fluid.shift(first, [-0.08, 0.0]);
    let events = fluid.drift(0.02);
    assert!(events.crossed);
    fluid.check();
    assert_eq!(pieces(&fluid), 1);
    let overlap = fluid.books.volume.overlap.sum;
    let (r, half) = (0.1f64, 0.5 * 0.18f64.hypot(0.013));
    let lens = 2.0 * (r * r * (half / r).acos() - half * (r * r - half * half).sqrt());
    assert!((overlap + lens).abs() < 0.35 * lens, "{overlap} against {lens}");
    let after = momentum(&fluid.cloud);
    assert!((0..2).all(|k| (after[k] - before[k]).abs() < 1e-13), "{before:?} {after:?}");
}

#[test]
fn a_drop_in_flight_is_taken_up_with_its_momentum_and_its_volume_is_owed() {
    let walls = tank::<2>([0.6, 1.0], Grip::Slip);
    let mut seeds = Seeds::new(&walls);
    seeds.add_box([0.6, 0.2], H, 3, |x| x);
    seeds.add([0.31, 0.205], [0.5, -1.0]);
    let last = seeds.cloud.place.len() - 1;
    seeds.cloud.drop[last] = 1e-4;
    let mut fluid = seeds.mesh(H, 1.2);
    assert!((fluid.books.volume.target - 0.1201).abs() < 1e-12);
    fluid.shift(last, [0.0, -0.0045]);
    let before = momentum(&fluid.cloud);
    assert_eq!(fluid.remesh().absorbed, 1);
    assert!(fluid.cloud.drop.iter().all(|&drop| drop == 0.0));
    let after = momentum(&fluid.cloud);
    assert!((after[0] - before[0]).abs() < 1e-16 && before[0] > 4e-5, "{before:?} {after:?}");
    assert!((fluid.books.volume.absorption.sum + 1e-4).abs() < 1e-18);
    for _ in 0..40 {
        fluid.cloud.velocity.fill([0.0; 2]);
        fluid.drift(0.0);
    }
    assert!(fluid.volume_error().abs() < 1e-6, "paid back: {}", fluid.volume_error());
}

#[test]
fn a_void_closed_in_on_all_sides_is_filled_when_it_is_small() {
    let mut seeds = Seeds::new(&[]);
    let r = 0.1;
    // A ring whose hole shrinks.
    for k in 0..5 {
        let radius = r + H * f64::from(k);
        let nodes = (std::f64::consts::TAU * radius / H).round();
        for i in 0..nodes as u32 {
            let angle = std::f64::consts::TAU * f64::from(i) / nodes + f64::from(k);
            seeds.add([radius * angle.cos(), radius * angle.sin()], [0.0; 2]);
        }
    }
    let mut fluid = seeds.mesh(H, 0.9);
    let mut filled = 0;
    for _ in 0..3000 {
        let events = fluid.carry(1e-3, |x, _| {
            let square = (x[0] * x[0] + x[1] * x[1]).max(1e-6);
            [-0.01 * x[0] / square, -0.01 * x[1] / square].map(|v| 0.2 * v)
        });
        filled += events.filled;
        if filled > 0 {
            break;
        }
    }
    assert_eq!(filled, 1);
    fluid.check();
    let gained = fluid.books.volume.merging.sum;
    assert!(gained > 0.2 * H * H && gained < 0.55 * H * H, "{} h²", gained / (H * H));
}

#[test]
fn a_cell_that_cuts_the_corner_of_an_obstacle_leaves_it() {
    // The fluid is above and on the right of a convex corner at the origin.
    let corner = patches::<2>(&[[[-1.0, 0.0], [0.0, 0.0]], [[0.0, 0.0], [0.0, -1.0]]]).remove(0);
    let walls = [Wall::new("corner", Shape::Patch(corner), Grip::Slip)];
    let mut seeds = Seeds::new(&walls);
    let on_it = [[-0.05, 0.0], [0.0, -0.05], [0.0, -0.12]];
    let beside = [[-0.05, 0.09], [0.04, 0.09], [0.09, 0.0], [0.09, -0.09], [0.09, -0.17]];
    on_it.into_iter().chain(beside).for_each(|place| seeds.add(place, [0.0; 2]));
    let fluid = seeds.mesh(0.1, 1.2);
    let holds = |cell: &[u32; 3]| cell.iter().filter(|&&node| (node as usize) < on_it.len()).count();
    let most = fluid.cloud.cells.iter().map(holds).max();
    assert_eq!(most, Some(2), "{:?}", fluid.cloud.cells);
}

#[test]
fn a_film_tangled_with_itself_and_the_body_below_it_costs_no_body() {
    // One of these films has edges along each other that no common nodes part.
    for seed in 2150..2200u64 {
        let mut state = seed.wrapping_mul(7919).wrapping_add(1);
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 33) as f64 / (1u64 << 31) as f64 - 0.5
        };
        let mut seeds = Seeds::new(&[]);
        seeds.add_box([0.4, H], H, 1, |x| x);
        let film = seeds.cloud.place.len();
        seeds.add_box([0.4, 0.2], H, 1, |x| [x[0], x[1] + 0.1]);
        let mut fluid = seeds.mesh(H, 1.2);
        let thickness = 0.1 * (seed % 10) as f64;
        for x in &mut fluid.cloud.place[..film] {
            *x = [x[0] + H * random(), thickness * x[1] + 0.09 + 0.3 * H * random()];
        }
        let before = fluid.books.volume.cells;
        fluid.remesh();
        let kept = fluid.books.volume.cells / before;
        assert!((kept - 1.0).abs() < 0.2, "seed {seed}: {kept}");
    }
}
