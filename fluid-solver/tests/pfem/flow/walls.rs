//! What walls do within a step.

use crate::support::{G, WATER, advance, block, flow, gravity, largest_speed, tank, touch, volume};
use fluid_solver::backend::Step;
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::flow::{Control, Flow, FlowFault, Forces};
use fluid_solver::backend::pfem::wall::{Grip, Plane, Shape, Wall, patches};
use fluid_solver::element::simplex::dot;
use std::f64::consts::{PI, TAU};
use surface::motion::Motion;

/// A tank that starts to move with an acceleration of its own; its surface is level for who moves with it.
fn accelerated<const D: usize, const N: usize>(cells: [usize; D], amplitude: [f64; D]) {
    let (frequency, length, size) = (1.0, 1e-3, [0.2; D]);
    // At rest a quarter of a period after the middle.
    let start = 0.25 / frequency;
    let way = |time: f64| amplitude.map(|a| a * (TAU * frequency * time).sin());
    let (from, to) = (way(start), way(start + length));
    let acceleration: [f64; D] = std::array::from_fn(|k| 2.0 * (to[k] - from[k]) / (length * length));
    let felt: [f64; D] = std::array::from_fn(|k| if k == D - 1 { -G } else { 0.0 } - acceleration[k]);

    let mut cloud = block::<D, N>(size, cells, 0.25);
    for x in &mut cloud.place {
        let tilt: f64 = (0..D - 1).map(|k| felt[k] * x[k]).sum::<f64>() / -felt[D - 1];
        x[D - 1] *= 1.0 + tilt / size[D - 1];
    }
    let depth = |x: &[f64; D]| {
        let tilt: f64 = (0..D - 1).map(|k| felt[k] * x[k]).sum::<f64>() / -felt[D - 1];
        size[D - 1] + tilt - x[D - 1]
    };
    let exact: Vec<f64> = cloud.place.iter().map(|x| -WATER.density * felt[D - 1] * depth(x)).collect();
    let walls: Vec<Wall<D>> = tank(size, Grip::Slip)
        .into_iter()
        .map(|wall| wall.moving(Motion::oscillation(amplitude, frequency)))
        .collect();
    touch(&mut cloud, &walls);
    for x in &mut cloud.place {
        (0..D).for_each(|k| x[k] += from[k]);
    }
    let step = Step { time: start, length };
    let solution = flow(WATER, 1e-12).solve(&cloud, &walls, step, &gravity()).unwrap();
    for (p, exact) in solution.pressure.iter().zip(&exact) {
        assert!((p - exact).abs() <= 1e-8 * WATER.density * G * size[0], "{p} against {exact}");
    }
    for v in &solution.velocity {
        assert!((0..D).all(|k| (v[k] - 0.5 * length * acceleration[k]).abs() <= 1e-10));
    }
}

#[test]
fn the_pressure_in_an_accelerated_tank_is_exact() {
    accelerated::<2, 3>([7, 6], [0.1, -0.05]);
    accelerated::<3, 4>([4, 4, 5], [0.1, 0.03, -0.05]);
}

#[test]
fn a_front_that_reaches_a_wall_ends_on_it_and_slides() {
    let mut cloud = block::<2, 3>([0.1, 0.1], [8, 8], 0.25);
    cloud.velocity.fill([1.0, 0.0]);
    let mut walls = tank([0.1005, 1.0], Grip::Slip);
    walls.remove(0);
    touch(&mut cloud, &walls);
    let before = volume(&cloud);
    let front: Vec<usize> = (0..cloud.place.len()).filter(|&node| cloud.place[node][0] > 0.0999).collect();
    advance(&mut flow(WATER, 1e-10), &mut cloud, &walls, &gravity(), 1e-3, 0..1, |_, _| ());
    assert_eq!(front.len(), 9);
    for &node in &front {
        assert!(cloud.contacts[node].contains(0) && (cloud.place[node][0] - 0.1005).abs() < 1e-15);
        assert_eq!(cloud.velocity[node][0], 0.0);
    }
    assert!((volume(&cloud) / before - 1.0).abs() < 1e-10);
}

#[test]
fn nodes_on_a_round_of_planes_stay_on_them_and_a_corner_holds_both() {
    // A wedge of 60 degrees.
    let normals: Vec<[f64; 2]> = [PI / 6.0, PI - PI / 6.0].map(|angle| [angle.cos(), angle.sin()]).to_vec();
    let walls: Vec<Wall<2>> = normals
        .iter()
        .map(|&normal| Wall::new("side", Shape::Plane(Plane { point: [0.0; 2], normal }), Grip::Slip))
        .collect();
    let mut cloud = block::<2, 3>([1.0, 1.0], [6, 6], 0.0);
    for x in &mut cloud.place {
        // The square's corner at the origin becomes that of the wedge.
        let [a, b] = *x;
        *x = [0.1 * (a - b) * 0.5, 0.1 * (a + b) * (PI / 3.0).sin()];
    }
    touch(&mut cloud, &walls);
    assert_eq!(cloud.contacts.iter().filter(|contacts| contacts.iter().count() == 2).count(), 1);
    advance(&mut flow(WATER, 1e-8), &mut cloud, &walls, &gravity(), 1e-3, 0..20, |cloud, _| {
        for (x, contacts) in cloud.place.iter().zip(&cloud.contacts) {
            assert!(contacts.iter().all(|wall| dot(&normals[wall], x).abs() < 1e-15));
        }
    });
    assert!(largest_speed(&cloud) > 1e-3 && cloud.place[0].iter().all(|x| x.abs() < 1e-15));
}

#[test]
fn a_vessel_full_to_the_lid_stays_at_rest() {
    let mut cloud = block::<2, 3>([0.1, 0.1], [8, 8], 0.25);
    let mut walls = tank([0.1, 0.1], Grip::Slip);
    let lid = Plane { point: [0.0, 0.1], normal: [0.0, -1.0] };
    walls.push(Wall::new("lid", Shape::Plane(lid), Grip::Slip));
    touch(&mut cloud, &walls);
    advance(&mut flow(WATER, 1e-10), &mut cloud, &walls, &gravity(), 1e-3, 0..20, |cloud, _| {
        assert!(largest_speed(cloud) <= 1e-9, "{:e}", largest_speed(cloud));
    });
    let level = cloud.pressure[0] + WATER.density * G * cloud.place[0][1];
    for (p, x) in cloud.pressure.iter().zip(&cloud.place) {
        assert!((p + WATER.density * G * x[1] - level).abs() <= 1e-6 * WATER.density * G * 0.1);
    }
}

#[test]
fn a_column_hangs_under_a_lid_as_in_a_straw_whatever_the_suction() {
    // Open below; of 30 m water in air would boil.
    for height in [0.2, 30.0] {
        let mut cloud = block::<2, 3>([0.1 * height, height], [3, 30], 0.25);
        let mut walls = tank([0.1 * height, height], Grip::Slip);
        let lid = Plane { point: [0.0, height], normal: [0.0, -1.0] };
        walls[2] = Wall::new("lid", Shape::Plane(lid), Grip::Slip);
        touch(&mut cloud, &walls);
        advance(&mut flow(WATER, 1e-10), &mut cloud, &walls, &gravity(), 1e-3, 0..50, |cloud, solution| {
            let held: f64 = solution.reaction.iter().map(|force| force[1]).sum();
            let weight = WATER.density * G * 0.1 * height * height;
            assert!((held / weight - 1.0).abs() <= 1e-8 && largest_speed(cloud) <= 1e-9, "{held}");
        });
        for (p, x) in cloud.pressure.iter().zip(&cloud.place) {
            assert!(
                (p + WATER.density * G * x[1]).abs() <= 1e-8 * WATER.density * G * height,
                "{p} at {x:?}"
            );
        }
    }
}

#[test]
fn a_step_that_turns_a_cell_over_is_refused_with_one_that_does_not() {
    let mut cloud = block::<2, 3>([0.1, 0.1], [4, 4], 0.0);
    let inner = (0..cloud.place.len()).find(|&node| cloud.place[node] == [0.05, 0.05]).unwrap();
    cloud.velocity[inner] = [100.0, 0.0];
    let still = Forces { gravity: [0.0; 2], grains: None };
    let mut flow = Flow::<2, 3>::new(WATER, Control::default());
    let bound = flow.largest_step(&cloud);
    assert!(bound > 0.0 && bound < 0.025 / 100.0, "{bound}");
    let attempt =
        |flow: &mut Flow<2, 3>, length: f64| flow.solve(&cloud, &[], Step { time: 0.0, length }, &still);
    let Err(FlowFault::Inverted { bound, length, .. }) = attempt(&mut flow, 5e-3) else { panic!("accepted") };
    assert!(bound < length);
    let mut length = bound;
    while let Err(fault) = attempt(&mut flow, length) {
        let FlowFault::Inverted { bound, .. } = fault else { panic!("{fault}") };
        assert!(bound < length);
        length = bound;
    }
    assert!(length > 1e-5, "{length}");
}

/// Drops that slide along the floor at 1 m/s.
fn drops(walls: &[Wall<2>]) -> Cloud<2, 3> {
    let mut cloud = block::<2, 3>([1.0, 1.0], [1, 1], 0.0);
    (cloud.cells, cloud.neighbours) = (Vec::new(), Vec::new());
    cloud.place.fill([0.055, 0.0]);
    cloud.velocity.fill([1.0, 0.0]);
    cloud.drop.fill(1e-6);
    touch(&mut cloud, walls);
    cloud
}

#[test]
fn a_drop_that_slides_off_a_shelf_falls() {
    let shelf = patches::<2>(&[[[0.0, 0.0], [0.1, 0.0]]]).remove(0);
    let walls = [Wall::new("shelf", Shape::Patch(shelf), Grip::Slip)];
    let mut cloud = drops(&walls);
    let mut heights = Vec::new();
    advance(&mut flow(WATER, 1e-6), &mut cloud, &walls, &gravity(), 0.01, 0..8, |cloud, _| {
        heights.push(cloud.place[0][1]);
    });
    assert!(heights[..5].iter().all(|height| height.abs() < 1e-15), "{heights:?}");
    // Free from the end of the step on in which it passes the edge.
    assert!((heights[7] + 0.5 * G * 0.03 * 0.03).abs() < 1e-12, "{heights:?}");
    assert!((cloud.place[0][0] - 0.135).abs() < 1e-12 && cloud.contacts[0].is_empty());
}

#[test]
fn a_drop_that_slides_into_a_corner_rests_in_it() {
    // The floor ends where the face of a block stands on it; the floor behind the block is another.
    let corners = [[0.0, 0.0], [0.1, 0.0], [0.1, 0.05], [0.12, 0.05], [0.12, 0.0], [0.2, 0.0]];
    let ground = patches::<2>(&corners.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>());
    let walls: Vec<Wall<2>> =
        ground.into_iter().map(|patch| Wall::new("ground", Shape::Patch(patch), Grip::Slip)).collect();
    let mut cloud = drops(&walls);
    advance(&mut flow(WATER, 1e-6), &mut cloud, &walls, &gravity(), 0.01, 0..8, |_, _| ());
    for (x, v) in cloud.place.iter().zip(&cloud.velocity) {
        assert!((x[0] - 0.1).abs() < 1e-15 && x[1].abs() < 1e-15 && *v == [0.0; 2], "{x:?} {v:?}");
    }
}

#[test]
fn a_drop_that_runs_along_a_floor_that_grips_is_dragged_as_a_film_of_its_size() {
    let floor = Plane { point: [0.0; 2], normal: [0.0, 1.0] };
    let walls = [Wall::new("floor", Shape::Plane(floor), Grip::NoSlip)];
    let mut cloud = drops(&walls);
    // r = 3μ/(ρd²) = 3 1/s.
    advance(&mut flow(WATER, 1e-6), &mut cloud, &walls, &gravity(), 0.001, 0..500, |_, _| ());
    let expected = 1.003f64.powi(-500);
    for (x, v) in cloud.place.iter().zip(&cloud.velocity) {
        assert!((v[0] - expected).abs() < 1e-12 && v[1] == 0.0 && x[1].abs() < 1e-15, "{x:?} {v:?}");
    }
}

#[test]
fn a_drop_that_leaves_a_wall_that_grips_takes_all_of_its_momentum_along() {
    let floor = Plane { point: [0.0; 2], normal: [0.0, 1.0] };
    for grip in [Grip::NoSlip, Grip::WallFunction] {
        let walls = [Wall::new("floor", Shape::Plane(floor), grip)];
        let mut cloud = drops(&walls);
        cloud.velocity.fill([1.0, 0.5]);
        advance(&mut flow(WATER, 1e-6), &mut cloud, &walls, &gravity(), 0.01, 0..1, |_, _| ());
        for (v, contacts) in cloud.velocity.iter().zip(&cloud.contacts) {
            assert!(v[0] == 1.0 && (v[1] - 0.5 + 0.01 * G).abs() < 1e-15 && contacts.is_empty(), "{v:?}");
        }
    }
}

#[test]
fn a_sheet_holds_fluid_on_one_side_and_what_comes_round_its_end_is_no_fluid_of_it() {
    let sheet = patches::<2>(&[[[0.0, 1.0], [0.0, 0.0]]]).remove(0);
    let walls = [Wall::new("sheet", Shape::Patch(sheet), Grip::Slip)];
    let mut cloud = drops(&walls);
    cloud.place.fill([-0.3, 1.1]);
    cloud.velocity.fill([0.0; 2]);
    advance(&mut flow(WATER, 1e-6), &mut cloud, &walls, &gravity(), 0.01, 0..30, |_, _| ());
    for (x, contacts) in cloud.place.iter().zip(&cloud.contacts) {
        assert!(x[0] == -0.3 && (x[1] - 1.1 + 0.5 * G * 0.09).abs() < 1e-12, "a drop falls past it: {x:?}");
        assert!(contacts.is_empty());
    }
    // Cells there would hang together with those in front of it.
    let mut cloud = block::<2, 3>([0.1, 0.1], [2, 2], 0.0);
    cloud.place.iter_mut().for_each(|x| *x = [x[0] - 0.3, x[1] + 1.01]);
    let (mut flow, mut time) = (flow(WATER, 1e-6), 0.0);
    let fault = loop {
        let step = Step { time, length: 0.01 };
        match flow.solve(&cloud, &walls, step, &gravity()) {
            Ok(solution) => solution.advance(&mut cloud, step),
            Err(fault) => break fault,
        }
        time += step.length;
    };
    assert!(matches!(&fault, FlowFault::RoundEnd { wall, .. } if wall == "sheet"), "{fault}");
    assert!(fault.to_string().contains("give the wall a thickness"), "{fault}");
}
