//! Attraction with and without reach: necks of solid and bridges of liquid.
#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use std::f64::consts::PI;

use crate::determinism::collapse;
use crate::scenes::{GLASS, floor, glass, hertz, hooke, kinetic_energy, run, world};
use dem_solver::contact::Extras;
use dem_solver::contact::cohesion::{Bodies, CohesionLaw, Proximity};
use dem_solver::contact::normal::Normal;
use dem_solver::wall::{Facet, Shape, Wall, Walls};
use dem_solver::{Grain, Materials, PairMaterial, Scene, Vector, World, turn_over};

const RADIUS: f64 = 1e-3;
/// Of two equal spheres.
const EFFECTIVE: f64 = 0.5 * RADIUS;
/// Work of adhesion, surface tension \[J/m²\].
const ENERGY: f64 = 0.1;
const ANGLE: f64 = 0.3;
const RATIO: f64 = 0.02;

const LAWS: [CohesionLaw; 3] = [CohesionLaw::Dmt, CohesionLaw::Jkr, CohesionLaw::Capillary];

fn sticky(restitution: f64, friction: f64) -> Materials {
    glass(restitution, friction).with(|_, _, pair| {
        pair.work_of_adhesion = ENERGY;
        pair.surface_tension = ENERGY;
        pair.contact_angle = ANGLE;
        pair.bridge_volume_ratio = RATIO;
    })
}

fn scene(law: CohesionLaw, restitution: f64, friction: f64) -> Scene<3> {
    let extras = Extras { cohesion: Some(law), ..Extras::default() };
    Scene::new(sticky(restitution, friction), hertz()).with_extras(extras)
}

fn pair() -> PairMaterial {
    *sticky(1.0, 0.0).pair(0, 0)
}

/// Normal force of two spheres at rest \[N\], positive where they push, and what friction follows.
fn force(law: CohesionLaw, pair: &PairMaterial, overlap: f64, touched: bool) -> (f64, f64) {
    let (bodies, distance) = (Bodies::Spheres(RADIUS, RADIUS), 2.0 * RADIUS - overlap);
    let proximity = Proximity { bodies, distance, overlap, travel: 0.0 };
    let constants = law.constants(pair, EFFECTIVE, RADIUS);
    let hold = law.hold(&constants, &proximity, overlap > 0.0, &mut f64::from(u8::from(touched)));
    let push = 4.0 / 3.0 * pair.effective_modulus * EFFECTIVE.sqrt() * hold.indentation.powf(1.5);
    (push - hold.attraction, (push - hold.felt).abs())
}

#[test]
fn a_jkr_contact_has_the_force_of_its_radius_and_tears_at_its_golden_values() {
    let (pair, law) = (pair(), CohesionLaw::Jkr);
    let (modulus, w) = (pair.effective_modulus, ENERGY);
    let torn = (PI * w * EFFECTIVE.powi(2) / (8.0 * modulus)).cbrt();
    let pull_off = 1.5 * PI * w * EFFECTIVE;
    let mut least = f64::INFINITY;
    for k in 0..4000 {
        let a = torn * (1.0 + 1e-4 + 1e-3 * f64::from(k));
        let overlap = a * a / EFFECTIVE - (2.0 * PI * w * a / modulus).sqrt();
        let expected =
            4.0 * modulus * a.powi(3) / (3.0 * EFFECTIVE) - (8.0 * PI * w * modulus * a.powi(3)).sqrt();
        let (found, friction) = force(law, &pair, overlap, true);
        assert!((found - expected).abs() < 1e-9 * pull_off, "{found} N for {expected} N at a = {a}");
        assert!((friction - (expected + 2.0 * pull_off)).abs() < 1e-9 * pull_off);
        least = least.min(found);
    }
    assert!((least / -pull_off - 1.0).abs() < 1e-6, "pull-off {least} N");
    let reach = 0.75 * (PI * PI * w * w * EFFECTIVE / modulus.powi(2)).cbrt();
    let (at_last, _) = force(law, &pair, -reach * (1.0 - 1e-12), true);
    assert!((at_last / pull_off + 5.0 / 9.0).abs() < 1e-5, "torn at {at_last} N");
    assert_eq!(force(law, &pair, -reach * (1.0 + 1e-12), true), (0.0, 0.0));
    assert_eq!(force(law, &pair, -1e-9 * RADIUS, false), (0.0, 0.0), "untouched");
}

#[test]
fn without_work_of_adhesion_jkr_and_dmt_are_hertz() {
    let smooth = PairMaterial { work_of_adhesion: 0.0, ..pair() };
    let faint = PairMaterial { work_of_adhesion: 1e-14, ..pair() };
    for law in [CohesionLaw::Dmt, CohesionLaw::Jkr] {
        for overlap in [1e-9, 1e-7, 1e-5] {
            let push = 4.0 / 3.0 * smooth.effective_modulus * EFFECTIVE.sqrt() * f64::powf(overlap, 1.5);
            assert!((force(law, &smooth, overlap, true).0 / push - 1.0).abs() < 1e-12, "{law:?}");
            assert!((force(law, &faint, overlap, true).0 / push - 1.0).abs() < 1e-3, "{law:?}");
        }
        assert_eq!(force(law, &smooth, -1e-12, true).0, 0.0);
    }
}

#[test]
fn a_dmt_contact_pulls_with_2_pi_w_r_while_it_touches() {
    let pull = 2.0 * PI * ENERGY * EFFECTIVE;
    let (found, friction) = force(CohesionLaw::Dmt, &pair(), 1e-18, true);
    assert!((found / -pull - 1.0).abs() < 1e-6 && (friction / pull - 1.0).abs() < 1e-6);
    assert_eq!(force(CohesionLaw::Dmt, &pair(), -1e-18, true).0, 0.0);
}

#[test]
fn a_bridge_pulls_as_willett_has_it_until_it_ruptures() {
    let (law, pair) = (CohesionLaw::Capillary, pair());
    let volume = RATIO * RADIUS.powi(3);
    let most = 2.0 * PI * RADIUS * ENERGY * ANGLE.cos();
    assert!((force(law, &pair, 1e-18, true).0 / -most - 1.0).abs() < 1e-6);
    let gap = 0.1 * RADIUS;
    let scaled = gap * (RADIUS / volume).sqrt();
    let expected = -most / (1.0 + 1.05 * scaled + 2.5 * scaled * scaled);
    let (found, friction) = force(law, &pair, -gap, true);
    assert!((found / expected - 1.0).abs() < 1e-12 && friction == 0.0);
    let rupture = (1.0 + 0.5 * ANGLE) * volume.cbrt();
    assert!(force(law, &pair, -rupture * (1.0 - 1e-12), true).0 < 0.0);
    assert_eq!(force(law, &pair, -rupture * (1.0 + 1e-12), true).0, 0.0);
    assert_eq!(force(law, &pair, -1e-12, false).0, 0.0, "a bridge forms at touch");
}

#[test]
fn jkr_and_dmt_have_the_forces_of_lammps() {
    let material = dem_solver::Material { density: 2500.0, youngs_modulus: 1e7, poissons_ratio: 0.3 };
    let pair = PairMaterial { work_of_adhesion: 1.0, ..PairMaterial::new(&material, &material, 1.0, 0.5) };
    for (law, table) in [
        (CohesionLaw::Jkr, include_str!("../reference/lammps/force_jkr.csv")),
        (CohesionLaw::Dmt, include_str!("../reference/lammps/force_dmt.csv")),
    ] {
        let mut worst = 0.0_f64;
        for line in table.lines().skip(1) {
            let row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            let (found, _) = force(law, &pair, 2.0 * RADIUS - row[0], row[1] == 1.0);
            worst = worst.max((found + row[2]).abs());
        }
        println!("{law:?}: {worst:.1e} N of 1.3e-2 N");
        assert!(worst < 1e-9, "{law:?}: {worst} N");
    }
}

/// What tears a contact apart from δ = 0 on costs \[J\]: the area under the force from there to the end of the reach.
fn work_of_separation(law: CohesionLaw) -> f64 {
    let pair = pair();
    let reach = law.constants(&pair, EFFECTIVE, RADIUS).reach;
    match law {
        CohesionLaw::Jkr => {
            let strength = PI * ENERGY * EFFECTIVE;
            let integral = |x: f64| x.powi(10) / 10.0 - x.powi(7) + 1.5 * x.powi(4);
            2.0 / 9.0 * strength * reach * (integral(1.0) - integral(4.0_f64.cbrt()))
        }
        CohesionLaw::Capillary => {
            let length = (RATIO * RADIUS.powi(2)).sqrt();
            let most = 2.0 * PI * RADIUS * ENERGY * ANGLE.cos();
            // ∫ ds/(1 + b s + c s²) = 2/q atan((2 c s + b)/q), q² = 4 c - b².
            let q = (10.0 - 1.05_f64.powi(2)).sqrt();
            let integral = |s: f64| 2.0 / q * ((5.0 * s + 1.05) / q).atan();
            most * length * (integral(reach / length) - integral(0.0))
        }
        _ => 0.0,
    }
}

/// Two spheres that meet at this speed, and whether they part: their relative speed after `duration`.
fn meeting(scene: &Scene<3>, speed: f64, duration: f64, steps: u32) -> (World<3>, f64) {
    let half = |sign: f64| {
        Grain::at([sign * 1.0001 * RADIUS, 0.0, 0.0], RADIUS).moving([-0.5 * sign * speed, 0.0, 0.0])
    };
    let mut spheres = world(scene, &[half(-1.0), half(1.0)]);
    run(scene, &mut spheres, duration, steps).unwrap();
    let after = spheres.grains.motion[1].velocity.x - spheres.grains.motion[0].velocity.x;
    (spheres, after)
}

#[test]
fn elastic_spheres_lose_the_work_of_separation_and_stick_below_it() {
    let mass = GLASS.density * dem_solver::volume::<3>(RADIUS, 1.0);
    for law in [CohesionLaw::Jkr, CohesionLaw::Capillary] {
        let (scene, work) = (scene(law, 1.0, 0.0), work_of_separation(law));
        let stick = (2.0 * work / (0.5 * mass)).sqrt();
        let mut last = f64::INFINITY;
        for steps in [20_000, 80_000] {
            let speed = 2.0 * stick;
            let (_, after) = meeting(&scene, speed, 40e-3 * 0.05 / speed, steps);
            let lost = 0.25 * mass * (speed * speed - after * after);
            let error = (lost / work - 1.0).abs();
            println!("{law:?}, {steps} steps: {after} m/s of {speed}, work of separation off by {error:.1e}");
            last = error;
        }
        assert!(last < 2e-3, "{law:?}: {last}");
        let (held, _) = meeting(&scene, 0.98 * stick, 40e-3 * 0.05 / stick, 80_000);
        let gap = (held.grains.place[1].centre - held.grains.place[0].centre).norm() - 2.0 * RADIUS;
        assert!(gap < law.constants(&pair(), EFFECTIVE, RADIUS).reach, "{law:?}: they stick");
    }
}

#[test]
fn no_loading_cycle_gives_energy_back_that_was_not_put_in() {
    // Whatever the law, the speed and the place in a step where contact begins, elastic or damped.
    for law in LAWS {
        for restitution in [1.0, 0.7] {
            let scene = scene(law, restitution, 0.0);
            for k in 0..12 {
                let speed = 0.01 * 1.6_f64.powi(k);
                let (spheres, _) = meeting(&scene, speed, 2e-3 / speed.max(0.05), 20_000);
                let start = 0.25 * spheres.grains.mass[0] * speed * speed;
                let part = (spheres.grains.place[1].centre - spheres.grains.place[0].centre).norm()
                    > 2.0 * RADIUS + law.constants(&pair(), EFFECTIVE, RADIUS).reach;
                let gain = kinetic_energy(&spheres) / start - 1.0;
                assert!(!part || gain < 1e-3, "{law:?}, e {restitution}, {speed} m/s: gains {gain}");
            }
        }
    }
}

#[test]
fn a_sphere_hangs_from_the_ceiling_up_to_the_pull_off_force() {
    let ceiling = Walls::new(vec![Wall::plane("ceiling", 0, [0.0; 3], [0.0, 0.0, -1.0])]);
    let corner = |x: f64, y: f64| Vector::from([x, y, 0.0]);
    let triangle = Facet { vertices: [corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 2.0)] };
    let facet = Walls::new(vec![Wall::new("ceiling", 0, vec![Shape::Facet(triangle)])]);
    let mass = GLASS.density * dem_solver::volume::<3>(RADIUS, 1.0);
    for (law, pull_off) in [
        (CohesionLaw::Dmt, 2.0 * PI * ENERGY * RADIUS),
        (CohesionLaw::Jkr, 1.5 * PI * ENERGY * RADIUS),
        (CohesionLaw::Capillary, 4.0 * PI * ENERGY * ANGLE.cos() * RADIUS),
    ] {
        for walls in [&ceiling, &facet] {
            let mut scene = scene(law, 0.1, 0.5).with_walls(walls.clone());
            let mut ball = world(&scene, &[Grain::at([0.0, 0.0, -0.9999 * RADIUS], RADIUS)]);
            for share in [0.0, 0.5, 0.9, 0.97, 0.99] {
                scene.gravity.z = -share * pull_off / mass;
                run(&scene, &mut ball, 0.02, 4000).unwrap();
            }
            assert!(
                ball.grains.place[0].centre.z > -1.2 * RADIUS,
                "{law:?} holds 0.99 of its pull-off force"
            );
            scene.gravity.z = -1.01 * pull_off / mass;
            run(&scene, &mut ball, 0.06, 12_000).unwrap();
            assert!(ball.grains.place[0].centre.z < -1.5 * RADIUS, "{law:?} does not hold 1.01 of it");
        }
    }
}

#[test]
fn friction_follows_what_each_law_lets_it_feel() {
    // A sphere without weight is drawn along the floor: it slips at μ times that force.
    let friction = 0.3;
    for (law, felt) in [
        (CohesionLaw::Dmt, 4.0 * PI * ENERGY * RADIUS),
        (CohesionLaw::Jkr, 3.0 * PI * ENERGY * RADIUS),
        (CohesionLaw::Capillary, 4.0 * PI * ENERGY * ANGLE.cos() * RADIUS),
    ] {
        let mut scene = scene(law, 0.1, friction).with_walls(floor());
        let mut ball = world(&scene, &[Grain::at([0.0, 0.0, 0.9999 * RADIUS], RADIUS)]);
        run(&scene, &mut ball, 0.02, 4000).unwrap();
        let mass = ball.grains.mass[0];
        // A sphere drawn through its centre rolls up to 7/2 of what friction bears.
        scene.gravity.x = 7.0 * friction * felt / mass;
        run(&scene, &mut ball, 1e-3, 400).unwrap();
        let before = ball.grains.motion[0].velocity.x;
        run(&scene, &mut ball, 1e-3, 400).unwrap();
        let drag = scene.gravity.x * mass - mass * (ball.grains.motion[0].velocity.x - before) / 1e-3;
        assert!((drag / (friction * felt) - 1.0).abs() < 1e-2, "{law:?}: {drag} N for {} N", friction * felt);
    }
}

#[test]
fn a_stretched_bridge_stays_with_its_pair_when_rows_change_and_over_a_restart() {
    for law in [CohesionLaw::Jkr, CohesionLaw::Capillary] {
        for friction in [0.0, 0.4] {
            let (dry, mut world) = collapse(hertz());
            let mut scene = scene(law, 0.6, friction);
            (scene.walls, scene.gravity) = (dry.walls, dry.gravity);
            run(&scene, &mut world, 4e-3, 500).unwrap();
            let bridges = |world: &World<3>| -> usize {
                let listed = world.contacts.chunks.iter().map(|chunk| {
                    let springs = chunk.inner.all_springs().chain(chunk.planes.all_springs());
                    let walls = chunk.wall_contacts.iter().map(|contact| contact.spring.clone());
                    let remembered = chunk.remembered.iter().map(|entry| entry.spring.clone());
                    let planes = chunk.plane_springs.iter().map(|entry| entry.spring.clone());
                    let all = springs.chain(walls).chain(remembered).chain(planes);
                    all.filter(|history| history.spring.bridge > 0.0).count()
                });
                listed.sum()
            };
            let before = bridges(&world);
            assert!(before > 10, "{before} bridges");
            world.contacts.built_since_order = u32::MAX;
            assert!(turn_over(&scene, &mut world).unwrap().order_changed);
            assert_eq!(bridges(&world), before);
            let name = format!("dem-solver-bridges-{}.checkpoint", std::process::id());
            let path = std::env::temp_dir().join(name);
            world.write_checkpoint(&path).unwrap();
            let mut resumed = World::read_checkpoint(&path, &scene, vec![]).unwrap();
            std::fs::remove_file(&path).unwrap();
            assert!(resumed == world);
            run(&scene, &mut world, 2e-3, 250).unwrap();
            run(&scene, &mut resumed, 2e-3, 250).unwrap();
            assert!(resumed == world);
        }
    }
}

#[test]
fn the_skin_hides_no_bridge() {
    let (dry, start) = collapse(hertz());
    let mut scene = scene(CohesionLaw::Capillary, 0.6, 0.4);
    (scene.walls, scene.gravity) = (dry.walls, dry.gravity);
    let (mut with_skin, mut anew) = (start.clone(), start);
    for _ in 0..200 {
        anew.contacts.expire();
        run(&scene, &mut anew, 1e-5, 1).unwrap();
        run(&scene, &mut with_skin, 1e-5, 1).unwrap();
    }
    assert!(anew.grains == with_skin.grains);
}

#[test]
fn a_linear_contact_can_be_wet() {
    let mut wet = scene(CohesionLaw::Capillary, 0.3, 0.5);
    wet.normal_law = hooke();
    let (spheres, _) = meeting(&wet, 0.01, 0.1, 20_000);
    let distance = (spheres.grains.place[1].centre - spheres.grains.place[0].centre).norm();
    let law = dem_solver::contact::normal::Hooke { characteristic_velocity: 1.0, depth: 1.0 };
    let stiffness = Normal::<3>::coefficients(&law, &pair(), EFFECTIVE, 0.5 * spheres.grains.mass[0]);
    let expected = 2.0 * PI * RADIUS * ENERGY * ANGLE.cos() / stiffness.normal_stiffness;
    let overlap = 2.0 * RADIUS - distance;
    assert!((overlap / expected - 1.0).abs() < 1e-3, "{overlap} m for {expected} m");
}

#[test]
fn a_pair_at_rest_without_load_lies_where_the_forces_balance() {
    for (law, scaled) in [(CohesionLaw::Jkr, 9.0 / 2.0 * PI), (CohesionLaw::Dmt, 3.0 / 2.0 * PI)] {
        let (spheres, _) = meeting(&scene(law, 0.2, 0.5), 1e-3, 0.3, 60_000);
        let overlap = 2.0 * RADIUS - (spheres.grains.place[1].centre - spheres.grains.place[0].centre).norm();
        // JKR: a³ = 9 π w R*²/(2 E*), δ = a²/(3 R*). DMT: a³ = 3 π w R*²/(2 E*), δ = a²/R*.
        let area = (scaled * ENERGY * EFFECTIVE.powi(2) / pair().effective_modulus).cbrt().powi(2);
        let expected = area / EFFECTIVE / if law == CohesionLaw::Jkr { 3.0 } else { 1.0 };
        assert!((overlap / expected - 1.0).abs() < 1e-3, "{law:?}: {overlap} m for {expected} m");
    }
}
