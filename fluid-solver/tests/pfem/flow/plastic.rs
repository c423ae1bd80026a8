//! Fluids with a yield stress.

use crate::support::{advance, block, flow, largest_speed, tank, touch};
use fluid_solver::backend::pfem::flow::{Fluid, Forces, HerschelBulkley, Rheology};
use fluid_solver::backend::pfem::wall::Grip;

const DENSITY: f64 = 1000.0;

fn bingham(viscosity: f64, yield_stress: f64, creep_rate: f64) -> Fluid {
    let law = HerschelBulkley { consistency: viscosity, exponent: 1.0, yield_stress, creep_rate };
    Fluid { density: DENSITY, rheology: Rheology::HerschelBulkley(law), bulk_modulus: None }
}

/// Largest error of the profile halfway down a channel that the fluid falls through, relative to the largest speed, and the
/// most passes of a step. The channel is six times as long as wide: the plug gives way at its ends.
fn channel(share: f64, cells: usize) -> (f64, u64) {
    let (half, length, viscosity, gravity) = (0.05, 0.6, 100.0, 1.0);
    let slope = DENSITY * gravity;
    let rows = 18 * cells / 5;
    let mut cloud = block::<2, 3>([2.0 * half, length], [cells, rows], 0.2);
    let mut walls = tank([2.0 * half, length], Grip::NoSlip);
    walls.pop();
    touch(&mut cloud, &walls);
    let fluid = bingham(viscosity, share * slope * half, 1e-3 * slope * half / viscosity);
    let forces = Forces { gravity: [0.0, -gravity], grains: None };
    // At the ends the contact line slides, so that the rest of the walls bears a little more: it is asked how much.
    let spacing = length / rows as f64;
    let (mut driving, mut passes) = (0.0, 0);
    advance(&mut flow(fluid, 1e-5), &mut cloud, &walls, &forces, 5e-3, 0..20, |cloud, solution| {
        let held =
            |node: &usize| !cloud.contacts[*node].is_empty() && (0.2..0.4).contains(&cloud.place[*node][1]);
        let held: Vec<usize> = (0..cloud.place.len()).filter(held).collect();
        let shear: f64 = held.iter().map(|&node| solution.reaction[node][1]).sum();
        driving = shear / (held.len() as f64 * spacing * half);
        passes = passes.max(solution.passes);
    });
    let plug = share * slope / driving;
    let exact = |x: f64| {
        let y = ((x - half) / half).abs().max(plug);
        driving * half * half / viscosity * (0.5 * (1.0 - y * y) - plug * (1.0 - y))
    };
    let middle = cloud.place.iter().zip(&cloud.velocity).filter(|(x, _)| (x[1] - 0.3).abs() < 0.02);
    let error = middle.map(|(x, v)| (-v[1] - exact(x[0])).abs()).fold(0.0, f64::max);
    (error / exact(half), passes)
}

#[test]
fn a_bingham_fluid_falls_through_a_channel_with_its_plug_in_few_passes() {
    for (share, cells) in [(0.0, 20), (0.2, 20), (0.2, 30), (0.5, 20), (0.5, 30)] {
        let (error, passes) = channel(share, cells);
        println!("Bingham channel, plug {share}, {cells} cells: profile {error:.4}, {passes} passes");
        assert!(error <= 0.03, "plug {share}, {cells} cells: {error}");
        assert!(passes <= 20, "plug {share}, {cells} cells: {passes} passes");
    }
}

/// A box at rest under gravity, against its weight.
fn column(yield_stress: f64, creep_rate: f64) -> (f64, u64) {
    let mut cloud = block::<2, 3>([0.1; 2], [10, 10], 0.2);
    let walls = tank([1.0; 2], Grip::NoSlip);
    touch(&mut cloud, &walls);
    let forces = Forces { gravity: [0.0, -9.81], grains: None };
    let fluid = bingham(10.0, yield_stress, creep_rate);
    let mut passes = 0;
    advance(&mut flow(fluid, 1e-5), &mut cloud, &walls, &forces, 1e-3, 0..20, |_, solution| {
        passes = passes.max(solution.passes);
    });
    (largest_speed(&cloud), passes)
}

#[test]
fn a_column_that_its_yield_stress_can_bear_only_creeps_and_slower_the_lower_the_stated_rate() {
    for creep_rate in [1e-2, 1e-3, 1e-4] {
        let (speed, passes) = column(2000.0, creep_rate);
        // Stress ρgH/2 at most, at the viscosity of the creep.
        let creep = 0.5 * DENSITY * 9.81 * 0.01 * creep_rate / 2000.0;
        println!("a column that its yield stress bears: creep {:.3} γ̇₀ρgH²/τ_y", 0.5 * speed / creep);
        assert!(speed <= creep && passes <= 20, "{speed} m/s, {creep} m/s, {passes} passes");
    }
    assert!(column(200.0, 1e-3).0 > 0.01, "a tenth of that stress does not bear it");
}

#[test]
fn a_thinning_fluid_falls_through_a_channel_as_its_power_says() {
    thinning(0.0);
}

#[test]
fn a_thinning_fluid_with_a_yield_stress_falls_through_a_channel_with_its_plug() {
    thinning(0.3);
}

/// A Herschel–Bulkley fluid, n = ½, whose plug is this share of a channel.
fn thinning(plug: f64) {
    let (half, length, consistency, exponent) = (0.05, 0.6, 100.0, 0.5);
    let mut cloud = block::<2, 3>([2.0 * half, length], [20, 72], 0.2);
    let mut walls = tank([2.0 * half, length], Grip::NoSlip);
    walls.pop();
    touch(&mut cloud, &walls);
    let yield_stress = plug * DENSITY * half;
    let law = HerschelBulkley { consistency, exponent, yield_stress, creep_rate: 1e-4 };
    let fluid = Fluid { density: DENSITY, rheology: Rheology::HerschelBulkley(law), bulk_modulus: None };
    let forces = Forces { gravity: [0.0, -1.0], grains: None };
    advance(&mut flow(fluid, 1e-5), &mut cloud, &walls, &forces, 5e-3, 0..40, |_, _| ());
    let middle = cloud.place.iter().zip(&cloud.velocity).filter(|(x, _)| (x[1] - 0.3).abs() < 0.02);
    let profile: Vec<[f64; 2]> = middle.map(|(x, v)| [(x[0] - half).abs() / half, -v[1]]).collect();
    let largest = profile.iter().map(|[_, v]| *v).fold(0.0, f64::max);
    // 1 − ((y − y_p)/(1 − y_p))^{1 + 1/n} beyond the plug
    let exact = |y: f64| 1.0 - ((y - plug).max(0.0) / (1.0 - plug)).powi(3);
    let error = profile.iter().map(|[y, v]| (v / largest - exact(*y)).abs()).fold(0.0, f64::max);
    assert!(error <= 0.03, "plug {plug}: {error}");
    // ((G/K)^{1/n}) n/(n + 1) a^{1 + 1/n} (1 − y_p)^{1 + 1/n}
    let fastest = (DENSITY / consistency).powi(2) / 3.0 * (half * (1.0 - plug)).powi(3);
    assert!((largest / fastest - 1.0).abs() <= 0.05, "plug {plug}: {largest} of {fastest} m/s");
}
