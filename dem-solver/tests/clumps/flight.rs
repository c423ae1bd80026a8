#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::scenes::{body, kinetic_energy, placed, run, scene, stone};
use dem_solver::{Spin, World};

const SPIN: [f64; 3] = [40.0, 300.0, 25.0];

/// A stone thrown under gravity.
fn thrown() -> (dem_solver::Scene<3>, World<3>) {
    let scene = scene(1e7, (0.5, 0.3), vec![stone()]).with_gravity([0.0, 0.0, -9.81]);
    let mut world = World::new();
    let thrown = placed(&scene.clumps[0], [0.0; 3], [0.3, -1.0, 0.4], [0.5, 0.0, 1.0], SPIN);
    world.add_clump(&scene, 0, thrown);
    (scene, world)
}

#[test]
fn in_flight_angular_momentum_is_kept_to_the_last_bit_and_energy_to_the_order_of_the_step() {
    let (scene, mut world) = thrown();
    let before = body(&world, 0);
    let energy = kinetic_energy(&world);
    let ledger = run(&scene, &mut world, 0.1, 20_000);
    let after = body(&world, 0);
    assert_eq!(before.angular_momentum, after.angular_momentum);
    let fall = Spin::new(0.05, 0.0, 0.1 - 0.5 * 9.81 * 0.01);
    assert!((after.centre - fall).norm() < 1e-12, "{}", after.centre);
    let mass = scene.clumps[0].shape.mass();
    let change = kinetic_energy(&world) - energy + mass * 9.81 * after.centre.z;
    println!("energy of a thrown stone: {:.1e}", change.abs() / energy);
    assert!(change.abs() < 1e-6 * energy);
    assert!(ledger.residual().norm() < 1e-13 * ledger.scale);
    assert!((ledger.kinetic_energy - kinetic_energy(&world)).abs() < 1e-14 * energy);
}

#[test]
fn members_keep_their_distances_and_move_as_points_of_one_body() {
    let (scene, mut world) = thrown();
    let distances = |world: &World<3>| -> Vec<f64> {
        let places = &world.grains.place;
        (1..4).map(|k| (places[k].centre - places[0].centre).norm()).collect()
    };
    let before = distances(&world);
    run(&scene, &mut world, 0.1, 2000);
    for (one, other) in before.iter().zip(distances(&world)) {
        assert!((one - other).abs() < 1e-15 * 0.1, "{one} {other}");
    }
    let stone = body(&world, 0);
    for (place, motion) in world.grains.place.iter().zip(&world.grains.motion) {
        let arm = place.centre - stone.centre;
        let velocity = stone.velocity + motion.angular_velocity.cross(&arm);
        assert!((motion.velocity - velocity).norm() < 1e-12);
    }
}

/// Angular velocity in the body's own axes after a time \[s\] by Euler's equations I ω' = (I ω) × ω, by Runge & Kutta's
/// method in steps so fine that they are exact.
fn euler(moments: [f64; 3], start: Spin, time: f64) -> Spin {
    let inertia = Spin::from(moments);
    let rate = |w: Spin| inertia.component_mul(&w).cross(&w).component_div(&inertia);
    let steps = 20_000;
    let h = time / f64::from(steps);
    (0..steps).fold(start, |w, _| {
        let a = rate(w);
        let b = rate(w + a * (0.5 * h));
        let c = rate(w + b * (0.5 * h));
        let d = rate(w + c * h);
        w + (a + (b + c) * 2.0 + d) * (h / 6.0)
    })
}

#[test]
fn a_free_stone_turns_by_eulers_equations_to_second_order_in_the_step() {
    let time = 0.05;
    let error = |substeps: u32| {
        let (scene, mut world) = thrown();
        let in_body = |world: &World<3>| {
            let stone = body(world, 0);
            stone.orientation.inverse_transform_vector(&stone.angular_velocity(&scene.clumps[0].shape))
        };
        let exact = euler(scene.clumps[0].shape.moments(), in_body(&world), time);
        run(&scene, &mut world, time, substeps);
        (in_body(&world) - exact).norm() / exact.norm()
    };
    let errors = [200, 400, 800].map(error);
    println!(
        "asymmetric top in steps of 250, 125 and 62 us: {:.1e} {:.1e} {:.1e}",
        errors[0], errors[1], errors[2]
    );
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.05, "order {order}");
    }
    assert!(errors[2] < 1e-3);
}
