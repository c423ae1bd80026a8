//! The flow as a backend of the coupling.

use super::flow::{Flow, Properties};
use super::state::State;
use crate::backend::{Attempt, FluidBackend, PointValue, Response, Solution, Stages, Step};
use crate::element::simplex::{Vector, in_space};
use crate::error::FluidError;
use crate::grains::{Exchange, FixedMesh, GrainsOnMesh, Medium, Recovered, Taken};
use crate::mesh::locate::Location;
use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use interface::frames::{GrainRow, ReactionRow, SampleRow};
use interface::ledger::FluidLedger;
use interface::message::{Norms, Surface};
use std::path::{Path, PathBuf};

/// Largest Courant number |u|Δt/h: the scheme is implicit, this bounds the error in time.
const COURANT: f64 = 2.0;

/// Stabilised finite elements on a fixed mesh.
pub struct Eulerian<const D: usize, const N: usize> {
    pub(super) flow: Flow<D, N>,
    pub(super) grains: GrainsOnMesh<D>,
    placing: FixedMesh<D>,
    response: Response,
    /// Depth of the slab in 2D (m).
    depth: f64,
    saved: State<D>,
    /// u and p of the last iteration of the open window.
    iterate: Option<(Vec<Vector<D>>, Vec<f64>)>,
    recovered: Vec<Recovered<D>>,
    /// Takes the place of the grains where the fluid does not feel them.
    nobody: Exchange<D>,
}

impl<const D: usize, const N: usize> Eulerian<D, N> {
    /// A flow that grains may be placed in; in 2D a slab of `depth` (m).
    pub fn new(flow: Flow<D, N>, response: Response, depth: f64) -> Self {
        Self {
            grains: GrainsOnMesh::new(flow.mesh().node_count()),
            placing: FixedMesh::new(flow.mesh()),
            saved: flow.state().clone(),
            flow,
            response,
            depth,
            iterate: None,
            recovered: Vec::new(),
            nobody: Exchange::default(),
        }
    }

    /// The flow.
    pub fn flow(&self) -> &Flow<D, N> {
        &self.flow
    }

    fn norms(&self) -> Norms {
        let (state, measure) = (self.flow.state(), self.flow.mesh().measure());
        let (before_u, before_p) = match &self.iterate {
            Some((u, p)) => (u, p),
            None => (&self.saved.velocity, &self.saved.pressure),
        };
        let volume: f64 = linear::vector::sum(measure);
        let mean = linear::vector::dot(measure, &self.saved.pressure) / volume;
        let square = |u: &Vector<D>| u.iter().map(|c| c * c).sum::<f64>();
        let change =
            |i: usize| -> Vector<D> { std::array::from_fn(|k| state.velocity[i][k] - before_u[i][k]) };
        let rms = |squares: &dyn Fn(usize) -> f64| {
            (measure.iter().enumerate().map(|(i, m)| m * squares(i)).sum::<f64>() / volume).sqrt()
        };
        Norms {
            velocity_change: rms(&|i| square(&change(i))),
            velocity: rms(&|i| square(&self.saved.velocity[i])),
            pressure_change: rms(&|i| (state.pressure[i] - before_p[i]).powi(2)),
            pressure: rms(&|i| (self.saved.pressure[i] - mean).powi(2)),
        }
    }

    /// In one-way coupling whatever drives the fluid takes what the grains give.
    fn book_one_way(&self, step: Step, ledger: &mut FluidLedger) {
        let (velocity, measure) = (&self.flow.state().velocity, self.flow.mesh().measure());
        let Taken { drag, stress, explicit, scale } = self.grains.taken(velocity, &self.recovered, measure);
        let impulse = self.depth * step.length;
        let [drag, stress, explicit] = [drag, stress, explicit].map(|f| in_space(&f).map(|f| f * impulse));
        for k in 0..3 {
            ledger.drag[k] += drag[k];
            ledger.stress[k] += stress[k];
            ledger.explicit[k] += explicit[k];
            ledger.boundary[k] += drag[k] + stress[k] - explicit[k];
            ledger.scale += stress[k].abs();
        }
        ledger.scale += impulse * scale;
    }
}

impl<const D: usize, const N: usize> FluidBackend for Eulerian<D, N> {
    fn nodes(&self) -> u64 {
        self.flow.mesh().node_count() as u64
    }

    fn notes(&self) -> Vec<String> {
        let mesh = self.flow.mesh();
        let (smallest, largest) =
            mesh.size().iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &h| (a.min(h), b.max(h)));
        vec![
            format!("{} nodes, {} cells", mesh.node_count(), mesh.cells().len()),
            format!("mesh size {smallest:.4e} m to {largest:.4e} m"),
            format!("largest window {:.4e} s (Courant number {COURANT})", self.largest_step()),
        ]
    }

    fn surface(&self) -> Option<Surface> {
        Some(self.flow.mesh().surface())
    }

    fn largest_step(&self) -> f64 {
        let speeds = self.flow.state().velocity.iter().zip(self.flow.mesh().size());
        let bound = |(u, h): (&Vector<D>, &f64)| COURANT * h / u.iter().map(|c| c * c).sum::<f64>().sqrt();
        speeds.map(bound).fold(f64::INFINITY, f64::min)
    }

    fn populate(&mut self, _time: f64, grains: &[GrainRow]) -> Result<(), FluidError> {
        self.placing.admit(self.flow.mesh(), grains)?;
        self.grains.place(self.flow.mesh(), grains, &mut self.placing)?;
        if self.response == Response::TwoWay {
            self.flow.state_mut().reset_void_fraction(&self.grains.void_fraction);
        }
        if self.grains.count() > 0 {
            self.flow.recover(&mut self.recovered);
        }
        Ok(())
    }

    fn save(&mut self) {
        self.saved.copy_from(self.flow.state());
        self.iterate = None;
    }

    fn restore(&mut self) {
        let state = self.flow.state_mut();
        let (velocity, pressure) = self.iterate.get_or_insert_default();
        velocity.clone_from(&state.velocity);
        pressure.clone_from(&state.pressure);
        state.copy_from(&self.saved);
    }

    fn project(&mut self, _step: Step, grains: &[GrainRow]) -> Result<(), FluidError> {
        self.grains.place(self.flow.mesh(), grains, &mut self.placing)?;
        if self.response == Response::TwoWay {
            self.flow.state_mut().void_fraction.copy_from_slice(&self.grains.void_fraction);
        }
        Ok(())
    }

    fn solve(&mut self, step: Step, reactions: &[ReactionRow]) -> Result<Attempt, FluidError> {
        self.grains.react(reactions, self.depth);
        let exchange = if self.response == Response::TwoWay { &self.grains.exchange } else { &self.nobody };
        let iterate = self.iterate.as_ref().map(|(u, p)| (u.as_slice(), p.as_slice()));
        let iterations = self.flow.solve(step, exchange, iterate)?;
        if self.grains.count() > 0 {
            self.flow.recover(&mut self.recovered);
        } else {
            self.recovered.clear();
        }
        let mut ledger = match self.response {
            Response::TwoWay => self.flow.ledger(step, self.depth, exchange, &self.recovered),
            Response::OneWay => self.flow.ledger(step, self.depth, exchange, &[]),
        };
        if self.response == Response::OneWay && self.grains.count() > 0 {
            self.book_one_way(step, &mut ledger);
        }
        Ok(Attempt::Solved(Box::new(Solution { norms: self.norms(), ledger, iterations })))
    }

    fn prepare_samples(&mut self) {
        if self.grains.count() > 0 {
            self.grains.sample(&self.flow.state().velocity, &self.recovered);
        }
    }

    fn sample(&self, row: usize) -> SampleRow {
        let Properties { density, viscosity, .. } = *self.flow.properties();
        self.grains.row(row, self.flow.mesh().measure(), Medium { density, viscosity }, self.depth)
    }

    fn commit(&mut self, step: Step) -> Result<(), FluidError> {
        self.flow.commit(step);
        Ok(())
    }

    fn at(&self, _time: f64, point: [f64; 3]) -> Option<PointValue> {
        let (mesh, state) = (self.flow.mesh(), self.flow.state());
        let x: Vector<D> = std::array::from_fn(|k| point[k]);
        let Location::Inside { cell, coordinates } = self.placing.locator().locate(mesh, &x, None) else {
            return None;
        };
        let nodes = mesh.cell_nodes(cell as usize);
        let velocity = std::array::from_fn(|k| {
            (0..N).map(|i| coordinates[i] * state.velocity[nodes[i] as usize][k]).sum::<f64>()
        });
        Some(PointValue {
            velocity: in_space::<D>(&velocity),
            pressure: mesh.interpolate(&state.pressure, cell as usize, &coordinates),
            void_fraction: mesh.interpolate(&state.void_fraction, cell as usize, &coordinates),
        })
    }

    fn stages(&self) -> Stages {
        self.flow.spent()
    }

    fn statistics(&self, _time: f64) -> Vec<(&'static str, f64)> {
        self.flow.statistics(self.depth)
    }

    fn write_frame(&self, stem: &Path, compress: bool) -> Result<Option<PathBuf>, FluidError> {
        self.flow.write_frame(&stem.with_extension("vtu"), compress).map(Some)
    }

    fn save_checkpoint<'a>(&'a self, writer: CheckpointWriter<'a>) -> CheckpointWriter<'a> {
        let writer = self.flow.save_checkpoint(writer);
        writer.array("diameters", self.placing.diameters().map_or(&[], |range| range.as_slice()))
    }

    fn load_checkpoint(&mut self, checkpoint: &Checkpoint) -> Result<(), FluidError> {
        self.flow.load_checkpoint(checkpoint)?;
        let range: Vec<f64> = checkpoint.array("diameters")?;
        self.placing.prepare(self.flow.mesh(), range.first_chunk().copied())?;
        self.save();
        Ok(())
    }
}
