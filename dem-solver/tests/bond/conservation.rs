#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::assembly::{Assembly, Sphere, between_touching, cement, cube, noise, noise3};
use dem_solver::Vector;
use dem_solver::bond::{BondLaw, ParallelBond};

/// A bonded block of unlike spheres, each in a motion of its own.
fn shaken(n: usize, damping_ratio: f64) -> Assembly {
    let mut spheres = cube(n, 1e-3);
    let bonds = between_touching(&spheres);
    for (k, sphere) in spheres.iter_mut().enumerate() {
        sphere.velocity = noise3(2 * k) * 0.1;
        sphere.spin = noise3(2 * k + 1) * 100.0;
        sphere.radius *= 1.0 + 0.3 * noise(k);
    }
    Assembly::bonded(BondLaw::ParallelBond(ParallelBond { damping_ratio, ..cement() }), spheres, bonds)
}

/// Momentum, angular momentum about the origin, and their scales.
fn momenta(block: &Assembly) -> [(Vector<3>, f64); 2] {
    let spheres = &block.spheres.0;
    let momentum = spheres.iter().map(|s| s.velocity * s.mass());
    let angular = spheres.iter().map(|s| s.centre.cross(&s.velocity) * s.mass() + s.spin * s.inertia());
    let scale = spheres.iter().map(|s| s.velocity.norm() * s.mass()).sum();
    let turning = spheres.iter().map(|s| (s.centre.norm() * s.velocity.norm()) * s.mass()).sum();
    [(momentum.sum(), scale), (angular.sum(), turning)]
}

#[test]
fn a_shaken_block_keeps_its_momentum_and_its_angular_momentum_to_rounding() {
    for damping_ratio in [0.0, 0.3] {
        let mut block = shaken(4, damping_ratio);
        let (before, energy) = (momenta(&block), block.kinetic_energy());
        let step = 0.3 * block.critical_step();
        (0..2000).for_each(|_| block.step_alone(step));
        let lost = 1.0 - (block.kinetic_energy() + block.stored_energy()) / energy;
        if damping_ratio > 0.0 {
            assert!(lost > 0.3, "the dashpots took {lost} of the energy");
        }
        for (((before, scale), (after, _)), what) in
            before.iter().zip(momenta(&block)).zip(["momentum", "angular momentum"])
        {
            let change = (after - before).norm() / scale;
            println!("{what} of a bonded block, ζ = {damping_ratio}: {change:.1e} [1e-13]");
            assert!(change < 1e-13, "{what}: {change}");
        }
    }
}

/// Largest deviation of the energy in some time, relative to what there is, for a fraction of the critical step.
fn energy_deviation(fraction: f64) -> f64 {
    let mut block = shaken(3, 0.0);
    let energy = block.kinetic_energy();
    let step = fraction * block.critical_step();
    let mut worst = 0.0_f64;
    for _ in 0..(400.0 / fraction) as usize {
        let before = block.spheres.0.clone();
        block.step_alone(step);
        // Bonds are stretched as in the middle of the step, where velocities are the mean of both ends.
        let middle = before.iter().zip(&block.spheres.0).map(|(before, after)| Sphere {
            velocity: (before.velocity + after.velocity) * 0.5,
            spin: (before.spin + after.spin) * 0.5,
            ..*after
        });
        let kinetic: f64 = middle.map(|sphere| sphere.kinetic_energy()).sum();
        worst = worst.max(((kinetic + block.stored_energy()) / energy - 1.0).abs());
    }
    worst
}

#[test]
fn without_dashpots_a_shaken_block_neither_gains_nor_loses_energy() {
    let [coarse, fine] = [0.2, 0.1].map(energy_deviation);
    println!("energy of a bonded block: {coarse:.1e} at 0.2 of the critical step, {fine:.1e} at 0.1");
    assert!(coarse < 0.01, "{coarse}");
    assert!((3.0..5.0).contains(&(coarse / fine)), "second order: {coarse}/{fine}");
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut block = shaken(12, 0.1);
            let step = 0.3 * block.critical_step();
            (0..20).for_each(|_| block.step_alone(step));
            (block.spheres.0, block.bonds)
        })
    };
    let one = run(1);
    assert!(one.1.len() > 2 * 1024, "more than two chunks");
    for threads in [2, 4] {
        assert!(run(threads) == one, "{threads} threads");
    }
}
