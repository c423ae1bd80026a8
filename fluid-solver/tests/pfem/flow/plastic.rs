//! Fluids with a yield stress.

use crate::support::{advance, block, flow, largest_speed, tank, touch};
use fluid_solver::backend::pfem::flow::{Fluid, Forces, HerschelBulkley, Rheology};
use fluid_solver::backend::pfem::wall::Grip;

const DENSITY: f64 = 1000.0;

fn bingham(viscosity: f64, yield_stress: f64, creep_rate: f64) -> Fluid {
    let law = HerschelBulkley { consistency: viscosity, exponent: 1.0, yield_stress, creep_rate };
    Fluid { density: DENSITY, rheology: Rheology::HerschelBulkley(law), bulk_modulus: None }
}

/// Largest error of the profile halfway down a channel that the fluid falls through, relative to the largest speed.
fn channel(share: f64, cells: usize) -> f64 {
    let (half, viscosity, gravity) = (0.05, 100.0, 1.0);
    let slope = DENSITY * gravity;
    let mut cloud = block::<2, 3>([2.0 * half, 0.3], [cells, cells * 9 / 5], 0.2);
    let mut walls = tank([2.0 * half, 0.3], Grip::NoSlip);
    walls.pop();
    touch(&mut cloud, &walls);
    let fluid = bingham(viscosity, share * slope * half, 1e-3 * slope * half / viscosity);
    let forces = Forces { gravity: [0.0, -gravity], grains: None };
    // At the ends the contact line slides, so that the rest of the walls bears a little more: it is asked how much.
    let spacing = 0.3 / (cells * 9 / 5) as f64;
    let mut driving = 0.0;
    advance(&mut flow(fluid, 1e-5), &mut cloud, &walls, &forces, 5e-3, 0..30, |cloud, solution| {
        let held =
            |node: &usize| !cloud.contacts[*node].is_empty() && (0.08..0.22).contains(&cloud.place[*node][1]);
        let held: Vec<usize> = (0..cloud.place.len()).filter(held).collect();
        let shear: f64 = held.iter().map(|&node| solution.reaction[node][1]).sum();
        driving = shear / (held.len() as f64 * spacing * half);
        eprintln!("{share} {cells}: {} passes {} iterations", solution.passes, solution.iterations);
    });
    let plug = share * slope / driving;
    let exact = |x: f64| {
        let y = ((x - half) / half).abs().max(plug);
        driving * half * half / viscosity * (0.5 * (1.0 - y * y) - plug * (1.0 - y))
    };
    let middle = cloud.place.iter().zip(&cloud.velocity).filter(|(x, _)| (x[1] - 0.15).abs() < 0.02);
    middle.map(|(x, v)| (-v[1] - exact(x[0])).abs()).fold(0.0, f64::max) / exact(half)
}

#[test]
fn a_bingham_fluid_falls_through_a_channel_with_its_plug() {
    for share in [0.0, 0.2, 0.5] {
        let error = channel(share, 20);
        eprintln!("{share} {error}");
        assert!(error <= 0.03, "{share}: {error}");
    }
}

#[test]
fn a_column_that_its_yield_stress_can_bear_only_creeps() {
    let (size, viscosity, yield_stress, creep_rate) = (0.1, 10.0, 2000.0, 1e-3);
    let mut cloud = block::<2, 3>([size; 2], [10, 10], 0.2);
    let walls = tank([1.0; 2], Grip::NoSlip);
    touch(&mut cloud, &walls);
    let forces = Forces { gravity: [0.0, -9.81], grains: None };
    let fluid = bingham(viscosity, yield_stress, creep_rate);
    advance(&mut flow(fluid, 1e-5), &mut cloud, &walls, &forces, 1e-3, 0..20, |_, _| ());
    // Stress ρgH/2 at most, at the viscosity of the creep.
    let creep = 0.5 * DENSITY * 9.81 * size * size * creep_rate / yield_stress;
    assert!(largest_speed(&cloud) <= creep, "{} m/s, {creep} m/s", largest_speed(&cloud));
}
