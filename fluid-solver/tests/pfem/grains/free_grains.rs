//! Grains that move freely, one pass per window.

use super::scene::{DEPTH, SIDE, Tank, defect};
use crate::support::{G, WATER, largest_speed};
use fluid_solver::backend::pfem::wall::Grip;
use interface::frames::{GrainRow, ReactionRow, SampleRow};
use std::f64::consts::PI;

const RADIUS: f64 = 0.009;
const LENGTH: f64 = 2e-3;

/// Grains that relax implicitly with a given rate β/m (1/s) when they are wet, and what the fluid owes them.
struct Grains<const D: usize> {
    rows: Vec<GrainRow>,
    relaxation: f64,
    owed: Vec<[f64; 3]>,
    felt: Vec<SampleRow>,
}

impl<const D: usize> Grains<D> {
    /// Some of this density in a row, their centres at this height over the surface.
    fn new(count: usize, density: f64, height: f64, relaxation: f64) -> Self {
        let grain = |n: usize| {
            let mut position = std::array::from_fn(|k| if k < D { 0.43 * SIDE } else { 0.0 });
            position[0] = SIDE * (n as f64 + 1.0) / (count as f64 + 1.0);
            position[D - 1] = SIDE + height;
            let mass = density * Self::volume();
            GrainRow { id: n as u64, position, radius: RADIUS, mass, ..GrainRow::default() }
        };
        let rows: Vec<GrainRow> = (0..count).map(grain).collect();
        Self { owed: vec![[0.0; 3]; count], felt: Vec::new(), rows, relaxation }
    }

    fn volume() -> f64 {
        match D {
            2 => DEPTH * PI * RADIUS.powi(2),
            _ => 4.0 / 3.0 * PI * RADIUS.powi(3),
        }
    }

    /// Force on a wet grain by what it samples but drag.
    fn stress(sample: &SampleRow) -> [f64; 3] {
        let volume = sample.wetted_fraction * Self::volume();
        std::array::from_fn(|k| volume * (sample.viscous_stress_divergence[k] - sample.pressure_gradient[k]))
    }

    /// Moves through a window; reactions and the impulses received of the fluid.
    fn advance(&mut self) -> (Vec<ReactionRow>, Vec<[f64; 3]>) {
        let moved = self.rows.iter_mut().zip(&self.felt).zip(&self.owed).map(|((row, sample), owed)| {
            let mass = row.mass;
            let beta = sample.wetted_fraction * self.relaxation * mass;
            let (stress, inertia) = (Self::stress(sample), mass + beta * LENGTH);
            let mut received = [0.0; 3];
            let effective = beta * mass / inertia;
            let mut target_velocity = sample.velocity;
            for k in 0..D {
                let weight = if k == D - 1 { -mass * G } else { 0.0 };
                let other = owed[k] / LENGTH + stress[k] + weight;
                row.velocity[k] =
                    (mass * row.velocity[k] + LENGTH * (other + beta * sample.velocity[k])) / inertia;
                row.position[k] += LENGTH * row.velocity[k];
                let drag = LENGTH * beta * (sample.velocity[k] - row.velocity[k]);
                received[k] = drag + owed[k] + LENGTH * stress[k];
                if effective > 0.0 {
                    target_velocity[k] -= drag / (effective * LENGTH);
                }
            }
            let wet = sample.density > 0.0;
            let reaction = ReactionRow {
                exchange_coefficient: effective,
                target_velocity,
                relayed_volume: sample.wetted_fraction * Self::volume() * (1.0 - mass / inertia),
                inverse_mass: 1.0 / mass,
                ..ReactionRow::default()
            };
            (if wet { reaction } else { ReactionRow::default() }, received)
        });
        moved.unzip()
    }

    /// Takes the fluid's new samples, and books what it gave.
    fn settle(&mut self, samples: Vec<SampleRow>, reactions: &[ReactionRow], received: &[[f64; 3]]) {
        for (row, sample) in samples.iter().enumerate() {
            let stress = Self::stress(sample);
            for k in 0..D {
                let reaction = &reactions[row];
                let drag = reaction.exchange_coefficient * (sample.velocity[k] - reaction.target_velocity[k]);
                let given = match sample.density {
                    0.0 => 0.0,
                    _ => LENGTH * (drag + sample.relayed_force[k] + stress[k]),
                };
                self.owed[row][k] += given - received[row][k];
            }
        }
        self.felt = samples;
    }
}

/// Windows of one pass; calls `after` with the grains.
fn run<const D: usize, const N: usize>(
    tank: &mut Tank<D, N>,
    grains: &mut Grains<D>,
    windows: usize,
    mut after: impl FnMut(usize, &Tank<D, N>, &Grains<D>),
) {
    let count = grains.rows.len();
    tank.grains.populate(&tank.cloud, &grains.rows).unwrap();
    tank.grains.prepare_samples();
    grains.felt = (0..count).map(|row| tank.grains.sample(row)).collect();
    for n in 0..windows {
        let (reactions, received) = grains.advance();
        let rows = grains.rows.clone();
        let (solution, ledger) = tank.window(LENGTH, &rows, 1, |_| reactions.clone());
        assert!(defect(&ledger) <= 1e-12, "{n}: {:e}", defect(&ledger));
        let samples = (0..count).map(|row| tank.grains.sample(row)).collect();
        grains.settle(samples, &reactions, &received);
        tank.commit(LENGTH, &solution);
        after(n, tank, grains);
    }
}

fn floats<const D: usize, const N: usize>(cells: usize, density: f64, windows: usize) {
    let mut tank = Tank::<D, N>::new(cells, Grip::Slip);
    let mut grains = Grains::<D>::new(3, density, 0.5 * RADIUS, 20.0);
    let mut fastest = 0.0_f64;
    let mut wetted = 0.0;
    run(&mut tank, &mut grains, windows, |n, tank, grains| {
        fastest = fastest.max(largest_speed(&tank.cloud));
        if n >= windows - 100 {
            wetted += grains.felt.iter().map(|sample| sample.wetted_fraction).sum::<f64>() / 300.0;
        }
    });
    assert!((wetted - density / WATER.density).abs() <= 0.01, "{wetted}");
    assert!(fastest < 0.3, "{fastest}");
}

#[test]
fn a_grain_of_half_the_density_floats_half_wet() {
    floats::<2, 3>(10, 500.0, 600);
    floats::<3, 4>(5, 500.0, 400);
}

#[test]
fn a_grain_of_a_fifth_of_the_density_floats_a_fifth_wet() {
    floats::<2, 3>(10, 200.0, 600);
}
