//! Walls that slide under a stated force.
#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::scenes::{GLASS, glass, hertz, run, world};
use dem_solver::wall::{Facet, Motion, Servo, Wall, Walls};
use dem_solver::{Binding, Grain, Saved, Scene, Vector, World, critical_time_step};

const G: f64 = 9.81;

/// A lid that pushes down.
fn servo(force: f64, mass: f64, largest_speed: f64) -> Servo<3> {
    Servo { direction: -Vector::z(), force, mass, largest_speed }
}

fn lid(height: f64, servo: Servo<3>) -> Wall<3> {
    Wall::plane("lid", 0, [0.0, 0.0, height], [0.0, 0.0, -1.0]).pushed(servo)
}

/// A bed of 1 mm grains in a box of 6 mm, under this lid.
fn bed(lid: Wall<3>) -> (Scene<3>, World<3>) {
    let side = 6e-3;
    let wall = |name: &str, point: [f64; 3], normal: [f64; 3]| Wall::plane(name, 0, point, normal);
    let walls = Walls::new(vec![
        lid,
        wall("floor", [0.0; 3], [0.0, 0.0, 1.0]),
        wall("west", [0.0; 3], [1.0, 0.0, 0.0]),
        wall("east", [side, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        wall("south", [0.0; 3], [0.0, 1.0, 0.0]),
        wall("north", [0.0, side, 0.0], [0.0, -1.0, 0.0]),
    ]);
    let scene = Scene::<3>::new(glass(0.3, 0.3), hertz()).with_gravity([0.0, 0.0, -G]).with_walls(walls);
    let grain = |k: u32| {
        let [i, j, l] = [k % 5, k / 5 % 5, k / 25].map(f64::from);
        let off = 1e-4 * (2.0 * i + 3.0 * j + 5.0 * l).sin();
        Grain::at([0.6e-3 + 1.15e-3 * i + off, 0.6e-3 + 1.15e-3 * j - off, 0.6e-3 + 1.1e-3 * l], 5e-4)
    };
    let grains: Vec<_> = (0..125).map(grain).collect();
    let world = world(&scene, &grains);
    (scene, world)
}

#[test]
fn a_lid_on_nothing_accelerates_by_force_over_mass_up_to_its_speed() {
    let scene = Scene::<3>::new(glass(0.5, 0.3), hertz())
        .with_walls(Walls::new(vec![lid(10.0, servo(2.0, 0.5, 1.0))]));
    let mut world = world(&scene, &[Grain::at([0.0; 3], 1e-3)]);
    run(&scene, &mut world, 0.2, 100).unwrap();
    let slide = world.slides[0];
    assert!((slide.velocity - 0.8).abs() < 1e-12 && (slide.displacement - 0.08).abs() < 1e-12, "{slide:?}");
    run(&scene, &mut world, 0.2, 100).unwrap();
    // 0.05 s to 1 m/s, then on at that.
    let slide = world.slides[0];
    assert_eq!(slide.velocity, 1.0);
    assert!((slide.displacement - (0.08 + 0.045 + 0.15)).abs() < 2e-5, "{slide:?}");
    let place = scene.walls.poses(world.time, &world.slides).of(0).unwrap().moved(&[0.0, 0.0, 10.0].into());
    assert!((place.z - (10.0 - slide.displacement)).abs() < 1e-14);
}

#[test]
fn a_lid_on_a_spring_swings_at_the_frequency_of_its_mass() {
    // A grain fixed in place, pressed: k = dF/dδ about the overlap of F, and ω = √(k/M).
    let (radius, force, mass) = (1e-2, 5.0, 2.0);
    let scene = Scene::<3>::new(glass(1.0, 0.0), hertz()).with_walls(Walls::new(vec![
        lid(2.0 * radius, servo(force, mass, 10.0)),
        Wall::plane("floor", 0, [0.0; 3], [0.0, 0.0, 1.0]),
    ]));
    let modulus = GLASS.youngs_modulus / (2.0 * (1.0 - GLASS.poissons_ratio.powi(2)));
    let hertz = 4.0 / 3.0 * modulus * radius.sqrt();
    let overlap = (force / hertz).powf(2.0 / 3.0);
    let mut world = world(&scene, &[Grain::at([0.0, 0.0, radius - overlap], radius)]);
    let gap = 1e-3 * overlap;
    world.slides = vec![Default::default(); 2];
    world.slides[0].displacement = 2.0 * overlap + gap;
    // The grain, of 10 g, follows between two equal springs of k = 3/2 F/δ each.
    let stiffness = 1.5 * force / overlap / 2.0;
    let period = std::f64::consts::TAU * (mass / stiffness).sqrt();
    run(&scene, &mut world, period, 20_000).unwrap();
    let off = (world.slides[0].displacement - 2.0 * overlap) / gap;
    assert!((off - 1.0).abs() < 1e-2, "{off}");
}

#[test]
fn a_bed_bears_the_stated_force() {
    let force = 2.0;
    let (scene, mut world) = bed(lid(6.5e-3, servo(force, 0.05, 0.2)));
    run(&scene, &mut world, 0.6, 60_000).unwrap();
    world.received.restart(world.time);
    run(&scene, &mut world, 0.05, 5000).unwrap();
    let on = |wall: usize| world.received.impulse[wall].linear.z / 0.05;
    assert!((on(0) / force - 1.0).abs() < 1e-3, "{} N on the lid", on(0));
    let weight: f64 = world.grains.mass.iter().sum::<f64>() * G;
    let carried: f64 = -(1..6).map(on).sum::<f64>();
    assert!((carried / (force + weight) - 1.0).abs() < 1e-3, "{carried} N of {} N", force + weight);
    assert!(
        world.slides[0].velocity.abs() < 1e-4 && world.slides[0].displacement > 5e-4,
        "{:?}",
        world.slides[0]
    );
    println!("lid: {:.2e} of the force off, {:.2e} m/s", on(0) / force - 1.0, world.slides[0].velocity);
}

#[test]
fn a_lid_of_triangles_keeps_the_force_while_it_shears() {
    let corner = |x: f64, y: f64| [x, y, 6.5e-3];
    let [a, b, c, d] = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    let lid = Wall::facets("lid", 0, vec![Facet::new([a, b, c]), Facet::new([a, c, d])])
        .moving(Motion::translation([0.02, 0.0, 0.0]))
        .pushed(servo(1.0, 0.05, 0.2));
    let (scene, mut world) = bed(lid);
    run(&scene, &mut world, 0.3, 30_000).unwrap();
    world.received.restart(world.time);
    run(&scene, &mut world, 0.4, 40_000).unwrap();
    let [x, _, z] = (world.received.impulse[0].linear / 0.4).into();
    assert!((z - 1.0).abs() < 1e-2, "{z} N");
    // It drags the bed, but by no more than friction can.
    assert!(x < -0.02 && x > -0.3 * z, "{x} N");
}

#[test]
fn sliding_too_threads_restarts_and_repetitions_give_the_same_bits() {
    let (scene, mut start) = bed(lid(6.5e-3, servo(1.0, 0.02, 0.2)));
    run(&scene, &mut start, 0.05, 5000).unwrap();
    let path = std::env::temp_dir().join(format!("dem-solver-servo-{}.checkpoint", std::process::id()));
    start.write_checkpoint(&path).unwrap();
    let mut resumed = World::read_checkpoint(&path, &scene, vec![]).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(resumed == start && start.slides[0].displacement > 0.0);
    run(&scene, &mut resumed, 0.02, 2000).unwrap();
    let mut saved = Saved::default();
    start.save(&mut saved);
    for threads in [1, 2, 4] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        start.restore(&saved);
        pool.install(|| run(&scene, &mut start, 0.02, 2000).unwrap());
        assert!(start == resumed, "{threads} threads");
    }
}

#[test]
fn a_stale_list_would_be_seen_under_a_sliding_lid() {
    let (scene, start) = bed(lid(7e-3, servo(0.5, 0.01, 0.5)));
    let (mut with_skin, mut anew) = (start.clone(), start);
    for _ in 0..3000 {
        anew.contacts.expire();
        run(&scene, &mut anew, 1e-5, 1).unwrap();
        run(&scene, &mut with_skin, 1e-5, 1).unwrap();
    }
    assert!(
        anew.grains == with_skin.grains && anew.slides[0].displacement == with_skin.slides[0].displacement
    );
    assert!(with_skin.slides[0].displacement > 1e-3);
}

#[test]
fn a_light_lid_sets_the_step() {
    let (scene, mut world) = bed(lid(5.49e-3, servo(0.5, 1e-7, 0.5)));
    run(&scene, &mut world, 2e-5, 20).unwrap();
    let critical = critical_time_step(&scene, &world);
    assert_eq!(critical.binding, Binding::Wall("lid".into()), "{critical:?}");
}
