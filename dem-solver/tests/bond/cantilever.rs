#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use std::f64::consts::PI;

use crate::assembly::{Assembly, DENSITY, cement, row};
use dem_solver::Vector;
use dem_solver::bond::{BondLaw, Failure, ParallelBond};

const RADIUS: f64 = 1e-3;
const BONDS: usize = 20;
const LENGTH: f64 = 2.0 * RADIUS * BONDS as f64;

fn beam(law: ParallelBond) -> Assembly {
    let mut spheres = row(BONDS + 1, RADIUS);
    spheres[0].fixed = true;
    Assembly::new(BondLaw::ParallelBond(law), spheres)
}

/// E I and E A/κ.
fn rigidity(law: &ParallelBond) -> (f64, f64) {
    let radius = law.radius_multiplier * RADIUS;
    let (area, second_moment) = (PI * radius.powi(2), PI / 4.0 * radius.powi(4));
    (law.modulus * second_moment, law.modulus * area / law.stiffness_ratio)
}

/// Loads the tip, slowly, and waits, or until a bond breaks; returns how far it moved, and how many bonds broke.
fn load_tip(beam: &mut Assembly, law: &ParallelBond, force: Vector<3>) -> (Vector<3>, usize) {
    let step = 0.5 * beam.critical_step();
    // Slowest swing of a beam of 2/3 of the spheres' density: they fill so much of a cylinder.
    let inertia = 2.0 / 3.0 * DENSITY * PI * RADIUS * RADIUS;
    let slowest = 3.516 * (rigidity(law).0 / inertia).sqrt() / LENGTH.powi(2);
    let steps = (40.0 / slowest / step) as usize;
    let start = beam.spheres.0[BONDS].centre;
    let (mut broke, mut k) = (0, 0);
    while k < steps && broke == 0 {
        let ramp = 0.5 - 0.5 * (PI * (2.0 * k as f64 / steps as f64).min(1.0)).cos();
        let push = |row: usize| if row == BONDS { force * ramp } else { Vector::zeros() };
        broke = beam.step(step, push, 2.0 * slowest);
        k += 1;
    }
    (beam.spheres.0[BONDS].centre - start, broke)
}

#[test]
fn a_cantilever_of_grains_bends_as_a_timoshenko_beam() {
    let direction = Vector::from([0.0, 0.6, 0.8]);
    for law in [cement(), ParallelBond { radius_multiplier: 0.6, ..cement() }] {
        let (bending, shearing) = rigidity(&law);
        let bernoulli = LENGTH.powi(3) / (3.0 * bending);
        let timoshenko = bernoulli + LENGTH / shearing;
        let force = 1e-5 * LENGTH / timoshenko;
        let (moved, broke) = load_tip(&mut beam(law), &law, direction * force);
        let bent = moved.dot(&direction);
        assert_eq!(broke, 0);
        let [of_bernoulli, of_timoshenko] = [bernoulli, timoshenko].map(|w| bent / (force * w) - 1.0);
        // Hinges at the middles of bonds: Σ (k - ½)² = n³/3 - n/12.
        let hinges = bernoulli * (1.0 - 0.25 / (BONDS * BONDS) as f64) + LENGTH / shearing;
        let of_hinges = bent / (force * hinges) - 1.0;
        println!(
            "cantilever of {BONDS} bonds, λ = {}: {of_bernoulli:+.1e} of Bernoulli's, {of_timoshenko:+.1e} of \
             Timoshenko's beam [1e-2], {of_hinges:+.1e} of the same hinges",
            law.radius_multiplier
        );
        assert!(of_timoshenko.abs() < 1e-2 && of_bernoulli.abs() < 1e-2, "{of_timoshenko}, {of_bernoulli}");
        assert!(of_hinges.abs() < 1e-5, "{of_hinges}");
        assert!((moved - direction * bent).norm() < 1e-4 * bent, "it bends where it is pushed");
    }
}

#[test]
fn a_cantilever_of_grains_breaks_at_its_root_under_the_load_of_beam_theory() {
    let law = ParallelBond { tensile_strength: 1e5, shear_strength: 1e9, ..cement() };
    let (bending, _) = rigidity(&law);
    // σ = M R̄/I with the arm from the middle of the first bond to the tip.
    let moment = law.tensile_strength * bending / law.modulus / RADIUS;
    let limit = moment / (LENGTH - RADIUS);
    let push = |part: f64| Vector::from([0.0, part * limit, 0.0]);
    let mut holds = beam(law);
    assert_eq!(load_tip(&mut holds, &law, push(0.995)).1, 0, "at 0.995 of the load it holds");
    let mut breaks = beam(law);
    assert_eq!(load_tip(&mut breaks, &law, push(1.005)).1, 1, "at 1.005 of the load one bond breaks");
    let broken: Vec<_> = breaks.bonds.iter().filter(|bond| bond.failure.is_some()).collect();
    assert_eq!((broken[0].grains, broken[0].failure), ([0, 1], Some(Failure::Tension)));
}
