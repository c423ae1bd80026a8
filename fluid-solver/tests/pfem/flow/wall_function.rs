//! Walls that rub as a turbulent layer does.

use crate::support::{WATER, advance, block, flow, newtonian, tank, touch};
use fluid_solver::backend::Step;
use fluid_solver::backend::pfem::flow::{Forces, wall_stress};
use fluid_solver::backend::pfem::wall::{Grip, Plane, Shape, Wall};
use fluid_solver::element::simplex::dot;
use surface::motion::Motion;

fn floor<const D: usize>() -> Wall<D> {
    let mut normal = [0.0; D];
    normal[D - 1] = 1.0;
    Wall::new("floor", Shape::Plane(Plane { point: [0.0; D], normal }), Grip::WallFunction)
}

/// No forces but those of the floor.
const fn nothing<const D: usize>() -> Forces<'static, D> {
    Forces { gravity: [0.0; D], grains: None }
}

/// A block on a grid of spacing 0.1 slides along a floor: what each node in the middle of it feels is the law's stress on its
/// share of the floor, for the layer half a cell thick that it is the mean of.
fn sliding<const D: usize, const N: usize>(speed: f64) {
    let mut cloud = block::<D, N>([0.5; D], [5; D], 0.0);
    cloud.velocity.iter_mut().for_each(|v| v[0] = speed);
    let walls = [floor()];
    touch(&mut cloud, &walls);
    let step = Step { time: 0.0, length: 1e-5 };
    let solution = flow(WATER, 1e-12).solve(&cloud, &walls, step, &nothing()).unwrap();
    let expected = wall_stress(WATER.density, 1e-3, 0.05, speed) * 0.1f64.powi(D as i32 - 1);
    let inside = |x: &[f64; D]| x[D - 1] == 0.0 && x[..D - 1].iter().all(|x| (0.05..0.45).contains(x));
    let felt = cloud.place.iter().zip(&solution.reaction).filter(|(x, _)| inside(x));
    let felt: Vec<f64> = felt.map(|(_, force)| -force[0]).collect();
    assert_eq!(felt.len(), 4usize.pow(D as u32 - 1));
    assert!(felt.iter().all(|force| (force / expected - 1.0).abs() < 1e-4), "{felt:?} against {expected}");
}

#[test]
fn a_floor_holds_a_block_that_slides_on_it_by_the_stress_of_the_law() {
    for speed in [1e-4, 0.1, 3.0] {
        sliding::<2, 3>(speed);
        sliding::<3, 4>(speed);
    }
}

#[test]
fn a_channel_loses_its_slip_as_the_cells_shrink() {
    let (half, length, viscosity, gravity) = (0.05, 0.6, 100.0, 1.0);
    // Largest error of the profile halfway down, relative to its largest speed. The ends hang on the rest: the walls are asked
    // how much they bear there.
    let error = |cells: usize| {
        let rows = 4 * cells;
        let mut cloud = block::<2, 3>([2.0 * half, length], [cells, rows], 0.2);
        let mut walls = tank([2.0 * half, length], Grip::WallFunction);
        walls.pop();
        touch(&mut cloud, &walls);
        let forces = Forces { gravity: [0.0, -gravity], grains: None };
        let fluid = newtonian(1000.0, viscosity);
        let mut driving = 0.0;
        advance(&mut flow(fluid, 1e-8), &mut cloud, &walls, &forces, 5e-3, 0..20, |cloud, solution| {
            let is_held = |node: &usize| {
                !cloud.contacts[*node].is_empty() && (0.2..0.4).contains(&cloud.place[*node][1])
            };
            let held: Vec<usize> = (0..cloud.place.len()).filter(is_held).collect();
            let shear: f64 = held.iter().map(|&node| solution.reaction[node][1]).sum();
            driving = shear / (held.len() as f64 * length / rows as f64 * half);
        });
        let largest = driving * half * half / (2.0 * viscosity);
        let exact = |x: f64| largest * (1.0 - ((x - half) / half).powi(2));
        let middle = cloud.place.iter().zip(&cloud.velocity).filter(|(x, _)| (x[1] - 0.3).abs() < 0.03);
        middle.map(|(x, v)| (-v[1] - exact(x[0])).abs()).fold(0.0, f64::max) / largest
    };
    let [coarse, middle, fine] = [10, 20, 40].map(error);
    println!("slip of a channel, 10, 20, 40 cells: {coarse:.4} {middle:.4} {fine:.4}");
    assert!(coarse < 0.12 && middle < 0.65 * coarse && fine < 0.65 * middle, "{coarse} {middle} {fine}");
}

/// Kinetic energy (J) at the end of a step.
fn energy<const D: usize>(mass: &[f64], velocity: &[[f64; D]]) -> f64 {
    mass.iter().zip(velocity).map(|(mass, v)| 0.5 * mass * dot(v, v)).sum()
}

#[test]
fn what_a_floor_at_rest_takes_of_the_energy_is_the_heat_of_its_friction() {
    let mut cloud = block::<2, 3>([0.2, 0.02], [20, 2], 0.2);
    cloud.velocity.fill([3.0, 0.0]);
    let walls = [floor()];
    touch(&mut cloud, &walls);
    // Nothing but the floor: the shear that it makes in the fluid is not to count.
    let smooth = newtonian(1000.0, 1e-9);
    let (start, mut heat, mut before) = (cloud.velocity.clone(), 0.0, None);
    advance(&mut flow(smooth, 1e-12), &mut cloud, &walls, &nothing(), 1e-4, 0..20, |cloud, solution| {
        let now = energy(&solution.mass, &cloud.velocity);
        let last = before.unwrap_or_else(|| energy(&solution.mass, &start));
        let work: f64 = solution.reaction.iter().zip(&solution.velocity).map(|(f, v)| dot(f, v)).sum();
        assert!(solution.friction > 0.0 && work <= 0.0 && now < last);
        heat += 1e-4 * solution.friction;
        before = Some(now);
    });
    let lost = 0.5 * 1000.0 * 0.2 * 0.02 * 9.0 - before.unwrap();
    println!("energy lost over the heat of friction − 1: {:.1e}", lost / heat - 1.0);
    assert!((lost / heat - 1.0).abs() < 1e-6, "{lost} J lost, {heat} J of heat");
}

#[test]
fn a_floor_that_moves_takes_the_fluid_along_and_never_past_it() {
    let mut cloud = block::<3, 4>([0.1, 0.1, 0.02], [5, 5, 1], 0.0);
    let walls = [floor::<3>().moving(Motion::translation([2.0, 0.0, 0.0]))];
    touch(&mut cloud, &walls);
    let honey = newtonian(1000.0, 40.0);
    // A step is four times what the layer on the floor takes to follow.
    advance(&mut flow(honey, 1e-10), &mut cloud, &walls, &nothing(), 5e-3, 0..5, |cloud, _| {
        assert!(cloud.velocity.iter().all(|v| v[0] > 0.0 && v[0] <= 2.0 + 1e-9), "{:?}", cloud.velocity);
    });
    assert!(cloud.velocity.iter().all(|v| v[0] > 1.0), "{:?}", cloud.velocity);
}
