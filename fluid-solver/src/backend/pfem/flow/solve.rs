//! One step: geometry, contacts and the linear system until nothing is left.

use super::chunks::for_each;
use super::contact::{Contact, moved};
use super::fault::FlowFault;
use super::krylov::{self, StepOperator, split, split_mut};
use super::nodal::{Assembly, Fields};
use super::porous::Porous;
use super::preconditioner::{Preconditioning, StepPreconditioner};
use super::solution::{FlowSolution, Residuals};
use super::strain::Strain;
use super::suspended::{Part, Suspended};
use super::topology::Topology;
use crate::backend::Step;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::Wall;
use crate::element::simplex::{Vector, dot};
use crate::grains::Suspension;
use linear::{FlexibleGmres, Stopping, vector};
use std::cell::RefCell;

/// Linear iterations between restarts, and the most of a pass.
const ITERATIONS: [usize; 2] = [40, 400];
/// The most passes of a step.
const PASSES: u64 = 20;
/// What a linear solve leaves of the residual that it began with, at most: the geometry changes after it anyway.
const FORCING: f64 = 0.02;
/// Residuals below this share of the sizes of their terms are round-off.
const ROUND_OFF: f64 = 2e-15;

/// The fluid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fluid {
    /// ρ (kg/m³).
    pub density: f64,
    /// μ (Pa s).
    pub viscosity: f64,
    /// κ (Pa); none if incompressible.
    pub bulk_modulus: Option<f64>,
}

/// How accurate a step is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control {
    /// Norm of the residual relative to that of the predictor and of the inertia of the flow.
    pub tolerance: f64,
    /// θ: v_m = v_n + θΔt v′ and v_{n+1} = v_n + Δt v′. One half is of second order and keeps the energy; more damps what
    /// rings from step to step, 1 takes all that an impact leaves.
    pub implicitness: f64,
    /// How far a cell may be strained in a step.
    pub strain: Strain,
}

impl Default for Control {
    fn default() -> Self {
        Self { tolerance: 1e-6, implicitness: 0.5, strain: Strain::default() }
    }
}

/// What acts on the fluid from outside.
#[derive(Clone, Copy, Debug)]
pub struct Forces<'a, const D: usize> {
    /// g (m/s²).
    pub gravity: Vector<D>,
    /// The grains in it, if any.
    pub grains: Option<Suspension<'a, D>>,
}

/// What a step starts from.
#[derive(Clone, Copy)]
struct Start<'a, const D: usize, const N: usize> {
    cloud: &'a Cloud<D, N>,
    walls: &'a [Wall<D>],
    step: Step,
    forces: &'a Forces<'a, D>,
}

impl<const D: usize, const N: usize> Start<'_, D, N> {
    /// The grains, with the cells that they make porous.
    fn suspended<'a>(&'a self, cells: &'a [Porous<D, N>], implicitness: f64) -> Option<Suspended<'a, D, N>> {
        let suspension = self.forces.grains.as_ref()?;
        Some(Suspended { suspension, before: &self.cloud.velocity, implicitness, cells })
    }
}

/// Solves steps; holds nothing that a step depends on but what fluid it is.
pub struct Flow<const D: usize, const N: usize> {
    fluid: Fluid,
    control: Control,
    /// θ of the step.
    implicitness: f64,
    /// Of the mesh that was there last.
    mesh: Option<(Topology<N>, Preconditioning<D>)>,
    assembly: Assembly<D, N>,
    contact: Contact<D>,
    excess: Vec<Vector<D>>,
    porous: Vec<Porous<D, N>>,
    /// The rows at the iterate.
    rows: Vec<f64>,
    /// Their negative in the free directions.
    right: Vec<f64>,
    increment: Vec<f64>,
    krylov: FlexibleGmres,
}

/// How far a solution has come.
#[derive(Clone, Copy, Debug, Default)]
struct Progress {
    passes: u64,
    iterations: u64,
    residuals: Residuals,
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
            excess: Vec::new(),
            porous: Vec::new(),
            rows: Vec::new(),
            right: Vec::new(),
            increment: Vec::new(),
            krylov: FlexibleGmres::new(0, ITERATIONS[0]),
        }
    }

    /// The fluid.
    pub fn fluid(&self) -> &Fluid {
        &self.fluid
    }

    /// Takes another θ from the next step on.
    pub fn set_implicitness(&mut self, implicitness: f64) {
        self.control.implicitness = implicitness;
    }

    /// Largest Δt (s) that keeps the strain of the cells within bounds if the nodes go on as they do; infinite at rest.
    pub fn largest_step(&self, cloud: &Cloud<D, N>) -> f64 {
        self.first_breach(cloud, &cloud.velocity, f64::INFINITY).map_or(f64::INFINITY, |(_, time)| time)
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
        // The middle of a step would turn the part of v round that a blow takes away.
        self.implicitness = if cloud.struck { 1.0 } else { self.control.implicitness };
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
        self.contact.begin(cloud);
        let (mut velocity, mut pressure) = (cloud.velocity.clone(), cloud.pressure.clone());
        self.fly(start, &mesh.0, &mut velocity);
        let progress = self.improve(start, &mut mesh, &mut velocity, &mut pressure);
        self.mesh = Some(mesh);
        if let Some((cell, time)) = self.first_breach(cloud, &velocity, step.length) {
            let place = cloud.place[cloud.cells[cell][0] as usize].to_vec();
            return Err(FlowFault::Inverted { cell, place, length: step.length, bound: 0.9 * time });
        }
        Ok(self.finish(start, velocity, pressure, progress?))
    }

    /// Drops fly, and stop at walls.
    fn fly(&mut self, start: Start<'_, D, N>, topology: &Topology<N>, velocity: &mut [Vector<D>]) {
        let Start { cloud, walls, step, forces } = start;
        for (_, v) in velocity.iter_mut().enumerate().filter(|(node, _)| topology.is_drop(*node)) {
            *v = moved(v, 0.5 * step.length, &forces.gravity);
        }
        self.contact.find(cloud, walls, step, velocity);
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
        let (mut progress, mut target) = (Progress::default(), 0.0);
        loop {
            self.contact.constrain(cloud, walls, step, velocity);
            for (v, constraint) in velocity.iter_mut().zip(&self.contact.constraints) {
                *v = constraint.impose(v);
            }
            self.evaluate(start, topology, velocity, pressure);
            let scale = self.volume_scale(start);
            let (momentum_size, force_size) = self.sizes(start, topology, (velocity, pressure), scale);

            let implicitness = self.implicitness;
            let Self { assembly, excess, porous, contact, right, increment, rows, krylov, .. } = self;
            let grains = start.suspended(porous, implicitness);
            let operator = StepOperator {
                topology,
                constraints: &contact.constraints,
                inertia,
                compressibility,
                scale,
                grains,
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
            }
            let allowed = target.max(ROUND_OFF * force_size);
            if norm <= allowed {
                let [momentum, volume] = sizes.map(|size| size / (momentum_size + force_size).max(norm));
                progress.residuals = Residuals { momentum, volume };
                return Ok(progress);
            }
            if progress.passes == PASSES {
                let Progress { passes, iterations, .. } = progress;
                return Err(FlowFault::NotConverged {
                    time: step.time,
                    passes,
                    iterations,
                    residual: norm,
                    target: allowed,
                });
            }
            if progress.passes == 0 {
                let assembly = &operator.scratch.borrow().assembly;
                let rates = (inertia, compressibility);
                preconditioning.refresh(cloud, topology, assembly, operator.constraints, rates, grains)?;
            }
            increment.fill(0.0);
            let absolute = (FORCING * norm).max(0.5 * allowed);
            let stopping = Stopping { relative: 0.0, absolute, iterations: ITERATIONS[1] };
            let mut preconditioner = StepPreconditioner { operator: &operator, parts: preconditioning };
            let outcome = krylov.solve(&operator, &mut preconditioner, right, increment, stopping);
            progress.iterations += outcome.iterations as u64;
            progress.passes += 1;
            let (dv, dp) = split::<D>(increment);
            vector::axpy(1.0, dv.as_flattened(), velocity.as_flattened_mut());
            vector::axpy(1.0, dp, pressure);
            self.contact.find(cloud, walls, step, velocity);
        }
    }

    /// All rows at (v, p), on the geometry that v leads to.
    fn evaluate(
        &mut self,
        start: Start<'_, D, N>,
        topology: &Topology<N>,
        velocity: &[Vector<D>],
        pressure: &[f64],
    ) {
        let Start { cloud, step, forces, .. } = start;
        let (inertia, compressibility) = (self.inertia(step), self.compressibility(step));
        let Fluid { density, viscosity, .. } = self.fluid;
        // In the middle, whatever θ is: there ∫∇·v is the change of volume.
        let place = |node: usize| moved(&cloud.place[node], 0.5 * step.length, &velocity[node]);
        self.assembly.place(topology, place, inertia, viscosity);
        if let Some(suspension) = &forces.grains {
            let cells = &self.assembly.cells;
            let implicitness = self.implicitness;
            Suspended::fill(suspension, implicitness, topology.cells(), cells, &mut self.porous);
            self.assembly.share_volume(topology, &self.porous);
        }
        for_each(&mut self.excess, |node, e| {
            let (v, before) = (&velocity[node], &cloud.velocity[node]);
            *e = std::array::from_fn(|k| inertia * (v[k] - before[k]) - density * forces.gravity[k]);
        });
        let (momentum, volumes) = split_mut::<D>(&mut self.rows);
        let grains = start.suspended(&self.porous, self.implicitness);
        let grains = grains.map(|grains| (grains, Part::Affine));
        let fields = Fields { velocity, pressure, excess: &self.excess, grains };
        let curvature = if D == 3 { 0.25 * step.length * step.length } else { 0.0 };
        self.assembly.evaluate(topology, fields, curvature, momentum, volumes);
        for_each(volumes, |node, row| {
            let change = pressure[node] - cloud.pressure[node];
            *row += compressibility * self.assembly.volumes[node] * change;
            *row += forces.grains.map_or(0.0, |grains| grains.source[node]);
        });
    }

    /// Rows of volume times (ρ/(θΔt) + d/(θV)) and the spacing have the size of forces (N s/m³).
    fn volume_scale(&self, start: Start<'_, D, N>) -> f64 {
        let (nodes, volumes) = (start.cloud.place.len(), vector::sum(&self.assembly.volumes));
        let drag = start.suspended(&self.porous, self.implicitness).map_or(0.0, |grains| {
            let resistance: f64 = (0..nodes).map(|node| grains.resistance(node)).sum();
            resistance / volumes
        });
        let spacing = (volumes / nodes as f64).powf(1.0 / D as f64);
        (self.inertia(start.step) + drag) * spacing
    }

    /// Norms of (V_i ρ/(θΔt) + d/θ)v, and of the sizes of the terms that make up a force (N).
    fn sizes(
        &mut self,
        start: Start<'_, D, N>,
        topology: &Topology<N>,
        (velocity, pressure): (&[Vector<D>], &[f64]),
        scale: f64,
    ) -> (f64, f64) {
        let inertia = self.inertia(start.step);
        let weight = self.fluid.density * dot(&start.forces.gravity, &start.forces.gravity).sqrt();
        let implicitness = self.implicitness;
        let Self { assembly, porous, right, .. } = self;
        let grains = start.suspended(porous, implicitness);
        let (momentum, force) = right.split_at_mut(velocity.len());
        for_each(momentum, |node, size| {
            let resistance = grains.map_or(0.0, |grains| grains.resistance(node));
            let speed = dot(&velocity[node], &velocity[node]).sqrt();
            *size = (inertia * assembly.volumes[node] + resistance) * speed;
        });
        let force = &mut force[..velocity.len()];
        for_each(force, |node, size| {
            *size = weight * assembly.volumes[node];
            for corner in topology.corners(node) {
                let area = &assembly.cells[corner.cell as usize].areas[corner.local as usize];
                *size += pressure[node].abs() * dot(area, area).sqrt();
            }
            let Some(grains) = &grains else { return };
            // Drag scales volumes where there is none.
            for corner in topology.corners(node) {
                let cell = corner.cell as usize;
                let (area, inverse) =
                    (&assembly.cells[cell].areas[corner.local as usize], assembly.cells[cell].inverse);
                let area = dot(area, area).sqrt();
                let slope = weight + pressure[node].abs() * area * inverse;
                *size += scale * grains.cells[cell].relaxation() * area * slope;
            }
        });
        (vector::norm(momentum), vector::norm(force))
    }

    /// The velocity at the end, and what the walls did.
    ///
    /// Σ m_i (v_{n+1} − v_n) = Δt Σ (forces + reactions) to round-off: what the solver left of the rows of free nodes,
    /// their inner forces having no sum, is taken from all of them alike.
    fn finish(
        &self,
        start: Start<'_, D, N>,
        velocity: Vec<Vector<D>>,
        pressure: Vec<f64>,
        progress: Progress,
    ) -> FlowSolution<D> {
        let Start { cloud, walls, step, forces } = start;
        let (rows, _) = split::<D>(&self.rows);
        let volumes = self.assembly.volumes.iter().zip(&cloud.drop);
        let mass: Vec<f64> = volumes.map(|(volume, drop)| self.fluid.density * (volume + drop)).collect();
        let is_free = |node: usize| self.contact.touched[node].is_empty();
        // Of the velocity at the end.
        let drag = |node: usize| forces.grains.map_or(0.0, |grains| grains.drag.resistance[node]);
        let (mut left, mut resistance) = ([0.0; D], 0.0);
        for node in (0..mass.len()).filter(|&node| is_free(node)) {
            resistance += self.fluid.density * self.assembly.volumes[node] / step.length + drag(node);
            left = moved(&left, 1.0, &rows[node]);
        }
        let drift = left.map(|left| if resistance > 0.0 { left / resistance } else { 0.0 });
        let mut end_velocity = cloud.velocity.clone();
        let mut reaction = vec![[0.0; D]; mass.len()];
        for node in 0..mass.len() {
            let (before, middle) = (&cloud.velocity[node], &velocity[node]);
            let flies = self.assembly.volumes[node] == 0.0;
            let implicitness = if flies { 0.5 } else { self.implicitness };
            let change: Vector<D> = std::array::from_fn(|k| (middle[k] - before[k]) / implicitness);
            let end = &mut end_velocity[node];
            *end = moved(end, 1.0, &change);
            if is_free(node) {
                if !flies {
                    *end = moved(end, -1.0, &drift);
                }
                continue;
            }
            let unheld = *end;
            *end = self.contact.at_end(cloud, walls, step, node, middle, end);
            let other: Vector<D> = if flies {
                forces.gravity.map(|g| mass[node] * g)
            } else {
                std::array::from_fn(|k| mass[node] * change[k] / step.length - rows[node][k])
            };
            reaction[node] = std::array::from_fn(|k| {
                let inertia = mass[node] * (end[k] - before[k]) / step.length;
                inertia + drag(node) * (end[k] - unheld[k]) - other[k]
            });
        }
        FlowSolution {
            velocity,
            end_velocity,
            pressure,
            contacts: self.contact.touched.clone(),
            reaction,
            mass,
            implicitness: self.implicitness,
            iterations: progress.iterations,
            passes: progress.passes,
            residuals: progress.residuals,
        }
    }

    /// ρ/(θΔt) (kg/(m³ s)).
    fn inertia(&self, step: Step) -> f64 {
        self.fluid.density / (self.implicitness * step.length)
    }

    /// 1/(κΔt) (1/(Pa s)).
    fn compressibility(&self, step: Step) -> f64 {
        self.fluid.bulk_modulus.map_or(0.0, |modulus| 1.0 / (modulus * step.length))
    }
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
