//! Standing waves of small amplitude in a tank of width 1 m, half a wave long: k = π.

use crate::support::{G, WATER, advance, block, flow, newtonian, tank, touch, volume};
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::flow::{Fluid, Forces};
use fluid_solver::backend::pfem::wall::{Grip, Wall};
use std::f64::consts::PI;

/// A wave a cos kx on water of a depth; rows of nodes are closer by a factor of `grading` at the surface than below.
pub struct Wave {
    pub depth: f64,
    pub cells: [usize; 2],
    pub grading: f64,
    pub amplitude: f64,
}

impl Wave {
    pub fn cloud(&self) -> Cloud<2, 3> {
        let mut cloud = block::<2, 3>([1.0, 1.0], self.cells, 0.2);
        for x in &mut cloud.place {
            let (down, q) = (1.0 - x[1], (self.grading - 1.0) / (self.grading + 1.0));
            let height = 1.0 - down * (1.0 - q * (1.0 - down));
            x[1] = height * (self.depth + self.amplitude * (PI * x[0]).cos());
        }
        cloud
    }

    /// Coefficient of cos kx in the elevation of the surface, relative to the amplitude.
    pub fn coefficient(&self, cloud: &Cloud<2, 3>) -> f64 {
        let row = self.cells[0] + 1;
        let surface = &cloud.place[cloud.place.len() - row..];
        let elevation = |i: usize| (surface[i][1] - self.depth) * (PI * surface[i][0]).cos();
        let trapezes = surface.windows(2).enumerate();
        let integral: f64 =
            trapezes.map(|(i, x)| 0.5 * (x[1][0] - x[0][0]) * (elevation(i) + elevation(i + 1))).sum();
        2.0 * integral / self.amplitude
    }

    /// The water at rest in its tank, and the tank.
    pub fn at_rest(&self, fluid: Fluid, gravity: f64) -> (Cloud<2, 3>, Vec<Wall<2>>) {
        let (mut cloud, walls) = (self.cloud(), tank([1.0, 2.0 * self.depth], Grip::Slip));
        touch(&mut cloud, &walls);
        for (p, x) in cloud.pressure.iter_mut().zip(&cloud.place) {
            *p = fluid.density * gravity * (self.depth - x[1]);
        }
        (cloud, walls)
    }

    /// That of linear theory under gravity (s).
    pub fn period(&self, gravity: f64) -> f64 {
        2.0 * PI / (gravity * PI * (PI * self.depth).tanh()).sqrt()
    }

    /// The coefficient after each step, the first before them.
    fn run(&self, fluid: Fluid, gravity: f64, length: f64, steps: usize) -> Vec<f64> {
        let (mut cloud, walls) = self.at_rest(fluid, gravity);
        let start = volume(&cloud);
        let mut series = vec![self.coefficient(&cloud)];
        let forces = Forces { gravity: [0.0, -gravity], grains: None };
        advance(&mut flow(fluid, 1e-7), &mut cloud, &walls, &forces, length, 0..steps, |cloud, _| {
            series.push(self.coefficient(cloud));
            let change = volume(cloud) / start - 1.0;
            assert!(change.abs() <= 1e-8, "{change:e}");
        });
        series
    }
}

/// Times at which a series vanishes.
pub fn zeros(series: &[f64], length: f64) -> Vec<f64> {
    let crossings = series.windows(2).enumerate().filter(|(_, a)| a[0] * a[1] < 0.0);
    crossings.map(|(n, a)| (n as f64 + a[0] / (a[0] - a[1])) * length).collect()
}

/// Ten periods of a wave on water of half the tank's width: the period over the exact one, the amplitude of the last.
fn ten_periods(cells: [usize; 2]) -> [f64; 2] {
    let wave = Wave { depth: 0.5, cells, grading: 1.0, amplitude: 5e-3 };
    let exact = wave.period(G);
    let length = exact / 100.0;
    let series = wave.run(WATER, G, length, 1030);
    let zeros = zeros(&series, length);
    let period = (zeros[20] - zeros[0]) / 10.0;
    let last = series[1000 - 50..].iter().fold(0.0f64, |max, a| max.max(a.abs()));
    [period / exact, last]
}

#[test]
fn the_period_is_that_of_linear_theory_and_ten_periods_keep_volume_and_amplitude() {
    for (cells, error) in [([40, 20], 2e-3), ([80, 40], 1e-3)] {
        let [period, last] = ten_periods(cells);
        println!(
            "standing wave, {cells:?} cells: period {:+.4}, amplitude of the tenth {last:.4}",
            period - 1.0
        );
        assert!((period - 1.0).abs() <= error, "{cells:?}: {period} of the exact one");
        assert!((last - 1.0).abs() <= 0.02, "{last}");
    }
}

#[test]
fn halving_the_step_quarters_the_error() {
    let wave = Wave { depth: 0.5, cells: [16, 8], grading: 1.0, amplitude: 0.02 };
    let ends = [10, 20, 40].map(|steps| wave.run(WATER, 9.81, 0.4 / steps as f64, steps)[steps]);
    let order = ((ends[0] - ends[1]) / (ends[1] - ends[2])).log2();
    assert!((1.8..2.4).contains(&order), "{order} of {ends:?}");
}

/// Largest difference to the solution of Prosperetti, of the first amplitude.
fn decay(reference: &str, viscosity: f64, cells: [usize; 2], end: f64) -> f64 {
    let wave = Wave { depth: 2.0, cells, grading: 3.0, amplitude: 0.01 };
    let fluid = newtonian(1.0, viscosity);
    let length = 0.04;
    let series = wave.run(fluid, 1.0, length, (end / length).round() as usize);
    let rows = reference.lines().filter_map(|line| line.split_once(','));
    let exact: Vec<[f64; 2]> = rows.filter_map(|(t, a)| Some([t.parse().ok()?, a.parse().ok()?])).collect();
    let difference = |row: &[f64; 2]| {
        let (n, rest) = ((row[0] / length) as usize, row[0] / length % 1.0);
        let found = series[n] + rest * (series[(n + 1).min(series.len() - 1)] - series[n]);
        (found - row[1]).abs()
    };
    exact.iter().filter(|row| row[0] <= end - length).map(difference).fold(0.0, f64::max)
}

#[test]
fn viscosity_takes_what_the_solution_of_prosperetti_says() {
    let thick =
        decay(include_str!("../reference/standing_viscous_prosperetti_Re20.csv"), 0.05, [40, 48], 10.0);
    let thin =
        decay(include_str!("../reference/standing_viscous_prosperetti_Re200.csv"), 0.005, [40, 48], 10.0);
    let water =
        decay(include_str!("../reference/standing_viscous_prosperetti_Re2000.csv"), 5e-4, [60, 72], 10.0);
    println!("viscous decay, Re 20, 200, 2000: {thick:.4} {thin:.4} {water:.4} of the first amplitude");
    assert!(thick <= 0.02 && thin <= 0.02 && water <= 0.02, "{thick} {thin} {water}");
}
