#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use std::f64::consts::TAU;

use crate::assembly::{Assembly, Sphere, cement};
use dem_solver::Vector;
use dem_solver::bond::{Beam, Bond, BondLaw, Moved, Profile};
use nalgebra::Rotation3;

/// A bond that is stretched, sheared, bent and twisted, of unlike grains.
fn loaded() -> (Bond, Beam) {
    let ends = [1e-3, 2e-3].map(|radius| Sphere::at([0.0; 3], radius).end());
    let length = 3e-3;
    let beam = Beam::new(&cement(), ends, length, Profile::Round);
    let mut bond = Bond::new([0, 1], 0, Vector::from([length, 0.0, 0.0]));
    let strain = Moved {
        separation: Vector::from([1.002 * length, 1e-3 * length, 0.0]),
        turns: [Vector::from([1e-3, 2e-3, 0.0]), Vector::from([0.0, 0.0, 5e-4])],
        time: 1e-6,
    };
    bond.pull(&cement(), &beam, &strain).unwrap();
    (bond, beam)
}

#[test]
fn a_turn_of_the_whole_leaves_what_a_loaded_bond_carries_as_it_was() {
    let (mut worst_size, mut worst_rounding) = (0.0_f64, 0.0_f64);
    for steps in [7, 360, 10_000] {
        for axis in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.48, 0.64, 0.6]] {
            let (mut bond, beam) = loaded();
            let start = bond;
            let turn = Vector::from(axis) * (TAU / f64::from(steps));
            for step in 1..=steps {
                let whole = Rotation3::new(turn * f64::from(step));
                let moved = Moved { separation: whole * start.separation, turns: [turn; 2], time: 1e-6 };
                let action = bond.pull(&cement(), &beam, &moved).unwrap();
                let force = (start.shear.norm_squared() + start.resultants(&beam).tension.powi(2)).sqrt();
                worst_size = worst_size.max((action.force.norm() / force - 1.0).abs());
                // Each step rounds the strains, which are of order 1e-3, by the spacing of numbers near 1.
                let rounding = f64::from(steps) * f64::EPSILON / 1e-3;
                worst_rounding = worst_rounding
                    .max((bond.shear - whole * start.shear).norm() / start.shear.norm() / rounding)
                    .max((bond.moment - whole * start.moment).norm() / start.moment.norm() / rounding);
            }
        }
    }
    println!(
        "a turn of 360°: force {worst_size:.1e} [1e-10], shear force and moments {worst_rounding:.1} roundings"
    );
    assert!(worst_size < 1e-10, "{worst_size}");
    assert!(worst_rounding < 2.0, "{worst_rounding}");
}

#[test]
fn a_pair_that_spins_freely_is_stretched_by_its_inertia_and_by_nothing_else() {
    let (radius, spin) = (1e-3, 200.0);
    let mut pair = Assembly::new(
        BondLaw::ParallelBond(cement()),
        vec![Sphere::at([-radius, 0.0, 0.0], radius), Sphere::at([radius, 0.0, 0.0], radius)],
    );
    // Its rest length, stretched by the load that the rotation asks for: k (d - d₀) = m ω² d/2.
    let k = pair.links.beams()[0].stiffness.normal;
    let sphere = pair.spheres.0[0];
    let distance = 2.0 * radius / (1.0 - 0.5 * sphere.mass() * spin * spin / k);
    for (sphere, side) in pair.spheres.0.iter_mut().zip([-0.5, 0.5]) {
        sphere.centre.x = side * distance;
        sphere.velocity.y = side * distance * spin;
        sphere.spin.z = spin;
    }
    let step = 0.05 * pair.critical_step();
    let turns = 5.0;
    let expected = 0.5 * sphere.mass() * spin * spin * distance;
    let (mut worst, mut across) = (0.0_f64, 0.0_f64);
    for _ in 0..(turns * TAU / spin / step) as usize {
        pair.step_alone(step);
        let bond = pair.bonds.iter().next().unwrap();
        worst = worst.max((bond.resultants(&pair.links.beams()[0]).tension / expected - 1.0).abs());
        across = across.max(bond.shear.norm() / expected);
    }
    println!("a pair that spins: tension {worst:.1e}, shear {across:.1e}");
    assert!(worst < 0.02 && across < 1e-3, "{worst}, {across}");
}
