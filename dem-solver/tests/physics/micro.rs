//! Micro grains: no tangential force, no rotation.

use crate::scenes::{GLASS, hertz, kinetic_energy, run, world};
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Grain, Materials, Scene, Workspace, World, window};
use interface::HydroRow;

/// Micro grains (0) and others (1), under a law of friction 0.5.
fn scene() -> Scene<3> {
    let materials = Materials::new(vec![GLASS, GLASS], |_, _| (0.8, 0.5)).with_micro(|index| index == 0);
    Scene::new(materials, hertz())
}

fn other(grain: Grain<3>) -> Grain<3> {
    Grain { material: 1, ..grain }
}

#[test]
fn a_micro_grain_slides_on_a_wall_and_a_rough_one_beside_it_begins_to_roll() {
    let floor = Wall::plane("floor", 1, [0.0; 3], [0.0, 0.0, 1.0]);
    let scene = scene().with_walls(Walls::new(vec![floor]));
    let thrown =
        |x: f64| Grain::at([x, 0.0, 1.001e-3], 1e-3).moving([0.5, 0.2, -0.5]).spinning([9.0, 0.0, 0.0]);
    let mut world = world(&scene, &[thrown(0.0), other(thrown(0.1))]);
    run(&scene, &mut world, 2e-3, 2000).unwrap();
    let [micro, rough] = [&world.grains.motion[0], &world.grains.motion[1]];
    assert!(micro.velocity.z > 0.39 && rough.velocity.z > 0.39, "both have come back");
    assert_eq!((micro.velocity.x, micro.velocity.y), (0.5, 0.2));
    assert_eq!(micro.angular_velocity.norm(), 0.0, "it has no spin, not even that of its birth");
    assert!(rough.velocity.x < 0.45 && rough.angular_velocity.y > 10.0);
}

#[test]
fn between_a_micro_grain_and_another_the_force_is_along_the_line_of_centres() {
    let scene = scene();
    let grains = [
        Grain::at([-1.001e-3, 0.0, 0.0], 1e-3).moving([1.0, 0.0, 0.0]),
        other(Grain::at([1.001e-3, 0.5e-3, 0.0], 1e-3)).spinning([0.0, 0.0, 500.0]),
    ];
    let mut world = world(&scene, &grains);
    let before = kinetic_energy(&world);
    run(&scene, &mut world, 1e-3, 2000).unwrap();
    let rough = &world.grains.motion[1];
    assert_eq!(rough.angular_velocity.z, 500.0);
    assert!(rough.velocity.x > 0.3 && rough.velocity.y > 0.05);
    let line = rough.velocity.y / rough.velocity.x;
    assert!((line - 0.25).abs() < 0.03, "half a radius aside: {line}");
    assert!(kinetic_energy(&world) < before);
}

#[test]
fn a_torque_of_the_fluid_does_not_turn_a_micro_grain() {
    let scene = scene();
    let hydro = HydroRow { torque: [1e-9, 0.0, 2e-9], force: [0.0, 0.0, 1e-6], ..Default::default() };
    let grains = [Grain::at([0.0; 3], 1e-3), other(Grain::at([0.1, 0.0, 0.0], 1e-3))];
    let mut world = world(&scene, &grains);
    window(&scene, &mut world, &mut Workspace::new(), Some(&[hydro, hydro]), 1e-3, 10).unwrap();
    let [micro, rough] = [&world.grains.motion[0], &world.grains.motion[1]];
    assert_eq!(micro.angular_velocity.norm(), 0.0);
    assert!(rough.angular_velocity.z > 0.0 && micro.velocity.z > 0.0 && kinetic_energy(&world).is_finite());
}

#[test]
fn a_micro_grain_is_one_after_a_restart() {
    let scene = scene();
    let start = world(&scene, &[Grain::at([0.0; 3], 1e-3), other(Grain::at([0.1, 0.0, 0.0], 1e-3))]);
    let path = std::env::temp_dir().join(format!("dem-solver-micro-{}.checkpoint", std::process::id()));
    start.write_checkpoint(&path).unwrap();
    let resumed = World::read_checkpoint(&path, &scene, vec![]).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(resumed == start);
}
