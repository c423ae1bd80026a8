#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::scenes::{dumbbell, gas, kinetic_energy, momenta, placed, run, scene, stone};
use dem_solver::World;

#[test]
fn two_clumps_that_collide_and_rub_keep_momentum_and_angular_momentum() {
    let scene = scene(1e7, (0.7, 0.4), vec![stone(), dumbbell()]);
    let mut world = World::new();
    let kinds = &scene.clumps;
    world.add_clump(
        &scene,
        0,
        placed(&kinds[0], [0.0; 3], [0.4, 0.2, 0.0], [0.5, 0.0, 0.1], [0.0, 200.0, 50.0]),
    );
    world.add_clump(
        &scene,
        1,
        placed(&kinds[1], [4.5e-3, 1e-3, 0.0], [0.0, 0.3, 0.7], [-0.5, 0.0, 0.0], [90.0, 0.0, 0.0]),
    );
    let (linear, angular) = momenta(&world);
    let energy = kinetic_energy(&world);
    run(&scene, &mut world, 0.01, 10_000);
    let (linear_after, angular_after) = momenta(&world);
    assert!(kinetic_energy(&world) < 0.95 * energy, "they met");
    let scale: f64 = world.bodies.as_slice().iter().map(|c| c.shape.mass() * c.body.velocity.norm()).sum();
    assert!((linear_after - linear).norm() < 1e-13 * scale);
    assert!(
        (angular_after - angular).norm() < 1e-12 * angular.norm(),
        "{}",
        (angular_after - angular).norm()
    );
}

#[test]
fn a_gas_of_clumps_keeps_its_momentum_and_without_losses_its_energy() {
    let (scene, mut world) = gas(1.0, 0.0);
    let (linear, _) = momenta(&world);
    let energy = kinetic_energy(&world);
    let scale: f64 = world.bodies.as_slice().iter().map(|c| c.shape.mass() * c.body.velocity.norm()).sum();
    for _ in 0..5 {
        dem_solver::turn_over(&scene, &mut world).unwrap();
        run(&scene, &mut world, 4e-3, 4000);
    }
    assert!((momenta(&world).0 - linear).norm() < 1e-12 * scale);
    let change = (kinetic_energy(&world) - energy).abs() / energy;
    println!("energy of an elastic gas of clumps after 20 ms: {change:.1e}");
    assert!(change < 0.02, "{change}: what contacts hold at the end is in it");
}

#[test]
fn members_of_one_clump_do_not_touch_each_other() {
    let scene = scene(1e7, (0.5, 0.3), vec![stone()]);
    let mut world = World::new();
    world.add_clump(&scene, 0, placed(&scene.clumps[0], [0.0; 3], [0.3, 0.1, 0.0], [0.0; 3], [0.0; 3]));
    run(&scene, &mut world, 0.01, 1000);
    let stone = crate::scenes::body(&world, 0);
    assert_eq!((stone.velocity.norm(), stone.angular_momentum.norm()), (0.0, 0.0));
    assert!(world.contacts.chunks.iter().all(|chunk| chunk.outer.i.is_empty()));
    assert!(dem_solver::insertion::overlaps(&scene, &world, 0.0).is_empty());
}
