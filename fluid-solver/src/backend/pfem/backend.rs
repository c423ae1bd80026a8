//! The particle finite element method as a backend of the coupling.

use super::cloud::Cloud;
use super::flow::{Flow, FlowFault, FlowSolution, Forces, Residuals};
use super::gate::{self, Gates};
use super::grains::{GrainsInCloud, Solved};
use super::remesh::TargetSize;
use super::renewal::Renewal;
use super::seats::seat;
use super::state::State;
use super::wall::Wall;
use crate::backend::{Attempt, FluidBackend, PointValue, Response, Solution, Stages, Step};
use crate::element::simplex::{Vector, dot};
use crate::error::FluidError;
use crate::grains::Spreading;
use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use interface::frames::{GrainRow, ReactionRow, SampleRow};
use interface::ledger::FluidLedger;
use interface::message::{Norms, Surface, TooLarge};
use std::path::{Path, PathBuf};

/// What of a fluid stays the same.
#[derive(Clone, Debug)]
pub struct Setting<const D: usize> {
    /// Its walls.
    pub walls: Vec<Wall<D>>,
    /// Target size of the cells.
    pub size: TargetSize,
    /// Gravity and body force (m/s²).
    pub acceleration: Vector<D>,
    /// ρ (kg/m³).
    pub density: f64,
    /// Whether it feels the grains.
    pub response: Response,
    /// On which nodes the grains act.
    pub spreading: Spreading,
    /// Depth of the slab in 2D, 1 in 3D (m).
    pub depth: f64,
    /// Its surface at the start: what grains may touch.
    pub surface: Option<Surface>,
}

/// A fluid whose nodes move with it.
///
/// The mesh is that of t_n in all iterations of a window and changes when the window is committed, so that to go back is to
/// forget a solution.
pub struct Pfem<const D: usize, const N: usize> {
    pub(super) setting: Setting<D>,
    pub(super) state: State<D, N>,
    flow: Flow<D, N>,
    renewal: Box<dyn Renewal<D, N>>,
    gates: Gates<D>,
    pub(super) grains: GrainsInCloud<D, N>,
    /// Of the iteration solved last in the open window.
    solution: Option<FlowSolution<D>>,
    /// Of the iteration before.
    iterate: Option<FlowSolution<D>>,
    /// Of the step committed last.
    residuals: Residuals,
}

impl<const D: usize, const N: usize> Pfem<D, N> {
    /// A fluid at its start.
    pub fn new(
        setting: Setting<D>,
        cloud: Cloud<D, N>,
        flow: Flow<D, N>,
        renewal: Box<dyn Renewal<D, N>>,
        gates: Gates<D>,
    ) -> Self {
        let state = State::start(cloud, setting.density, &setting.acceleration);
        let grains =
            GrainsInCloud::new(*flow.fluid(), setting.depth, state.cloud.place.len(), setting.spreading);
        Self {
            setting,
            state,
            flow,
            renewal,
            gates,
            grains,
            solution: None,
            iterate: None,
            residuals: Residuals::default(),
        }
    }

    /// The fluid.
    pub fn state(&self) -> &State<D, N> {
        &self.state
    }

    /// Finds the mesh between the nodes where they are, with a node at each grain if these are to have one.
    ///
    /// The momentum of the fluid between the grains is kept, whatever of them the new nodes see.
    fn renew(&mut self, time: f64) -> Result<(), FluidError> {
        let Setting { walls, size, spreading, .. } = &self.setting;
        let State { cloud, books, counts, .. } = &mut self.state;
        let momentum = self.grains.momentum(cloud);
        if *spreading == Spreading::Nodal {
            let mut sizes = Vec::new();
            size.at_nodes(cloud, &mut sizes);
            seat(cloud, &self.grains.positions().collect::<Vec<_>>(), &sizes);
        }
        counts.add(&self.renewal.remesh(cloud, walls, time, size, books)?);
        books.volume.largest_error = books.volume.largest_error.max(books.volume.error().abs());
        self.grains.begin(cloud)?;
        self.grains.keep_momentum(cloud, momentum);
        Ok(())
    }

    /// Energy of the fluid between the grains (J; per m of depth in 2D).
    fn energy(&self) -> f64 {
        let Setting { density, acceleration, .. } = &self.setting;
        let (kinetic, potential) = self.state.energies(*density, acceleration, self.grains.void_fraction());
        kinetic + potential
    }

    /// Changes against the iteration before, or the start of the window.
    fn norms(&self, solution: &FlowSolution<D>) -> Norms {
        let cloud = &self.state.cloud;
        let (before_v, before_p) = match &self.iterate {
            Some(iterate) => (&iterate.end_velocity, &iterate.pressure),
            None => (&cloud.velocity, &cloud.pressure),
        };
        let mass: f64 = linear::vector::sum(&solution.mass);
        if mass == 0.0 {
            return Norms::default();
        }
        let mean = linear::vector::dot(&solution.mass, &cloud.pressure) / mass;
        let rms = |square: &dyn Fn(usize) -> f64| {
            let squares = solution.mass.iter().enumerate().map(|(i, mass)| mass * square(i));
            (squares.sum::<f64>() / mass).sqrt()
        };
        let apart = |a: &Vector<D>, b: &Vector<D>| (0..D).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>();
        Norms {
            velocity_change: rms(&|i| apart(&solution.end_velocity[i], &before_v[i])),
            velocity: rms(&|i| dot(&cloud.velocity[i], &cloud.velocity[i])),
            pressure_change: rms(&|i| (solution.pressure[i] - before_p[i]).powi(2)),
            pressure: rms(&|i| (cloud.pressure[i] - mean).powi(2)),
        }
    }

    /// The books of a step: Σ m(v_{n+1} − v_n), and what nodes exchange, against gravity and walls, each a sum of its own.
    fn ledger(&self, step: Step, solution: &FlowSolution<D>) -> FluidLedger {
        let (cloud, depth) = (&self.state.cloud, self.setting.depth);
        let mut ledger = FluidLedger::default();
        for (i, mass) in solution.mass.iter().map(|mass| depth * mass).enumerate() {
            for k in 0..D {
                let rate = mass * (solution.end_velocity[i][k] - cloud.velocity[i][k]);
                let body = step.length * mass * self.setting.acceleration[k];
                let boundary = step.length * depth * solution.reaction[i][k];
                ledger.momentum[k] += mass * solution.end_velocity[i][k];
                ledger.rate[k] += rate;
                ledger.body[k] += body;
                ledger.boundary[k] += boundary;
                ledger.scale += rate.abs() + body.abs() + boundary.abs();
            }
            ledger.volume += mass / self.setting.density;
            ledger.kinetic_energy += 0.5 * mass * dot(&solution.end_velocity[i], &solution.end_velocity[i]);
        }
        for k in 0..D {
            let exchange = step.length * depth * solution.exchange[k];
            ledger.rate[k] += exchange;
            ledger.scale += exchange.abs();
        }
        self.grains.book(step, solved(solution), self.setting.response, &mut ledger);
        ledger
    }
}

/// A solution as grains feel it.
fn solved<const D: usize>(solution: &FlowSolution<D>) -> Solved<'_, D> {
    let FlowSolution { velocity, end_velocity, pressure, .. } = solution;
    Solved { carrier: velocity, velocity: end_velocity, pressure }
}

/// The answer to a step that cannot be made: shorter, where that helps.
fn refusal(fault: FlowFault, step: Step) -> Result<Attempt, FluidError> {
    let reason = fault.to_string();
    match fault {
        FlowFault::Inverted { bound, .. } => Ok(Attempt::TooLarge(TooLarge { bound, reason })),
        FlowFault::NotConverged { .. } => {
            Ok(Attempt::TooLarge(TooLarge { bound: 0.5 * step.length, reason }))
        }
        fault => Err(fault.into()),
    }
}

impl<const D: usize, const N: usize> FluidBackend for Pfem<D, N> {
    fn nodes(&self) -> u64 {
        self.state.cloud.place.len() as u64
    }

    fn notes(&self) -> Vec<String> {
        let cloud = &self.state.cloud;
        vec![
            format!("{} nodes, {} cells at the start", cloud.place.len(), cloud.cells.len()),
            format!("volume {:.6e} m^3 at the start", self.setting.depth * self.state.books.volume.target),
            format!("{} walls, those of corners counted apart, inlets too", self.setting.walls.len()),
        ]
    }

    fn surface(&self) -> Option<Surface> {
        self.setting.surface.clone()
    }

    fn largest_step(&self) -> f64 {
        self.flow.largest_step(&self.state.cloud)
    }

    fn populate(&mut self, time: f64, grains: &[GrainRow]) -> Result<(), FluidError> {
        let before = self.energy();
        let are_others = self.grains.populate(&self.state.cloud, grains)?;
        if are_others && self.setting.spreading == Spreading::Nodal && !grains.is_empty() {
            self.renew(time)?;
            self.grains.populate(&self.state.cloud, grains)?;
        }
        if are_others {
            self.state.fluid_volume = self.state.books.volume.target - self.grains.wetted_volume();
            self.state.given += self.energy() - before;
        }
        Ok(())
    }

    fn save(&mut self) {
        (self.solution, self.iterate) = (None, None);
        self.grains.forget(&self.state.cloud);
    }

    fn restore(&mut self) {
        self.iterate = self.solution.take();
        if let Some(solution) = &self.iterate {
            self.grains.remember(solved(solution));
        }
    }

    fn project(&mut self, step: Step, grains: &[GrainRow]) -> Result<(), FluidError> {
        self.grains.project(&self.state.cloud, step, grains)
    }

    fn solve(&mut self, step: Step, reactions: &[ReactionRow]) -> Result<Attempt, FluidError> {
        gate::prescribe(&mut self.setting.walls, &self.state.cloud, step);
        let Setting { walls, acceleration, response, .. } = &self.setting;
        let suspension = self.grains.react(step, reactions).filter(|_| *response == Response::TwoWay);
        let forces = Forces { gravity: *acceleration, grains: suspension };
        let solution = match self.flow.solve(&self.state.cloud, walls, step, &forces) {
            Ok(solution) => solution,
            Err(fault) => return refusal(fault, step),
        };
        self.grains.feel(&self.state.cloud, step, solved(&solution));
        let answer = Solution {
            norms: self.norms(&solution),
            ledger: self.ledger(step, &solution),
            iterations: solution.iterations,
        };
        self.solution = Some(solution);
        Ok(Attempt::Solved(Box::new(answer)))
    }

    fn prepare_samples(&mut self) {
        self.grains.prepare_samples();
    }

    fn sample(&self, row: usize) -> SampleRow {
        self.grains.sample(row)
    }

    fn commit(&mut self, step: Step) -> Result<(), FluidError> {
        let Some(solution) = self.solution.take() else { return Ok(()) };
        let Setting { walls, size, response, acceleration, density, .. } = &mut self.setting;
        size.see_grains(self.grains.void_fraction());
        let work = solution.reaction.iter().zip(&solution.velocity).map(|(force, v)| dot(force, v));
        // What friction turns into heat walls did not give.
        self.state.given += step.length * (work.sum::<f64>() + solution.friction);
        self.residuals = solution.residuals;
        let passed = self.gates.advance(&mut self.state.cloud, walls, step, &solution, acceleration);
        self.state.pass(&passed, *density);
        if *response == Response::TwoWay {
            self.state.books.volume.target = self.state.fluid_volume + self.grains.wetted_volume();
        }
        self.renew(step.end())
    }

    fn at(&self, _time: f64, point: [f64; 3]) -> Option<PointValue> {
        super::probe::at(&self.state.cloud, &std::array::from_fn(|k| point[k]), &self.setting.size)
    }

    fn elevation(&self, point: [f64; 3]) -> Option<f64> {
        super::probe::elevation(&self.state.cloud, &std::array::from_fn(|k| point[k]))
    }

    fn has_surface(&self) -> bool {
        true
    }

    fn statistics(&self, _time: f64) -> Vec<(&'static str, f64)> {
        super::output::statistics(&self.state, &self.setting, &self.grains, self.residuals)
    }

    fn stages(&self) -> Stages {
        [self.flow.spent(), self.renewal.spent().stages()].into_iter().sum()
    }

    fn audits(&self) -> Vec<(&'static str, f64)> {
        super::output::audits(&self.state, &self.setting, &self.grains)
    }

    fn counters(&self) -> Vec<(String, u64)> {
        self.state.counts.named().map(|(name, count)| (name.to_string(), count)).to_vec()
    }

    fn write_frame(&self, stem: &Path, compress: bool) -> Result<Option<PathBuf>, FluidError> {
        super::output::write_frame(
            &self.state.cloud,
            self.grains.void_fraction(),
            &stem.with_extension("vtu"),
            compress,
        )
        .map(Some)
    }

    fn save_checkpoint<'a>(&'a self, writer: CheckpointWriter<'a>) -> CheckpointWriter<'a> {
        super::checkpoint::save(&self.state, writer)
            .array::<f64>("samples", bytemuck::cast_slice(self.grains.samples()))
    }

    fn load_checkpoint(&mut self, checkpoint: &Checkpoint) -> Result<(), FluidError> {
        self.state = super::checkpoint::load(checkpoint)?;
        self.grains.begin(&self.state.cloud)?;
        let samples: Vec<f64> = checkpoint.array("samples")?;
        let samples: &[SampleRow] = bytemuck::try_cast_slice(&samples).unwrap_or_default();
        self.grains.resume(samples.to_vec());
        self.save();
        Ok(())
    }
}
