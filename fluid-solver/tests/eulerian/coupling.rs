//! Momentum and volume shared with grains.

use crate::support::{Random, box_mesh, flow, given, largest_speed};
use fluid_solver::backend::eulerian::{Eulerian, Flow, Properties};
use fluid_solver::backend::{FluidBackend, Response, Step};
use fluid_solver::boundary::Condition;
use interface::frames::{GrainRow, ReactionRow};
use interface::ledger::FluidLedger;

const DENSITY: f64 = 1000.0;

fn water<const D: usize>(gravity: [f64; D]) -> Properties<D> {
    Properties { density: DENSITY, viscosity: 1e-3, gravity, tolerance: 1e-8 }
}

/// A channel of 0.2 m: inlet below, outlet above, sticking, sliding and moving walls around.
fn channel<const D: usize, const N: usize>(cells: usize) -> Flow<D, N> {
    let mut gravity = [0.4; D];
    gravity[D - 1] = -9.81;
    let mesh = box_mesh::<D, N>([0.0; D], [0.2; D], [cells; D], [false; D], Some(0.2));
    let (bottom, top) = if D == 2 { ("y-min", "y-max") } else { ("z-min", "z-max") };
    let mut flow = flow(mesh, water(gravity), |name| match name {
        name if name == bottom => given(|x, t| {
            let mut u = [0.0; D];
            u[D - 1] = 0.05 * (1.0 + 20.0 * x[0]) * (1.0 + (30.0 * t).sin());
            u
        }),
        name if name == top => Condition::Outlet { pressure: 2e3 },
        "x-min" => Condition::Slip,
        "x-max" => Condition::MovingWall(std::sync::Arc::new(|_, _| {
            let mut u = [0.0; D];
            u[D - 1] = 0.1;
            u
        })),
        _ => Condition::NoSlip,
    });
    flow.set_velocity(|_| [0.01; D]);
    flow
}

/// Grains at random places of a box, some close to walls.
fn cloud<const D: usize>(count: usize, extent: f64, random: &mut Random) -> Vec<GrainRow> {
    let grain =
        |id: usize| {
            let radius = extent * (0.012 + 0.005 * random.unit());
            let position = std::array::from_fn(|k| {
                if k < D { radius + (extent - 2.0 * radius) * random.unit() } else { 0.0 }
            });
            let velocity = std::array::from_fn(|k| if k < D { random.unit() - 0.5 } else { 0.0 });
            let mass = 2500.0 * 4.0 * radius.powi(3);
            GrainRow { id: id as u64, position, velocity, angular_velocity: [0.0; 3], radius, mass }
        };
    (0..count).map(grain).collect()
}

fn moved(grains: &[GrainRow], step: f64) -> Vec<GrainRow> {
    let shifted = |row: &GrainRow| {
        let position = std::array::from_fn(|k| row.position[k] + 0.2 * step * row.velocity[k]);
        GrainRow { position, ..*row }
    };
    grains.iter().map(shifted).collect()
}

/// Reactions with β_e from 0 to 10⁴ m/Δt.
fn reactions(grains: &[GrainRow], step: f64, random: &mut Random) -> Vec<ReactionRow> {
    let reaction = |(p, row): (usize, &GrainRow)| ReactionRow {
        force: std::array::from_fn(|k| {
            if row.position[k] == 0.0 { 0.0 } else { 0.1 * row.mass * (random.unit() - 0.5) }
        }),
        exchange_coefficient: [0.0, 1e-2, 1.0, 1e2, 1e4][p % 5] * row.mass / step,
        added_mass: 0.0,
        target_velocity: row.velocity,
        relayed_volume: random.unit() * row.radius.powi(3),
        inverse_mass: 1.0 / (row.mass * (1.0 + [0.0, 1e-2, 1.0, 1e2, 1e4][p % 5])),
    };
    grains.iter().enumerate().map(reaction).collect()
}

/// |rate − (body + boundary − drag − stress + explicit)| over the scale.
fn defect(ledger: &FluidLedger) -> f64 {
    let defect = |k: usize| {
        let gained =
            ledger.body[k] + ledger.boundary[k] - ledger.drag[k] - ledger.stress[k] + ledger.explicit[k];
        (ledger.rate[k] - gained).abs()
    };
    (0..3).map(defect).fold(0.0, f64::max) / ledger.scale
}

fn ledger_closes<const D: usize, const N: usize>(cells: usize, count: usize) {
    let mut random = Random(3);
    let mut backend = Eulerian::new(channel::<D, N>(cells), Response::TwoWay, if D == 2 { 0.7 } else { 1.0 });
    let mut grains = cloud::<D>(count, 0.2, &mut random);
    backend.populate(0.0, &grains).unwrap();
    let length = 2e-3;
    for n in 0..4 {
        let step = Step { time: n as f64 * length, length };
        backend.save();
        grains = moved(&grains, length);
        for iteration in 0..2 {
            if iteration > 0 {
                backend.restore();
            }
            backend.project(step, &grains).unwrap();
            let reactions = reactions(&grains, length, &mut random);
            let solution = backend.solve(step, &reactions).unwrap().solved().unwrap();
            backend.prepare_samples();
            let ledger = &solution.ledger;
            assert!(defect(ledger) <= 1e-12, "{:e}: {ledger:?}", defect(ledger));
            assert!(ledger.drag.iter().any(|drag| drag.abs() > 1e-3 * ledger.scale), "{ledger:?}");
            what_grains_sample_is_what_the_fluid_gives(&backend, &grains, &reactions, ledger, length);
        }
        backend.commit(step).unwrap();
    }
}

/// Σ_p V_p(−∇p + ∇·τ)_p Δt is the ledger's stress, Σ_p [β_e(u_p − v*) + R∇(p − p′)]Δt its drag.
fn what_grains_sample_is_what_the_fluid_gives<const D: usize, const N: usize>(
    backend: &Eulerian<D, N>,
    grains: &[GrainRow],
    reactions: &[ReactionRow],
    ledger: &FluidLedger,
    length: f64,
) {
    let (mut stress, mut drag) = ([0.0; 3], [0.0; 3]);
    for (row, (grain, reaction)) in grains.iter().zip(reactions).enumerate() {
        let sample = backend.sample(row);
        let volume = match D {
            2 => 0.7 * std::f64::consts::PI * grain.radius.powi(2),
            _ => 4.0 / 3.0 * std::f64::consts::PI * grain.radius.powi(3),
        };
        for k in 0..3 {
            stress[k] +=
                volume * (sample.viscous_stress_divergence[k] - sample.pressure_gradient[k]) * length;
            let drag_k = reaction.exchange_coefficient * (sample.velocity[k] - reaction.target_velocity[k]);
            drag[k] += (drag_k + sample.relayed_force[k]) * length;
        }
        assert!(sample.density == 0.0 || sample.relayed_force != [0.0; 3]);
    }
    for k in 0..3 {
        assert!((stress[k] - ledger.stress[k]).abs() <= 1e-12 * ledger.scale, "{stress:?} {ledger:?}");
        assert!((drag[k] - ledger.drag[k]).abs() <= 1e-12 * ledger.scale, "{drag:?} {ledger:?}");
    }
}

#[test]
fn momentum_closes_to_round_off_in_the_plane() {
    ledger_closes::<2, 3>(12, 150);
}

#[test]
fn momentum_closes_to_round_off_in_space() {
    ledger_closes::<3, 4>(6, 1200);
}

/// A periodic box full of grains at rest, held in place, and a body force.
fn bed<const D: usize, const N: usize>(coefficient: f64, force: f64, length: f64) -> (Eulerian<D, N>, f64) {
    let mesh = box_mesh::<D, N>([0.0; D], [1.0; D], [6; D], [true; D], None);
    let mut flow = flow(mesh, water([0.0; D]), |_| Condition::NoSlip);
    flow.set_body_force(|_| std::array::from_fn(|k| if k == 0 { force } else { 0.0 }));
    let mut backend = Eulerian::new(flow, Response::TwoWay, 1.0);
    let mut grains = Vec::new();
    let per_axis: usize = 6;
    for index in 0..per_axis.pow(D as u32) {
        let mut position = [0.0; 3];
        for (k, x) in position.iter_mut().enumerate().take(D) {
            *x = ((index / per_axis.pow(k as u32)) % per_axis) as f64 / per_axis as f64;
        }
        grains.push(GrainRow {
            id: index as u64,
            position,
            radius: 0.06,
            mass: f64::INFINITY,
            ..GrainRow::default()
        });
    }
    let row = ReactionRow { exchange_coefficient: coefficient, ..ReactionRow::default() };
    let reactions = vec![row; grains.len()];
    backend.populate(0.0, &grains).unwrap();
    let mut worst: f64 = 0.0;
    for n in 0..3 {
        let step = Step { time: n as f64 * length, length };
        backend.save();
        backend.project(step, &grains).unwrap();
        let solution = backend.solve(step, &reactions).unwrap().solved().unwrap();
        worst = worst.max(defect(&solution.ledger));
        backend.prepare_samples();
        backend.commit(step).unwrap();
    }
    assert!(worst <= 1e-12, "{worst:e}");
    let fluid: f64 = backend
        .flow()
        .state()
        .void_fraction
        .iter()
        .zip(backend.flow().mesh().measure())
        .map(|(e, m)| e * m)
        .sum();
    // Darcy: Σβ u = ∫ρεb.
    let exact = DENSITY * fluid * force / (grains.len() as f64 * coefficient);
    (backend, exact)
}

#[test]
fn body_force_and_drag_balance_in_a_periodic_bed() {
    fn balance<const D: usize, const N: usize>(coefficient: f64) {
        // A step so long that inertia is gone.
        let (backend, exact) = bed::<D, N>(coefficient, 1e-3, 1e10);
        let count = 6usize.pow(D as u32);
        let mean = (0..count).map(|row| backend.sample(row).velocity[0]).sum::<f64>() / count as f64;
        assert!((mean / exact - 1.0).abs() < 1e-10, "{mean:e} {exact:e}");
    }
    balance::<2, 3>(3.0);
    balance::<3, 4>(1e4);
}

#[test]
fn drag_far_stiffer_than_inertia_stays_bounded_and_stops_the_fluid() {
    // β/(ρ/Δt) from 1 to 10⁶.
    for coefficient in [1e2, 1e5, 1e8] {
        let (backend, exact) = bed::<2, 3>(coefficient, 9.81, 1e-2);
        let speed = largest_speed(backend.flow());
        assert!(speed <= 1.5 * exact.min(9.81 * 3e-2), "{speed:e} {exact:e}");
    }
}

#[test]
fn grains_that_appear_leave_no_source_of_volume() {
    let mut random = Random(5);
    let grains = cloud::<2>(60, 0.2, &mut random);
    let mesh = box_mesh::<2, 3>([0.0; 2], [0.2; 2], [12, 12], [false; 2], None);
    let flow = flow(mesh, water([0.0, -9.81]), |name| match name {
        "y-max" => Condition::Outlet { pressure: 0.0 },
        _ => Condition::NoSlip,
    });
    let mut backend = Eulerian::new(flow, Response::TwoWay, 1.0);
    for n in 0..3 {
        let step = Step { time: n as f64 * 1e-3, length: 1e-3 };
        backend.populate(step.time, &grains[..20 * (n + 1)]).unwrap();
        backend.save();
        backend.project(step, &grains[..20 * (n + 1)]).unwrap();
        backend.solve(step, &[]).unwrap().solved().unwrap();
        backend.commit(step).unwrap();
        assert!(largest_speed(backend.flow()) < 1e-10, "{:e}", largest_speed(backend.flow()));
    }
}

#[test]
fn an_enclosed_fluid_reports_the_volume_that_grains_displace_and_goes_on() {
    let mut random = Random(9);
    let grains = cloud::<2>(40, 0.2, &mut random);
    let mesh = box_mesh::<2, 3>([0.0; 2], [0.2; 2], [10, 10], [false; 2], Some(0.2));
    let flow = flow(mesh, water([0.0, -9.81]), |_| Condition::NoSlip);
    let mut backend = Eulerian::new(flow, Response::TwoWay, 1.0);
    backend.populate(0.0, &grains).unwrap();
    backend.save();
    let step = Step { time: 0.0, length: 1e-3 };
    // One grain leaves: its volume is not replaced.
    let volume = std::f64::consts::PI * grains[39].radius.powi(2);
    backend.project(step, &grains[..39]).unwrap();
    let solution = backend.solve(step, &[]).unwrap().solved().unwrap();
    assert!((solution.ledger.volume_defect / volume - 1.0).abs() < 1e-9);
    assert!(defect(&solution.ledger) <= 1e-12);
}

/// A tank with random grains at rest in its lower half.
fn tank(response: Response) -> (Eulerian<3, 4>, Vec<GrainRow>) {
    let mesh = box_mesh::<3, 4>([0.0; 3], [0.2; 3], [6; 3], [false; 3], Some(0.2));
    let flow = flow(mesh, water([0.0, 0.0, -9.81]), |name| match name {
        "z-max" => Condition::Outlet { pressure: 1e5 },
        "x-min" => Condition::Slip,
        _ => Condition::NoSlip,
    });
    let mut backend = Eulerian::new(flow, response, 1.0);
    let mut grains = cloud::<3>(500, 0.2, &mut Random(1));
    for grain in &mut grains {
        grain.position[2] *= 0.5;
        grain.velocity = [0.0; 3];
    }
    backend.populate(0.0, &grains).unwrap();
    (backend, grains)
}

#[test]
fn a_bed_with_huge_drag_does_not_stir_a_fluid_at_rest_and_is_carried_by_its_pressure() {
    let (mut backend, grains) = tank(Response::TwoWay);
    let row = ReactionRow { exchange_coefficient: 1e6, ..ReactionRow::default() };
    for n in 0..100 {
        let step = Step { time: n as f64 * 1e-3, length: 1e-3 };
        backend.save();
        backend.project(step, &grains).unwrap();
        let solution = backend.solve(step, &vec![row; grains.len()]).unwrap().solved().unwrap();
        assert!(largest_speed(backend.flow()) <= 1e-10, "{n}: {:e}", largest_speed(backend.flow()));
        assert!(defect(&solution.ledger) <= 1e-12);
        backend.commit(step).unwrap();
    }
    backend.prepare_samples();
    for row in 0..grains.len() {
        let slope = backend.sample(row).pressure_gradient;
        assert!((slope[2] / (-9.81 * DENSITY) - 1.0).abs() < 1e-8 && slope[0].abs() < 1e-4, "{slope:?}");
    }
}

#[test]
fn one_way_grains_leave_the_fluid_alone_and_the_books_closed() {
    let (mut backend, grains) = tank(Response::OneWay);
    let row = ReactionRow {
        exchange_coefficient: 1e-2,
        target_velocity: [0.3, 0.0, -0.1],
        ..ReactionRow::default()
    };
    let step = Step { time: 0.0, length: 1e-3 };
    backend.save();
    backend.project(step, &grains).unwrap();
    let solution = backend.solve(step, &vec![row; grains.len()]).unwrap().solved().unwrap();
    backend.prepare_samples();
    assert!(largest_speed(backend.flow()) <= 1e-10);
    assert!(backend.sample(0).void_fraction < 1.0 && solution.ledger.drag[0] < 0.0);
    assert!(defect(&solution.ledger) <= 1e-12, "{:?}", solution.ledger);
}

#[test]
fn a_grain_outside_the_fluid_samples_nothing_and_gives_nothing() {
    let (mut backend, mut grains) = tank(Response::TwoWay);
    grains.truncate(3);
    grains[1].position = [0.1, 0.1, 0.5];
    backend.populate(0.0, &grains).unwrap();
    let step = Step { time: 0.0, length: 1e-3 };
    backend.save();
    backend.project(step, &grains).unwrap();
    let row = ReactionRow { force: [0.0, 0.0, 1e3], exchange_coefficient: 1.0, ..ReactionRow::default() };
    let mut reactions = vec![ReactionRow::default(); 3];
    reactions[1] = row;
    let solution = backend.solve(step, &reactions).unwrap().solved().unwrap();
    backend.prepare_samples();
    assert_eq!(backend.sample(1).density, 0.0);
    assert_eq!(backend.sample(0).density, DENSITY);
    assert_eq!((solution.ledger.drag, solution.ledger.explicit), ([0.0; 3], [0.0; 3]));
    assert!(largest_speed(backend.flow()) <= 1e-10);
}
