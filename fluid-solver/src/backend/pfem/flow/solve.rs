//! One step: geometry, contacts and the linear system until nothing is left.

use super::contact::Contact;
use super::fault::FlowFault;
use super::krylov::{self, StepOperator, split, split_mut};
use super::nodal::Assembly;
use super::porous::Porous;
use super::preconditioner::{Preconditioning, Rates};
use super::projection::Projected;
use super::rebound::Rebound;
use super::scheme::{Correct, Iterate, Verdict};
use super::setting::{Control, Fluid, Forces};
use super::solution::{FlowSolution, Residuals};
use super::suspended::Suspended;
use super::topology::Topology;
use super::wall_function::Friction;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::Wall;
use crate::backend::{Stages, Step};
use crate::element::simplex::{Vector, dot};
use interface::usage::ThreadClock;
use linear::vector;
use std::cell::RefCell;

/// A time after all others (s) whose third power is a number.
const NEVER: f64 = 1e60;

/// Least θ with grains where v_{n+1} is not freed of its rebound (compressible fluids, schemes that do not project):
/// 0.6 + ½(1 − ε), at most 1, ε being the least void fraction.
///
/// The divergence of v_m follows the grains from step to step, and a step turns the share 1/θ − 1 of what the last one left
/// of it round: the denser they are the more they feed on it.
fn least_implicitness(void_fraction: &[f64]) -> f64 {
    let densest = 1.0 - void_fraction.iter().copied().fold(1.0, f64::min);
    (0.6 + 0.5 * densest).min(1.0)
}

/// Residuals below this share of the sizes of their terms are round-off.
const ROUND_OFF: f64 = 2e-15;
/// What so many passes have not solved may be as near as places tell.
const STALLED: u64 = 5;
/// Forces that grow by this factor within a step do not converge.
const GROWN: f64 = 1e6;

/// What a step starts from.
#[derive(Clone, Copy)]
pub(super) struct Start<'a, const D: usize, const N: usize> {
    pub(super) cloud: &'a Cloud<D, N>,
    pub(super) walls: &'a [Wall<D>],
    pub(super) step: Step,
    pub(super) forces: &'a Forces<'a, D>,
}

impl<const D: usize, const N: usize> Start<'_, D, N> {
    /// The grains, with the cells that they make porous.
    pub(super) fn suspended<'a>(
        &'a self,
        cells: &'a [Porous<D, N>],
        implicitness: f64,
    ) -> Option<Suspended<'a, D, N>> {
        let suspension = self.forces.grains.as_ref()?;
        Some(Suspended { suspension, before: &self.cloud.velocity, implicitness, cells })
    }
}

/// Solves steps; holds nothing that a step depends on but what fluid it is.
pub struct Flow<const D: usize, const N: usize> {
    pub(super) fluid: Fluid,
    control: Control,
    /// θ of the step.
    pub(super) implicitness: f64,
    /// Of the mesh that was there last.
    mesh: Option<(Topology<N>, Preconditioning<D>)>,
    pub(super) assembly: Assembly<D, N>,
    pub(super) contact: Contact<D>,
    pub(super) friction: Friction<D>,
    pub(super) excess: Vec<Vector<D>>,
    pub(super) projected: Projected<D>,
    pub(super) rebound: Rebound<D>,
    pub(super) porous: Vec<Porous<D, N>>,
    /// The rows at the iterate.
    pub(super) rows: Vec<f64>,
    /// Their negative in the free directions.
    pub(super) right: Vec<f64>,
    increment: Vec<f64>,
    pub(super) scheme: Box<dyn Correct<D, N>>,
    pub(super) spent: Stages,
}

/// How far a solution has come.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Progress {
    pub(super) passes: u64,
    pub(super) iterations: u64,
    pub(super) residuals: Residuals,
}

impl<const D: usize, const N: usize> Flow<D, N> {
    /// Of this fluid.
    pub fn new(fluid: Fluid, control: Control) -> Self {
        Self {
            fluid,
            control,
            implicitness: control.implicitness,
            mesh: None,
            assembly: Assembly::default(),
            contact: Contact::default(),
            friction: Friction::default(),
            excess: Vec::new(),
            projected: Projected::default(),
            rebound: Rebound::new(),
            porous: Vec::new(),
            rows: Vec::new(),
            right: Vec::new(),
            increment: Vec::new(),
            scheme: control.scheme.solver(),
            spent: Stages::default(),
        }
    }

    /// The fluid.
    pub fn fluid(&self) -> &Fluid {
        &self.fluid
    }

    /// Where the time went.
    pub fn spent(&self) -> Stages {
        self.spent
    }

    /// Largest Δt (s) that keeps the strain of the cells within bounds if the nodes go on as they do; infinite at rest.
    pub fn largest_step(&self, cloud: &Cloud<D, N>) -> f64 {
        self.first_breach(cloud, &cloud.velocity, NEVER).map_or(f64::INFINITY, |(_, time)| time)
    }

    /// The cell that leaves its bounds first, and when.
    fn first_breach(&self, cloud: &Cloud<D, N>, v: &[Vector<D>], horizon: f64) -> Option<(usize, f64)> {
        let (mut first, mut horizon) = (None, horizon);
        for (index, cell) in cloud.cells.iter().enumerate() {
            let (corners, v) = (cloud.vertices(cell), cell.map(|node| v[node as usize]));
            if let Some(time) = self.control.strain.first_breach(&corners, &v, horizon) {
                (first, horizon) = (Some((index, time)), time);
            }
        }
        first
    }

    /// Solves for velocity and pressure in the middle of a step from the cloud at its start.
    ///
    /// # Errors
    /// A step that is too large for the mesh, with a bound; a number that is not finite.
    pub fn solve(
        &mut self,
        cloud: &Cloud<D, N>,
        walls: &[Wall<D>],
        step: Step,
        forces: &Forces<'_, D>,
    ) -> Result<FlowSolution<D>, FlowFault> {
        let start = Start { cloud, walls, step, forces };
        let stated = self.scheme.implicitness(self.control.implicitness);
        self.implicitness = match &forces.grains {
            // What a yield stress has stopped would be turned round in each step.
            _ if !self.fluid.rheology.is_newtonian() => 1.0,
            Some(grains) if !self.rebounds(start) => stated.max(least_implicitness(grains.void_fraction)),
            _ => stated,
        };
        let nodes = cloud.place.len();
        let mut mesh = match self.mesh.take() {
            Some(mesh) if mesh.0.is_of(nodes, &cloud.cells) => mesh,
            _ => {
                let topology = Topology::new(nodes, &cloud.cells)?;
                let preconditioning = Preconditioning::new(&topology);
                (topology, preconditioning)
            }
        };
        self.excess.resize(nodes, [0.0; D]);
        for rows in [&mut self.rows, &mut self.right, &mut self.increment] {
            rows.resize((D + 1) * nodes, 0.0);
        }
        self.assembly.begin(cloud.cells.len(), &self.fluid.rheology);
        self.contact.begin(cloud);
        self.friction.begin(cloud, walls, step);
        self.friction.evaluate(&self.fluid, self.implicitness, &cloud.velocity, &cloud.velocity);
        self.project(start, &mut mesh)?;
        let (mut velocity, mut pressure) = (self.projected.velocity.clone(), cloud.pressure.clone());
        self.fly(start, &mesh.0, &mut velocity);
        let progress = self.improve(start, &mut mesh, &mut velocity, &mut pressure);
        if progress.is_ok() {
            self.take_rebound(start, &mut mesh, &velocity);
        }
        self.mesh = Some(mesh);
        if let Err(fault @ FlowFault::RoundEnd { .. }) = progress {
            return Err(fault);
        }
        if let Some((cell, time)) = self.first_breach(cloud, &velocity, step.length) {
            let place = cloud.place[cloud.cells[cell][0] as usize].to_vec();
            // What did not converge has velocities that say little.
            let least = if progress.is_ok() { 0.0 } else { 0.25 * step.length };
            let bound = least.max(0.9 * time);
            return Err(FlowFault::Inverted { cell, place, length: step.length, bound });
        }
        Ok(self.finish(start, velocity, pressure, progress?))
    }

    /// Improves (v, p) until the residual on its own geometry is small.
    fn improve(
        &mut self,
        start: Start<'_, D, N>,
        (topology, preconditioning): &mut (Topology<N>, Preconditioning<D>),
        velocity: &mut [Vector<D>],
        pressure: &mut [f64],
    ) -> Result<Progress, FlowFault> {
        let Start { cloud, walls, step, .. } = start;
        let inertia = self.inertia(step);
        let compressibility = self.compressibility(step);
        let is_plastic = !self.fluid.rheology.is_newtonian();
        let (mut progress, mut target, mut limit) = (Progress::default(), 0.0, 0.0);
        let (mut change, mut met) = (f64::INFINITY, 0);
        let projects = self.projects(start);
        let mut clock = ThreadClock::start();
        loop {
            self.contact.constrain(cloud, walls, step, velocity);
            for (v, constraint) in velocity.iter_mut().zip(&self.contact.constraints) {
                *v = constraint.impose(v);
            }
            self.evaluate(start, topology, velocity, pressure);
            let scale = self.volume_scale(start);
            let gap_size = if progress.passes < STALLED { 0.0 } else { self.gap_size(start) };
            let (momentum_size, force_size) = self.sizes(start, topology, (velocity, pressure), scale);

            let implicitness = self.implicitness;
            let Self {
                assembly,
                excess,
                porous,
                contact,
                friction,
                right,
                increment,
                rows,
                scheme,
                spent,
                ..
            } = self;
            let grains = start.suspended(porous, implicitness);
            let operator = StepOperator {
                topology,
                constraints: &contact.constraints,
                inertia,
                compressibility,
                scale,
                grains,
                friction,
                scratch: RefCell::new(krylov::Scratch { assembly, excess }),
            };
            right.copy_from_slice(rows);
            vector::scale(-1.0, right);
            let (momentum, volumes) = split_mut::<D>(right);
            operator.restrict(momentum, volumes);
            let sizes = [vector::norm(momentum.as_flattened()), vector::norm(volumes)];
            let norm = sizes[0].hypot(sizes[1]);
            if !norm.is_finite() {
                return Err(not_finite::<D>(rows, step));
            }
            if progress.passes == 0 {
                target = self.control.tolerance * (norm + momentum_size);
                limit = GROWN * (norm + momentum_size + force_size);
            }
            let allowed = target.max(ROUND_OFF * force_size.hypot(gap_size));
            let [momentum, volume] = sizes.map(|size| size / (momentum_size + force_size).max(norm));
            progress.residuals = Residuals { momentum, volume };
            let Progress { passes, iterations, .. } = progress;
            let iterate = Iterate { passes, residual: norm, allowed, change, met, is_plastic };
            // Round-off of forces that grow without end would be taken for convergence.
            let verdict = if norm + force_size > limit { Verdict::Failed } else { scheme.judge(&iterate) };
            match verdict {
                Verdict::Done => {
                    return match self.contact.round_end {
                        None => Ok(progress),
                        Some((node, wall)) => Err(FlowFault::RoundEnd {
                            place: cloud.place[node].to_vec(),
                            wall: walls[wall].name.clone(),
                        }),
                    };
                }
                Verdict::Again => {}
                Verdict::Failed => {
                    let (time, target) = (step.time, allowed);
                    let place = cloud.place[worst::<D>(right)].to_vec();
                    return Err(FlowFault::NotConverged {
                        time,
                        passes,
                        iterations,
                        residual: norm,
                        target,
                        place,
                    });
                }
            }
            spent.assembly += clock.lap();
            if is_plastic || passes == 0 && !projects {
                let assembly = &operator.scratch.borrow().assembly;
                let rates = Rates { inertia, compressibility, mobility: scheme.mobility(), friction };
                preconditioning.refresh(cloud, topology, assembly, operator.constraints, rates, grains)?;
            }
            progress.iterations += scheme.correct(&iterate, &operator, preconditioning, right, increment);
            progress.passes += 1;
            spent.solve += clock.lap();
            let (dv, dp) = split::<D>(increment);
            operator.scratch.borrow_mut().assembly.advance(topology, velocity, dv);
            vector::axpy(1.0, dv.as_flattened(), velocity.as_flattened_mut());
            vector::axpy(1.0, dp, pressure);
            let share =
                |change: &[f64], of: &[f64]| vector::norm(change) / vector::norm(of).max(f64::MIN_POSITIVE);
            change = share(dv.as_flattened(), velocity.as_flattened()).max(share(dp, pressure));
            met = self.contact.find(cloud, walls, step, velocity);
        }
    }

    /// ρ/(θΔt) (kg/(m³ s)).
    pub(super) fn inertia(&self, step: Step) -> f64 {
        self.fluid.density / (self.implicitness * step.length)
    }

    /// 1/(κΔt) (1/(Pa s)).
    pub(super) fn compressibility(&self, step: Step) -> f64 {
        self.fluid.bulk_modulus.map_or(0.0, |modulus| 1.0 / (modulus * step.length))
    }
}

/// The node with the largest force in these rows.
fn worst<const D: usize>(rows: &[f64]) -> usize {
    let (forces, _) = split::<D>(rows);
    let sizes = forces.iter().map(|force| dot(force, force)).enumerate();
    sizes.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(node, _)| node)
}

/// The first row that is not finite.
fn not_finite<const D: usize>(rows: &[f64], step: Step) -> FlowFault {
    let (momentum, volumes) = split::<D>(rows);
    let faulty = momentum.as_flattened().iter().position(|value| !value.is_finite());
    let (node, quantity, value) = match faulty {
        Some(place) => (place / D, "force", momentum.as_flattened()[place]),
        None => {
            let node = volumes.iter().position(|value| !value.is_finite()).unwrap_or(0);
            (node, "volume row", volumes[node])
        }
    };
    FlowFault::NonFinite { node, quantity, value, time: step.time }
}
