//! Grains in fluids with a yield stress.

use super::momentum::{ledger_closes, reactions};
use super::scene::{Random, SIDE, Tank, grains, solved};
use crate::support::{WATER, block, flow, newtonian, tank, touch};
use fluid_solver::backend::Step;
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::flow::{Control, Flow, Fluid, Forces, HerschelBulkley, Rheology};
use fluid_solver::backend::pfem::grains::GrainsInCloud;
use fluid_solver::backend::pfem::wall::Grip;
use fluid_solver::grains::Spreading;
use interface::frames::{GrainRow, ReactionRow};
use std::f64::consts::PI;

fn bingham(viscosity: f64, yield_stress: f64, creep_rate: f64) -> Fluid {
    let law = HerschelBulkley { consistency: viscosity, exponent: 1.0, yield_stress, creep_rate };
    Fluid { rheology: Rheology::HerschelBulkley(law), ..WATER }
}

/// Yields to the grains that shake it and holds elsewhere.
fn mud() -> Fluid {
    bingham(1.0, 20.0, 0.1)
}

#[test]
fn momentum_closes_to_round_off_in_mud() {
    ledger_closes(Tank::<2, 3>::of(mud(), 12, Grip::NoSlip, Spreading::Kernel), 150);
    ledger_closes(Tank::<2, 3>::of(mud(), 12, Grip::NoSlip, Spreading::Nodal), 150);
    ledger_closes(Tank::<3, 4>::of(mud(), 6, Grip::NoSlip, Spreading::Kernel), 600);
}

/// A tank that grains have shaken for some windows, and the passes that took.
fn shaken<const D: usize, const N: usize>(fluid: Fluid, cells: usize, count: usize) -> (Cloud<D, N>, u64) {
    let mut tank = Tank::<D, N>::of(fluid, cells, Grip::NoSlip, Spreading::Kernel);
    tank.flow = Flow::new(fluid, Control { tolerance: 1e-8, implicitness: 1.0, ..Control::default() });
    let mut random = Random(11);
    let rows = grains::<D>(count, 0.9 * SIDE, &mut random);
    tank.grains.populate(&tank.cloud, &rows).unwrap();
    let mut passes = 0;
    for _ in 0..3 {
        let (solution, _) = tank.window(2e-3, &rows, 1, |_| reactions(&rows, 2e-3, &mut random));
        passes = passes.max(solution.passes);
        tank.commit(2e-3, &solution);
    }
    (tank.cloud, passes)
}

#[test]
fn without_a_yield_stress_grains_in_mud_are_grains_in_a_newtonian_fluid() {
    fn apart<const D: usize, const N: usize>(cells: usize, count: usize) -> f64 {
        let (mud, _) = shaken::<D, N>(bingham(1.0, 0.0, 0.1), cells, count);
        let (other, _) = shaken::<D, N>(newtonian(WATER.density, 1.0), cells, count);
        let speed = |v: &[f64; D]| v.iter().map(|v| v * v).sum::<f64>().sqrt();
        let fastest = other.velocity.iter().map(speed).fold(0.0, f64::max);
        let pairs = mud.velocity.iter().flatten().zip(other.velocity.iter().flatten());
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / fastest
    }
    assert!(apart::<2, 3>(12, 150) < 1e-6);
    assert!(apart::<3, 4>(6, 600) < 1e-6);
}

#[test]
fn one_two_and_four_threads_give_the_same_bits_and_few_passes() {
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| shaken::<3, 4>(mud(), 6, 600))
    };
    let one = with(1);
    assert!(one == with(2) && one == with(4));
    assert!(one.1 <= 25, "{} passes", one.1);
}

/// Discs of a lattice that take up a share of a channel.
fn lattice(size: [f64; 2], share: f64, density: f64) -> Vec<GrainRow> {
    let radius: f64 = 2e-3;
    let spacing = (PI * radius * radius / share).sqrt();
    let [across, along] = size.map(|length| (length / spacing).round());
    let grain = |n: usize| {
        let (column, row) = (n % across as usize, n / across as usize);
        let position = [(column as f64 + 0.5) * size[0] / across, (row as f64 + 0.5) * size[1] / along, 0.0];
        let mass = density * PI * radius * radius;
        GrainRow { id: n as u64, position, radius, mass, ..GrainRow::default() }
    };
    (0..(across * along) as usize).map(grain).collect()
}

/// Largest error of the profile halfway down a channel that mud with grains falls through, relative to its largest speed, and
/// of the stress on its walls.
///
/// Grains without inertia go with the mud, and what they weigh more is a force on it.
fn channel(share: f64, density: f64) -> (f64, f64) {
    let (half, length, viscosity, gravity, step_length) = (0.05, 0.6, 100.0, 1.0, 5e-3);
    let (size, rows) = ([2.0 * half, length], 72);
    let mut cloud = block::<2, 3>(size, [20, rows], 0.2);
    let mut walls = tank(size, Grip::NoSlip);
    walls.pop();
    touch(&mut cloud, &walls);
    let mut grains = lattice(size, share, density);
    let solids = grains.len() as f64 * grains[0].mass / density / (size[0] * size[1]);
    let slope = (WATER.density + solids * (density - WATER.density)) * gravity;
    let plug = 0.2;
    let fluid = bingham(viscosity, plug * slope * half, 1e-3 * slope * half / viscosity);
    let mut flow = flow(fluid, 1e-6);
    let mut among = GrainsInCloud::new(fluid, 1.0, cloud.place.len(), Spreading::Kernel);
    among.populate(&cloud, &grains).unwrap();
    among.prepare_samples();
    let mut stress = 0.0;
    for n in 0..30 {
        let step = Step { time: f64::from(n) * step_length, length: step_length };
        let mut given = Vec::new();
        for (row, grain) in grains.iter_mut().enumerate() {
            let sample = among.sample(row);
            let volume = grain.mass / density * sample.wetted_fraction;
            let mut force: [f64; 3] = std::array::from_fn(|k| {
                volume * (sample.viscous_stress_divergence[k] - sample.pressure_gradient[k])
            });
            force[1] -= grain.mass * gravity * sample.wetted_fraction;
            given.push(ReactionRow { force, relayed_volume: volume, ..ReactionRow::default() });
            for k in 0..2 {
                grain.velocity[k] = sample.velocity[k];
                grain.position[k] += step_length * sample.velocity[k];
            }
        }
        among.project(&cloud, step, &grains).unwrap();
        let forces = Forces { gravity: [0.0, -gravity], grains: among.react(step, &given) };
        let solution = flow.solve(&cloud, &walls, step, &forces).unwrap();
        among.feel(&cloud, step, solved(&solution));
        among.prepare_samples();
        let held =
            |node: &usize| !cloud.contacts[*node].is_empty() && (0.2..0.4).contains(&cloud.place[*node][1]);
        let held: Vec<usize> = (0..cloud.place.len()).filter(held).collect();
        // Of the share ε of the wall that the fluid touches.
        let on_wall = |&node: &usize| solution.reaction[node][1] / among.void_fraction()[node];
        stress =
            held.iter().map(on_wall).sum::<f64>() / (held.len() as f64 * length / f64::from(rows as u32));
        solution.advance(&mut cloud, step);
        among.begin(&cloud).unwrap();
    }
    let driving = stress / half;
    let plug = plug * slope / driving;
    let exact = |x: f64| {
        let y = ((x - half) / half).abs().max(plug);
        driving * half * half / viscosity * (0.5 * (1.0 - y * y) - plug * (1.0 - y))
    };
    let middle = cloud.place.iter().zip(&cloud.velocity).filter(|(x, _)| (x[1] - 0.3).abs() < 0.02);
    let error = middle.map(|(x, v)| (-v[1] - exact(x[0])).abs()).fold(0.0, f64::max);
    (error / exact(half), driving / slope - 1.0)
}

#[test]
fn mud_with_heavy_grains_falls_through_a_channel_as_a_bingham_fluid_of_its_mean_weight() {
    for (share, density) in [(0.1, WATER.density), (0.2, 2500.0)] {
        let (profile, stress) = channel(share, density);
        println!(
            "a share {share} of grains of {density} kg/m³ in mud: profile {profile:.4}, stress {stress:+.4}"
        );
        assert!(profile <= 0.03 && stress.abs() <= 0.03, "{share} {density}: {profile}, {stress}");
    }
}
