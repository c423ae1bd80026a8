//! Momentum crosses between grains and fluid to round-off.

use super::scene::{DEPTH, Random, SIDE, Tank, defect, grains};
use crate::support::WATER;
use fluid_solver::backend::pfem::grains::GrainsInCloud;
use fluid_solver::backend::pfem::wall::Grip;
use fluid_solver::grains::Spreading;
use interface::frames::{GrainRow, ReactionRow};
use interface::ledger::FluidLedger;

/// Reactions with β_e from 0 to 10⁴ m/Δt.
pub fn reactions(grains: &[GrainRow], step: f64, random: &mut Random) -> Vec<ReactionRow> {
    let reaction = |(p, row): (usize, &GrainRow)| ReactionRow {
        force: std::array::from_fn(|k| {
            if row.position[k] == 0.0 { 0.0 } else { 0.1 * row.mass * (random.unit() - 0.5) }
        }),
        exchange_coefficient: [0.0, 1e-2, 1.0, 1e2, 1e4][p % 5] * row.mass / step,
        added_mass: 0.0,
        target_velocity: row.velocity.map(|v| 0.2 * v),
        relayed_volume: random.unit() * row.radius.powi(3),
        inverse_mass: 1.0 / (row.mass * (1.0 + [0.0, 1e-2, 1.0, 1e2, 1e4][p % 5])),
    };
    grains.iter().enumerate().map(reaction).collect()
}

pub fn ledger_closes<const D: usize, const N: usize>(mut tank: Tank<D, N>, count: usize) {
    let mut random = Random(3);
    let mut worst = 0.0f64;
    // The highest grains are dry, others in the surface.
    let mut rows = grains::<D>(count, 1.1 * SIDE, &mut random);
    tank.grains.populate(&tank.cloud, &rows).unwrap();
    let length = 2e-3;
    for _ in 0..4 {
        for row in &mut rows {
            (0..D).for_each(|k| row.position[k] += 0.2 * length * row.velocity[k]);
        }
        for iterations in [1, 2] {
            let mut given = Vec::new();
            let (solution, ledger) = tank.window(length, &rows, iterations, |_| {
                given = reactions(&rows, length, &mut random);
                given.clone()
            });
            worst = worst.max(defect(&ledger));
            assert!(worst <= 1e-12, "{worst:e}: {ledger:?}");
            assert!(ledger.drag.iter().any(|drag| drag.abs() > 1e-3 * ledger.scale), "{ledger:?}");
            assert!(ledger.stress.iter().any(|stress| stress.abs() > 1e-5 * ledger.scale), "{ledger:?}");
            what_grains_sample_is_what_the_fluid_gives::<D, N>(&tank.grains, &rows, &given, &ledger, length);
            if iterations == 2 {
                tank.commit(length, &solution);
            }
        }
    }
    println!("{count} grains in {D}D: momentum to {worst:.1e}");
}

/// Σ_p f_p V_p(−∇p + ∇·τ)_p Δt is the ledger's stress, Σ_p [β_e(u_p − v*) + R∇(p − p′)]Δt its drag.
fn what_grains_sample_is_what_the_fluid_gives<const D: usize, const N: usize>(
    grains: &GrainsInCloud<D, N>,
    rows: &[GrainRow],
    reactions: &[ReactionRow],
    ledger: &FluidLedger,
    length: f64,
) {
    let (mut stress, mut drag, mut dry, mut afloat) = ([0.0; 3], [0.0; 3], 0, 0);
    for (row, (grain, reaction)) in rows.iter().zip(reactions).enumerate() {
        let sample = grains.sample(row);
        dry += usize::from(sample.density == 0.0);
        afloat += usize::from(sample.wetted_fraction > 0.0 && sample.wetted_fraction < 1.0);
        if sample.density == 0.0 {
            continue;
        }
        let volume = sample.wetted_fraction
            * match D {
                2 => DEPTH * std::f64::consts::PI * grain.radius.powi(2),
                _ => 4.0 / 3.0 * std::f64::consts::PI * grain.radius.powi(3),
            };
        for k in 0..3 {
            stress[k] +=
                volume * (sample.viscous_stress_divergence[k] - sample.pressure_gradient[k]) * length;
            let drag_k = reaction.exchange_coefficient * (sample.velocity[k] - reaction.target_velocity[k]);
            drag[k] += (drag_k + sample.relayed_force[k]) * length;
        }
    }
    assert!(dry > 0 && afloat > 0, "{dry} dry, {afloat} afloat");
    for k in 0..3 {
        assert!((stress[k] - ledger.stress[k]).abs() <= 1e-12 * ledger.scale, "{stress:?} {ledger:?}");
        assert!((drag[k] - ledger.drag[k]).abs() <= 1e-12 * ledger.scale, "{drag:?} {ledger:?}");
    }
}

#[test]
fn momentum_closes_to_round_off_in_the_plane() {
    ledger_closes(Tank::<2, 3>::new(12, Grip::NoSlip), 150);
}

#[test]
fn momentum_closes_to_round_off_in_space() {
    ledger_closes(Tank::<3, 4>::new(6, Grip::NoSlip), 600);
}

#[test]
fn momentum_closes_to_round_off_with_grains_on_single_nodes() {
    ledger_closes(Tank::<2, 3>::of(WATER, 12, Grip::NoSlip, Spreading::Nodal), 150);
    ledger_closes(Tank::<3, 4>::of(WATER, 6, Grip::NoSlip, Spreading::Nodal), 600);
}

#[test]
fn momentum_closes_to_round_off_among_slivers() {
    let mut tank = Tank::<3, 4>::new(6, Grip::NoSlip);
    tank.remesh();
    let thinnest = tank.thinnest_cell();
    assert!(thinnest < 0.02, "{thinnest}");
    ledger_closes(tank, 600);
}
