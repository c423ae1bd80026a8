use std::f64::consts::TAU;

use crate::scenes::{GLASS, floor, glass, hertz, run, world};
use dem_solver::wall::{Facet, Motion, Wall, WallImpulse, Walls};
use dem_solver::{Grain, Saved, Scene, Spin, Vector, World};

const G: f64 = 9.81;

fn moving_floor(motion: Motion<3>) -> Walls<3> {
    Walls::new(vec![Wall::plane("floor", 0, [0.0; 3], [0.0, 0.0, 1.0]).moving(motion)])
}

fn scene(walls: Walls<3>) -> Scene<3> {
    Scene::<3>::new(glass(0.5, 0.4), hertz()).with_gravity([0.0, 0.0, -G]).with_walls(walls)
}

/// A drum of flat staves around the y axis, its end walls planes; it turns at `rate` rad/s.
fn drum(radius: f64, length: f64, staves: u32, rate: f64) -> Walls<3> {
    let motion = Motion::rotation([0.0; 3], [0.0, rate, 0.0]);
    let rim = |k: u32, y: f64| {
        let (sine, cosine) = (TAU * f64::from(k) / f64::from(staves)).sin_cos();
        [radius * sine, y, radius * cosine]
    };
    let stave = |k: u32| {
        let (a, b, c, d) = (rim(k, 0.0), rim(k + 1, 0.0), rim(k + 1, length), rim(k, length));
        [Facet::new([a, b, c]), Facet::new([a, c, d])]
    };
    Walls::new(vec![
        Wall::facets("drum", 0, (0..staves).flat_map(stave).collect()).moving(motion.clone()),
        Wall::plane("south", 0, [0.0; 3], [0.0, 1.0, 0.0]).moving(motion.clone()),
        Wall::plane("north", 0, [0.0, length, 0.0], [0.0, -1.0, 0.0]).moving(motion),
    ])
}

/// A bed of 1 mm grains in a drum of 20 mm.
fn bed(rate: f64) -> (Scene<3>, World<3>) {
    let scene = scene(drum(1e-2, 4.2e-3, 40, rate));
    let mut grains = Vec::new();
    for k in 0..180 {
        let [i, j, l] = [k % 10, k / 10 % 3, k / 30].map(f64::from);
        let at = [1.2e-3 * (i - 4.5), 0.8e-3 + 1.25e-3 * j, -5.5e-3 + 1.2e-3 * l + 1e-4 * (i + j)];
        grains.push(Grain::at(at, 5e-4));
    }
    let world = world(&scene, &grains);
    (scene, world)
}

#[test]
fn a_grain_on_a_rising_plane_gets_its_velocity() {
    let scene = scene(moving_floor(Motion::translation([0.0, 0.0, 0.3])));
    let mut world = world(&scene, &[Grain::at([0.0, 0.0, 1e-2], 1e-2)]);
    run(&scene, &mut world, 1.0, 50_000).unwrap();
    let (velocity, height) = (world.grains.motion[0].velocity.z, world.grains.place[0].centre.z);
    assert!((velocity - 0.3).abs() < 1e-6, "{velocity}");
    // Hertz: m g = 4/3 E* √r δ^(3/2).
    let stiffness = 4.0 / 3.0 * GLASS.youngs_modulus / (2.0 * (1.0 - GLASS.poissons_ratio.powi(2))) * 0.1;
    let overlap = (world.grains.mass[0] * G / stiffness).powf(2.0 / 3.0);
    assert!((height - (0.31 - overlap)).abs() < 1e-8, "{height}, pressed in by {overlap}");
}

#[test]
fn a_grain_on_a_belt_slips_at_mu_g_and_then_rolls_at_two_sevenths_of_its_speed() {
    // In the belt's frame it is thrown at -U and ends up rolling at -5/7 U.
    let (speed, radius) = (0.3, 1e-2);
    let scene = scene(moving_floor(Motion::translation([speed, 0.0, 0.0])));
    let mut world = world(&scene, &[Grain::at([0.0, 0.0, 0.99999 * radius], radius)]);
    run(&scene, &mut world, 5e-3, 1000).unwrap();
    let start = world.grains.motion[0].velocity.x;
    run(&scene, &mut world, 0.01, 2000).unwrap();
    let acceleration = (world.grains.motion[0].velocity.x - start) / 0.01;
    assert!((acceleration / (0.4 * G) - 1.0).abs() < 2e-2, "{acceleration}");
    run(&scene, &mut world, 0.3, 30_000).unwrap();
    let ratio = world.grains.motion[0].velocity.x / speed;
    assert!((ratio - 2.0 / 7.0).abs() < 1e-9, "{ratio}");
}

#[test]
fn grains_cannot_tell_a_moving_wall_from_their_own_motion() {
    // Thrown at a wall at rest, or hit by it: planes and triangles.
    let wall = |facets: bool, motion: Motion<3>| {
        let at = |i: i32, j: i32| [8e-3 * f64::from(i), 8e-3 * f64::from(j), 0.0];
        let tile = |i: i32, j: i32| {
            [
                Facet::new([at(i, j), at(i + 1, j), at(i + 1, j + 1)]),
                Facet::new([at(i, j), at(i + 1, j + 1), at(i, j + 1)]),
            ]
        };
        let tiles = (-9..9).flat_map(|i| (-9..9).flat_map(move |j| tile(i, j))).collect();
        let wall = if facets {
            Wall::facets("wall", 0, tiles)
        } else {
            Wall::plane("wall", 0, [0.0; 3], [0.0, 0.0, 1.0])
        };
        Walls::new(vec![wall.moving(motion)])
    };
    let speed = Vector::<3>::from([0.5, -0.2, 1.0]);
    let end = |walls: Walls<3>, velocity: [f64; 3]| {
        let scene = Scene::<3>::new(glass(0.6, 0.3), hertz()).with_walls(walls);
        let mut world = world(&scene, &[Grain::at([1e-3, 2e-3, 1.2e-2], 1e-2).moving(velocity)]);
        run(&scene, &mut world, 0.01, 4000).unwrap();
        world.grains.motion[0]
    };
    let thrown = end(wall(false, Motion::none()), (-speed).into());
    assert!(thrown.velocity.z > 0.5, "it was hit");
    for facets in [false, true] {
        let hit = end(wall(facets, Motion::translation(speed.into())), [0.0; 3]);
        assert!((hit.velocity - speed - thrown.velocity).norm() < 1e-9, "{:?} {:?}", hit, thrown);
        assert!((hit.angular_velocity - thrown.angular_velocity).norm() < 1e-6);
    }
}

#[test]
fn a_grain_on_an_oscillating_floor_goes_along_with_it() {
    // A (2πf)² below g: the grain never leaves the floor; f is a 23rd of the contact's own frequency.
    let (amplitude, frequency) = (1e-4, 5.0);
    let scene = scene(moving_floor(Motion::oscillation([0.0, 0.0, amplitude], frequency)));
    let mut world = world(&scene, &[Grain::at([0.0, 0.0, 1e-2], 1e-2)]);
    run(&scene, &mut world, 1.0, 100_000).unwrap();
    for _ in 0..20 {
        run(&scene, &mut world, 1e-2, 1000).unwrap();
        let floor = amplitude * (TAU * frequency * world.time).cos() * TAU * frequency;
        let off = world.grains.motion[0].velocity.z - floor;
        assert!(off.abs() < 5e-3 * TAU * frequency * amplitude, "{off} at {}", world.time);
    }
}

#[test]
fn walls_receive_what_grains_lose() {
    let (scene, mut world) = bed(6.0);
    let scene = Scene { gravity: Vector::zeros(), ..scene };
    world.grains.motion.iter_mut().enumerate().for_each(|(k, motion)| {
        let k = k as f64;
        motion.velocity = Vector::from([(k * 0.7).sin(), (k * 1.3).cos(), (k * 2.1).sin()]) * 0.5;
    });
    let moments = |world: &World<3>| -> (Vector<3>, Spin) {
        let grains = &world.grains;
        let spin = |k: usize| {
            let motion = &grains.motion[k];
            grains.place[k].centre.cross(&motion.velocity) * grains.mass[k]
                + motion.angular_velocity / motion.inverse_inertia
        };
        (dem_solver::momentum(world), (0..grains.len()).map(spin).sum())
    };
    let before = moments(&world);
    let mut booked = Vector::zeros();
    for _ in 0..10 {
        let ledger = run(&scene, &mut world, 2e-3, 100).unwrap();
        assert!(ledger.residual().norm() < 1e-13 * ledger.scale);
        booked += ledger.walls;
    }
    let after = moments(&world);
    let mut received = WallImpulse::zero();
    world.received.impulse.iter().for_each(|&wall| received += wall);
    let exchanged: f64 = world.received.impulse.iter().map(|wall| wall.linear.norm()).sum();
    assert!(exchanged > 1e-5, "they did collide: {exchanged} N s");
    assert!((received.linear + booked).norm() < 1e-13 * exchanged);
    assert!((received.linear + after.0 - before.0).norm() < 1e-12 * exchanged);
    let spun: f64 = world.received.impulse.iter().map(|wall| wall.angular.norm()).sum();
    assert!((received.angular + after.1 - before.1).norm() < 1e-12 * spun, "{spun}");
}

#[test]
fn the_torque_of_a_weight_is_its_lever() {
    let scene = scene(floor());
    let mut world = world(&scene, &[Grain::at([0.3, -0.1, 0.9999e-2], 1e-2)]);
    run(&scene, &mut world, 0.5, 20_000).unwrap();
    world.received.restart(world.time);
    run(&scene, &mut world, 0.1, 4000).unwrap();
    let (wall, weight) = (world.received.impulse[0], world.grains.mass[0] * G * 0.1);
    let expected = Vector::from([0.3, -0.1, 0.0]).cross(&Vector::from([0.0, 0.0, -weight]));
    assert!((wall.angular - expected).norm() < 1e-5 * expected.norm(), "{:?}", wall.angular);
    assert!(wall.about(&Vector::from([0.3, -0.1, 7.0])).norm() < 1e-5 * weight);
}

#[test]
fn a_rotating_drum_lifts_its_bed_by_the_torque_that_holds_it() {
    let (scene, mut world) = bed(4.0);
    run(&scene, &mut world, 0.5, 20_000).unwrap();
    world.received.restart(world.time);
    let (mut lever, mut windows) = (0.0, 0.0);
    for _ in 0..200 {
        run(&scene, &mut world, 5e-3, 200).unwrap();
        let grains = &world.grains;
        lever += (0..grains.len()).map(|k| grains.place[k].centre.x * grains.mass[k]).sum::<f64>();
        windows += 1.0;
    }
    let mass: f64 = world.grains.mass.iter().sum();
    let offset = lever / windows / mass;
    // ω along y turns the bottom, z < 0, towards -x: there the bed is held, and weighs on the drum about y.
    assert!(offset < -1e-3, "{offset}");
    // Over one second: the impulse is the mean.
    let torque: f64 = world.received.impulse.iter().map(|wall| wall.angular.y).sum();
    let held = offset * mass * G;
    assert!((torque / held - 1.0).abs() < 2e-2, "{torque} N m on the drum, {held} N m of weight");
    let weight: f64 = world.received.impulse.iter().map(|wall| wall.linear.z).sum();
    assert!((weight / (-mass * G) - 1.0).abs() < 1e-2, "{weight}");
}

#[test]
fn a_stale_list_would_be_seen_among_moving_walls() {
    let tilting = Motion::rotation([0.0, 0.0, -2e-2], [0.0, 3.0, 0.0]);
    let (scene, start) = bed(10.0);
    let tilt = Wall::plane("tilt", 0, [0.0, 0.0, -9e-3], [0.0, 0.0, 1.0]).moving(tilting);
    let facets = scene.walls.surfaces.iter().filter_map(|surface| match surface.shape {
        dem_solver::wall::Shape::Facet(facet) => Some(facet),
        _ => None,
    });
    let drum = Wall::facets("drum", 0, facets.collect()).moving(Motion {
        translation: Vector::from([0.0, 0.01, 0.02]),
        ..scene.walls.motions[0].clone().unwrap()
    });
    let end = Wall::plane("south", 0, [0.0; 3], [0.0, 1.0, 0.0])
        .moving(Motion::oscillation([0.0, 2e-4, 0.0], 30.0));
    let scene = scene.with_walls(Walls::new(vec![drum, tilt, end]));
    let (mut with_skin, mut anew) = (start.clone(), start);
    for _ in 0..3000 {
        anew.contacts.expire();
        run(&scene, &mut anew, 2e-5, 1).unwrap();
        run(&scene, &mut with_skin, 2e-5, 1).unwrap();
    }
    let built = with_skin.contacts.counters.walls;
    assert!((2..600).contains(&built), "{built} lists");
    assert!(anew.grains == with_skin.grains);
}

#[test]
fn in_motion_too_threads_restarts_and_repetitions_give_the_same_bits() {
    let (scene, mut start) = bed(5.0);
    run(&scene, &mut start, 0.1, 4000).unwrap();
    let path = std::env::temp_dir().join(format!("dem-solver-drum-{}.checkpoint", std::process::id()));
    start.write_checkpoint(&path).unwrap();
    let mut resumed = World::read_checkpoint(&path, &scene, vec![]).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(resumed == start);
    run(&scene, &mut resumed, 0.02, 800).unwrap();
    let mut saved = Saved::default();
    start.save(&mut saved);
    for threads in [1, 2, 4] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        start.restore(&saved);
        pool.install(|| run(&scene, &mut start, 0.02, 800).unwrap());
        assert!(start == resumed, "{threads} threads");
    }
}
