use crate::assembly::{Assembly, cement, cube, noise3, row};
use dem_solver::bond::{BondLaw, ParallelBond};

/// Energy in the end over that of the start, after many steps of this fraction of the critical one.
fn growth(mut assembly: Assembly, fraction: f64) -> f64 {
    for (k, sphere) in assembly.spheres.0.iter_mut().enumerate() {
        sphere.velocity = noise3(k) * 1e-6;
    }
    let start = assembly.kinetic_energy();
    let step = fraction * assembly.critical_step();
    (0..3000).for_each(|_| assembly.step_alone(step));
    (assembly.kinetic_energy() + assembly.stored_energy()) / start
}

fn law(stiffness_ratio: f64, damping_ratio: f64) -> BondLaw {
    BondLaw::ParallelBond(ParallelBond { stiffness_ratio, damping_ratio, radius_multiplier: 0.5, ..cement() })
}

#[test]
fn the_bound_of_the_step_is_that_of_a_long_row() {
    for damping_ratio in [0.0, 0.3] {
        let row = || Assembly::new(law(10.0, damping_ratio), row(60, 1e-3));
        let (below, above) = (growth(row(), 0.999), growth(row(), 1.02));
        assert!(below < 1e3, "ζ = {damping_ratio}: stable below the bound, {below}");
        assert!(above.is_nan() || above > 1e6, "ζ = {damping_ratio}: unstable above it, {above}");
    }
}

#[test]
fn below_the_bound_a_block_is_stable_whatever_is_stiffest() {
    for stiffness_ratio in [0.1, 1.0, 10.0] {
        for damping_ratio in [0.0, 0.5] {
            let block = Assembly::new(law(stiffness_ratio, damping_ratio), cube(4, 1e-3));
            let growth = growth(block, 0.999);
            assert!(growth < 1e3, "k_n/k_s = {stiffness_ratio}, ζ = {damping_ratio}: {growth}");
        }
    }
}
