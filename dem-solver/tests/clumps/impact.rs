#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::scenes::{RADIUS, body, dumbbell, floor, kinetic_energy, momenta, placed, run, scene};
use dem_solver::{Scene, Spin, World, critical_time_step};

const SPEED: f64 = 0.01;

/// A dumbbell, its axis raised by an angle \[rad\], that falls on the floor at [`SPEED`] and is out of touch again.
fn bounced(scene: &Scene<3>, angle: f64) -> World<3> {
    let mut world = World::new();
    let lowest = 0.6 * RADIUS * angle.sin() + RADIUS;
    let start = [0.0, 0.0, lowest + 1e-7];
    let falling = placed(&scene.clumps[0], start, [0.0, -angle, 0.0], [0.0, 0.0, -SPEED], [0.0; 3]);
    world.add_clump(scene, 0, falling);
    let step = 0.5 * critical_time_step(scene, &world).step.min(1e-6);
    let duration = 6e-5;
    run(scene, &mut world, duration, (duration / step).ceil() as u32);
    world
}

/// What the impact of a rigid body without friction leaves: M V' = J - M v, I ω' = -b J about y, with
/// J = (1 + e) v/(1/M + b²/I), b the lever of the normal.
fn impulse(scene: &Scene<3>, angle: f64, restitution: f64) -> (f64, f64) {
    let shape = &scene.clumps[0].shape;
    let (mass, moment, lever) = (shape.mass(), shape.moments()[2], 0.6 * RADIUS * angle.cos());
    let impulse = (1.0 + restitution) * SPEED / (1.0 / mass + lever * lever / moment);
    (impulse / mass - SPEED, lever * impulse / moment)
}

#[test]
fn an_eccentric_impact_leaves_velocity_and_spin_of_the_exact_impulse() {
    let scene = scene(1e11, (1.0, 0.0), vec![dumbbell()]).with_walls(floor());
    for degrees in [20.0_f64, 45.0, 70.0] {
        let angle = degrees.to_radians();
        let world = bounced(&scene, angle);
        let (velocity, spin) = impulse(&scene, angle, 1.0);
        let after = body(&world, 0);
        let turning = after.angular_velocity(&scene.clumps[0].shape);
        let off = (after.velocity.z - velocity).abs() / SPEED;
        let off_spin = (turning.norm() - spin).abs() / spin;
        println!("impact at {degrees} deg: velocity off by {off:.1e} of the speed, spin by {off_spin:.1e}");
        assert!(off < 1e-3 && off_spin < 1e-3, "{off} {off_spin}");
        assert!(turning.y.abs() > 0.999 * turning.norm(), "it turns about y alone");
    }
}

#[test]
fn an_elastic_impact_keeps_the_energy() {
    let scene = scene(1e11, (1.0, 0.0), vec![dumbbell()]).with_walls(floor());
    let world = bounced(&scene, 0.6);
    let before = 0.5 * scene.clumps[0].shape.mass() * SPEED * SPEED;
    let change = (kinetic_energy(&world) - before).abs() / before;
    println!("energy of an elastic eccentric impact: {change:.1e}");
    assert!(change < 1e-4);
}

#[test]
fn a_central_impact_keeps_to_the_restitution_of_the_whole_mass() {
    for restitution in [0.3, 0.8] {
        let scene = scene(1e11, (restitution, 0.3), vec![dumbbell()]).with_walls(floor());
        let world = bounced(&scene, std::f64::consts::FRAC_PI_2);
        let found = body(&world, 0).velocity.z / SPEED;
        assert!((found - restitution).abs() < 1e-3, "{found} for {restitution}");
    }
}

#[test]
fn friction_of_an_impact_gives_no_energy_and_what_it_takes_the_floor_feels() {
    let scene = scene(1e9, (0.6, 0.4), vec![dumbbell()]).with_walls(floor());
    let mut world = World::new();
    let falling =
        placed(&scene.clumps[0], [0.0, 0.0, 1.5e-3], [0.2, -0.5, 0.1], [0.3, 0.1, -0.2], [0.0, 90.0, 9.0]);
    world.add_clump(&scene, 0, falling);
    let (energy, (before, _)) = (kinetic_energy(&world), momenta(&world));
    let ledger = run(&scene, &mut world, 2e-3, 8000);
    assert!(kinetic_energy(&world) < 0.95 * energy);
    let received: Spin = ledger.wall_impulse[0].linear;
    let after = momenta(&world).0;
    assert!((after - before + received).norm() < 1e-12 * before.norm());
    assert!(ledger.residual().norm() < 1e-13 * ledger.scale);
}

#[test]
fn at_the_longest_allowed_step_a_clump_gains_no_energy_and_comes_to_rest() {
    let scene = scene(1e7, (0.7, 0.5), vec![dumbbell()]).with_walls(floor()).with_gravity([0.0, 0.0, -9.81]);
    let mut world = World::new();
    let start = [0.0, 0.0, 3e-3];
    world.add_clump(&scene, 0, placed(&scene.clumps[0], start, [0.2, -0.5, 0.1], [0.05, 0.0, 0.0], [0.0; 3]));
    let weight = scene.clumps[0].shape.mass() * 9.81;
    let energy = |world: &World<3>| kinetic_energy(world) + weight * body(world, 0).centre.z;
    let at_start = energy(&world);
    for _ in 0..300 {
        let step = critical_time_step(&scene, &world).step;
        run(&scene, &mut world, 2e-3, (2e-3 / step).ceil() as u32);
        assert!(energy(&world) <= at_start * (1.0 + 1e-12), "{} of the first", energy(&world) / at_start);
    }
    let fell = weight * 2e-3;
    println!(
        "kinetic energy after 0.6 s at the critical step: {:.1e} of the first fall",
        kinetic_energy(&world) / fell
    );
    // It rolls on: nothing resists that.
    assert!(
        body(&world, 0).velocity.z.abs() < 1e-3 && (body(&world, 0).centre.z / RADIUS - 1.0).abs() < 0.01
    );
}
