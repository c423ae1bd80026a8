use crate::scenes::{glass, hertz, kinetic_energy, run, world};
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Grain, Scene, Substep, World, critical_time_step, substeps};

#[test]
fn a_pile_comes_to_rest_and_the_floor_carries_its_weight() {
    let wall = |name: &str, point: [f64; 2], normal: [f64; 2]| Wall::plane(name, 0, point, normal);
    let walls = Walls::new(vec![
        wall("floor", [0.0, 0.0], [0.0, 1.0]),
        wall("west", [0.0, 0.0], [1.0, 0.0]),
        wall("east", [0.021, 0.0], [-1.0, 0.0]),
    ]);
    let scene = Scene::<2>::new(glass(0.3, 0.5), hertz()).with_gravity([0.0, -9.81]).with_walls(walls);
    let mut grains = Vec::new();
    for k in 0..80 {
        let (i, j) = (f64::from(k % 10), f64::from(k / 10));
        grains.push(Grain::at([1.05e-3 + 2.05e-3 * i + 1e-4 * (j % 3.0), 1.1e-3 + 2.05e-3 * j], 1e-3));
    }
    let mut world = world(&scene, &grains);
    let highest = |world: &World<2>| world.grains.place.iter().map(|p| p.centre.y).fold(0.0, f64::max);
    // As a run does it: half the critical step, found anew for every window.
    let settle = |world: &mut World<2>| {
        let critical = critical_time_step(&scene, world);
        run(&scene, world, 0.05, substeps(0.05, Substep::Fraction(0.5), &critical).unwrap()).unwrap()
    };
    (0..16).for_each(|_| drop(settle(&mut world)));
    let height = highest(&world);
    let ledger = settle(&mut world);
    assert!((highest(&world) - height).abs() < 1e-8, "the top sank by {} m", height - highest(&world));
    let speed = (2.0 * kinetic_energy(&world) / ledger.mass).sqrt();
    assert!(speed < 1e-7, "typical speed {speed} m/s");
    assert!((ledger.walls.y / -ledger.gravity.y - 1.0).abs() < 1e-5);
}
