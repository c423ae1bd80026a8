use std::f64::consts::PI;

use crate::assembly::{Assembly, Sphere, cement, row};
use dem_solver::Vector;
use dem_solver::bond::{
    Beam, Bond, BondLaw, Bonds, Broken, Cohesive, Failure, Law, Moved, ParallelBond, Profile,
};

const RADIUS: f64 = 1e-3;
const LENGTH: f64 = 2e-3;

fn brittle() -> ParallelBond {
    ParallelBond { tensile_strength: 1e5, shear_strength: 5e4, ..cement() }
}

fn cohesive() -> Cohesive {
    Cohesive {
        modulus: 1e9,
        poissons_ratio: 0.25,
        area_factor: 1.0,
        tensile_strength: 1e5,
        shear_strength: 5e4,
        internal_friction: 0.5,
        damping_ratio: 0.0,
    }
}

/// How a lone bond breaks that is stretched, slid, bent and twisted by so much: per length, and in radian.
fn strain(law: &dyn Law, [stretch, slide, bend, twist]: [f64; 4]) -> Option<Failure> {
    let end = Sphere::at([0.0; 3], RADIUS).end();
    let beam = Beam::new(law, [end, end], LENGTH, Profile::Round);
    let mut bond = Bond::new([0, 1], 0, Vector::from([LENGTH, 0.0, 0.0]));
    // Both grains lean the same way: they slide past each other, the bond stays where it is.
    let lean = -slide;
    let moved = Moved {
        separation: Vector::from([LENGTH * (1.0 + stretch), 0.0, 0.0]),
        turns: [Vector::from([twist, 0.5 * bend, lean]), Vector::from([0.0, -0.5 * bend, lean])],
        time: 1e-6,
    };
    bond.pull(law, &beam, &moved).err()
}

/// The bond holds just below this strain and breaks just above it.
fn breaks_at(law: &dyn Law, strains: [f64; 4], how: Failure) {
    assert_eq!(strain(law, strains.map(|part| part * (1.0 - 1e-9))), None, "{strains:?}: holds");
    assert_eq!(strain(law, strains.map(|part| part * (1.0 + 1e-9))), Some(how), "{strains:?}: breaks");
}

#[test]
fn cement_breaks_under_the_stress_of_its_outermost_fibre() {
    let (modulus, shear_modulus) = (1e9, 1e9 / 2.5);
    let (tension, shear) = (1e5 / modulus, 5e4 / shear_modulus);
    // A turn θ over the length strains the outermost fibre by θ R̄/d.
    let per_turn = RADIUS / LENGTH;
    breaks_at(&brittle(), [tension, 0.0, 0.0, 0.0], Failure::Tension);
    breaks_at(&brittle(), [0.0, 0.0, tension / per_turn, 0.0], Failure::Tension);
    breaks_at(&brittle(), [0.4 * tension, 0.0, 0.6 * tension / per_turn, 0.0], Failure::Tension);
    breaks_at(&brittle(), [0.0, 0.0, 0.0, shear / per_turn], Failure::Shear);
    assert_eq!(strain(&brittle(), [-10.0 * tension, 0.0, 0.0, 0.0]), None, "it cannot be crushed");
}

#[test]
fn cement_is_sheared_off_at_its_strength() {
    let slide = (5e4 / (1e9 / 2.5_f64)).asin();
    breaks_at(&brittle(), [0.0, slide, 0.0, 0.0], Failure::Shear);
}

#[test]
fn compression_strengthens_the_papers_springs_by_their_friction() {
    let shear_modulus = 1e9 / 2.5;
    breaks_at(&cohesive(), [1e-4, 0.0, 0.0, 0.0], Failure::Tension);
    for pressure in [0.0, 1e5, 1e6] {
        // The springs slide by the length as it is now.
        let (stretch, strength) = (-pressure / 1e9, 5e4 + 0.5 * pressure);
        let slide = |part: f64| (part * strength / shear_modulus / (1.0 + stretch)).asin();
        assert_eq!(strain(&cohesive(), [stretch, slide(1.0 - 1e-9), 0.0, 0.0]), None);
        assert_eq!(strain(&cohesive(), [stretch, slide(1.0 + 1e-9), 0.0, 0.0]), Some(Failure::Shear));
    }
    assert_eq!(strain(&cohesive(), [-1e-2, 0.0, 0.0, 0.0]), None, "it cannot be crushed");
    for turn in [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]] {
        assert_eq!(strain(&cohesive(), turn), None, "it bears no moment");
    }
}

#[test]
fn a_broken_bond_pulls_no_more_and_is_counted_once() {
    let mut pair = Assembly::new(BondLaw::ParallelBond(brittle()), row(3, RADIUS));
    let strength = 1e5 * PI * RADIUS * RADIUS;
    let step = 0.1 * pair.critical_step();
    let pull = |row: usize| Vector::from([strength * [-1.2, 0.0, 0.1][row], 0.0, 0.0]);
    let broke: usize = (0..1000).map(|_| pair.step(step, pull, 0.0)).sum();
    assert_eq!(broke, 1);
    assert_eq!(pair.links.load(0), (Vector::<3>::zeros(), Vector::<3>::zeros()), "it flies alone");
    assert!(pair.links.load(2).0.norm() > 0.0, "the others hold");
    let swept = pair.bonds.sweep(|_| true);
    assert_eq!((swept.len(), swept[0].grains, swept[0].failure), (1, [0, 1], Some(Failure::Tension)));
    assert!(pair.bonds.sweep(|_| true).is_empty());
    assert_eq!(pair.bonds.broken(), Broken { tension: 1, shear: 0, orphaned: 0 });
    assert_eq!(pair.bonds.len(), 1);
}

#[test]
fn bonds_go_with_a_grain_that_is_removed() {
    let bond = |one, other| Bond::new([one, other], 0, Vector::from([1.0, 0.0, 0.0]));
    let mut bonds = Bonds::new(vec![bond(0, 1), bond(1, 2), bond(2, 3)]).unwrap();
    assert_eq!(bonds.sweep(|grain| grain != 1).len(), 2);
    assert_eq!(bonds.broken(), Broken { tension: 0, shear: 0, orphaned: 2 });
    assert_eq!(bonds.iter().next().unwrap().grains, [2, 3]);
}

#[test]
fn cement_acts_beside_the_contact_and_the_papers_springs_instead_of_it() {
    assert!(!brittle().replaces_contact());
    assert!(cohesive().replaces_contact());
}
