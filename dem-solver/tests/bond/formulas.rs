use std::f64::consts::PI;

use crate::assembly::{Sphere, cement};
use dem_solver::Vector;
use dem_solver::bond::{Action, Beam, Bond, Cohesive, Law, Moved, ParallelBond, Profile};

const RADIUS: f64 = 1e-3;
const LENGTH: f64 = 2e-3;

fn x(length: f64) -> Vector<3> {
    Vector::from([length, 0.0, 0.0])
}

fn y(length: f64) -> Vector<3> {
    Vector::from([0.0, length, 0.0])
}

/// A lone bond along x.
fn bond(law: &dyn Law, profile: Profile) -> (Bond, Beam) {
    let end = Sphere::at([0.0; 3], RADIUS).end();
    (Bond::new([0, 1], 0, x(LENGTH)), Beam::new(law, [end, end], LENGTH, profile))
}

fn pull(law: &dyn Law, profile: Profile, separation: Vector<3>, turns: [Vector<3>; 2]) -> (Action, f64) {
    let (mut bond, beam) = bond(law, profile);
    let action = bond.pull(law, &beam, &Moved { separation, turns, time: 1e-6 }).unwrap();
    (action, bond.stored_energy(&beam))
}

fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} instead of {expected}");
}

/// A, I and J of both kinds of bonds of the radius of its grains.
fn sections() -> [(Profile, f64, f64, f64); 2] {
    let depth = 0.01;
    [
        (Profile::Round, PI * RADIUS.powi(2), PI / 4.0 * RADIUS.powi(4), PI / 2.0 * RADIUS.powi(4)),
        (Profile::Strip { depth }, 2.0 * RADIUS * depth, 2.0 / 3.0 * RADIUS.powi(3) * depth, 0.0),
    ]
}

#[test]
fn stretching_takes_the_force_of_a_bar() {
    for (profile, area, ..) in sections() {
        for stretch in [1e-3, -1e-3] {
            let (action, energy) =
                pull(&cement(), profile, x(LENGTH * (1.0 + stretch)), [Vector::<3>::zeros(); 2]);
            let force = 1e9 * area * stretch;
            assert_near(action.force.x, force, 1e-12);
            assert_eq!((action.force.y, action.torques), (0.0, [Vector::<3>::zeros(); 2]));
            assert_near(energy, 0.5 * force * stretch * LENGTH, 1e-12);
        }
    }
}

#[test]
fn shearing_takes_the_force_of_a_bar_and_turns_both_grains_with_half_of_its_moment() {
    let strain = 1e-6;
    for (profile, area, ..) in sections() {
        let (action, energy) =
            pull(&cement(), profile, x(LENGTH) + y(strain * LENGTH), [Vector::<3>::zeros(); 2]);
        let force = 1e9 / 2.5 * area * strain;
        assert_near(action.force.y, force, 1e-11);
        for torque in action.torques {
            assert_near(torque.z, force * LENGTH / 2.0, 1e-11);
        }
        assert_near(energy, 0.5 * force * strain * LENGTH, 1e-11);
    }
}

#[test]
fn unlike_grains_that_roll_on_each_other_as_gears_shear_nothing() {
    let radii = [1e-3, 3e-3];
    let beam =
        Beam::new(&cement(), radii.map(|radius| Sphere::at([0.0; 3], radius).end()), 4e-3, Profile::Round);
    let mut bond = Bond::new([0, 1], 0, x(4e-3));
    let turns = [3e-6, -1e-6].map(|angle| Vector::from([0.0, 0.0, angle]));
    let action = bond.pull(&cement(), &beam, &Moved { separation: x(4e-3), turns, time: 1e-6 }).unwrap();
    let of_one_alone = beam.stiffness.shear * radii[0] * 3e-6;
    assert!(action.force.norm() < 1e-9 * of_one_alone, "{}", action.force);
    assert!(action.torques[0].z < 0.0, "but they bend the bond");
}

#[test]
fn bending_takes_the_moment_of_a_beam() {
    let angle = 1e-3;
    let turns = [0.5, -0.5].map(|part| Vector::from([0.0, 0.0, part * angle]));
    for (profile, _, second_moment, _) in sections() {
        let (action, energy) = pull(&cement(), profile, x(LENGTH), turns);
        let moment = 1e9 * second_moment / LENGTH * angle;
        assert_near(action.torques[0].z, -moment, 1e-12);
        assert_near(action.torques[1].z, moment, 1e-12);
        assert!(action.force.norm() < 1e-12 * moment / LENGTH);
        assert_near(energy, 0.5 * moment * angle, 1e-12);
    }
}

#[test]
fn twisting_takes_the_moment_of_a_shaft() {
    let angle = 1e-3;
    for (profile, _, _, polar_moment) in sections() {
        let (action, energy) = pull(&cement(), profile, x(LENGTH), [x(angle), Vector::zeros()]);
        let moment = 1e9 / 2.5 * polar_moment / LENGTH * angle;
        assert_near(action.torques[0].x, -moment, 1e-12);
        assert_near(action.torques[1].x, moment, 1e-12);
        assert_near(energy, 0.5 * moment * angle, 1e-12);
    }
}

#[test]
fn cement_thinner_than_its_grains_is_softer() {
    let thin = ParallelBond { radius_multiplier: 0.5, ..cement() };
    let [of_thin, of_thick] = [thin, cement()].map(|law| bond(&law, Profile::Round).1.stiffness);
    assert_near(of_thin.normal, of_thick.normal / 4.0, 1e-15);
    assert_near(of_thin.bending, of_thick.bending / 16.0, 1e-15);
}

#[test]
fn the_papers_springs_have_their_stiffness_in_tension_and_compression_and_bear_no_moment() {
    let law = Cohesive {
        modulus: 1e9,
        poissons_ratio: 0.25,
        area_factor: 0.9,
        tensile_strength: f64::INFINITY,
        shear_strength: f64::INFINITY,
        internal_friction: 0.0,
        damping_ratio: 0.0,
    };
    let ends = [1e-3, 3e-3].map(|radius| Sphere::at([0.0; 3], radius).end());
    let length = 4e-3;
    let beam = Beam::new(&law, ends, length, Profile::Round);
    // r_c = 2·1·3/(1 + 3) mm.
    let normal = 1e9 * 0.9 * PI * 1.5e-3_f64.powi(2) / length;
    for stretch in [1e-6, -1e-6] {
        let mut bond = Bond::new([0, 1], 0, x(length));
        let moved = Moved { separation: x(length + stretch), turns: [x(0.1), y(0.0)], time: 1e-6 };
        let action = bond.pull(&law, &beam, &moved).unwrap();
        assert_near(action.force.x, normal * stretch, 1e-12);
        assert_eq!(action.torques, [Vector::<3>::zeros(); 2]);
    }
    assert_near(beam.stiffness.shear, normal / 2.5, 1e-15);
}

#[test]
fn each_motion_of_a_lone_pair_is_damped_by_the_stated_ratio() {
    let law = ParallelBond { damping_ratio: 0.2, ..cement() };
    let (_, beam) = bond(&law, Profile::Round);
    let sphere = Sphere::at([0.0; 3], RADIUS);
    let (mass, inertia) = (sphere.mass() / 2.0, sphere.inertia() / 2.0);
    let ratio = |c: f64, k: f64, m: f64| c / (2.0 * (k * m).sqrt());
    assert_near(ratio(beam.damping.normal, beam.stiffness.normal, mass), 0.2, 1e-15);
    assert_near(ratio(beam.damping.bending, beam.stiffness.bending, inertia), 0.2, 1e-15);
    assert_near(ratio(beam.damping.twisting, beam.stiffness.twisting, inertia), 0.2, 1e-15);
    // 1/m_s = 1/m* + r²/I*: a sphere rolls 3.5 times as easily as it slides.
    assert_near(ratio(beam.damping.shear, beam.stiffness.shear, mass / 3.5), 0.2, 1e-14);
}
