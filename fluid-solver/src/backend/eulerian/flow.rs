//! The flow on its mesh: one linear system per step.

use super::assembly::{AssemblyScratch, Ingredients};
use super::balance::balance_momentum;
use super::exchange::{Exchange, Part};
use super::incidence::Incidence;
use super::krylov::{StepOperator, StepPreconditioner, VelocitySolver, split, split_mut};
use super::matrices::{Matrices, ProductScratch};
use super::outlet::Outlets;
use super::schur::Schur;
use super::state::State;
use super::time_rule::TimeRule;
use super::velocity_multigrid::VelocityMultigrid;
use super::velocity_sweep::VelocitySweep;
use crate::backend::Step;
use crate::boundary::{Boundaries, Constraints};
use crate::element::simplex::{Vector, difference, dot};
use crate::error::FluidError;
use crate::mesh::Mesh;
use linear::{FlexibleGmres, Pattern, Stopping, Verdict, vector};
use std::cell::RefCell;
use std::sync::Arc;

/// Numbers that the bases of the Krylov method may hold before it restarts, and the range of iterations kept.
const BASES: usize = 40_000_000;
const RESTART: std::ops::RangeInclusive<usize> = 50..=400;
/// Iterations after which a step is given up.
const MOST_ITERATIONS: usize = 600;
/// Above this μ/(a₀ρh²) the velocity is preconditioned by multigrid.
const VISCOUS: f64 = 5.0;
/// The residual cannot fall below this share of the terms it is made of.
const ROUND_OFF: f64 = 1e-15;

/// What the fluid is and what drives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Properties<const D: usize> {
    /// Density ρ (kg/m³).
    pub density: f64,
    /// Dynamic viscosity μ (Pa s).
    pub viscosity: f64,
    /// Gravity g (m/s²).
    pub gravity: Vector<D>,
    /// Residual at which the linear solver stops, relative to the forces of the step.
    pub tolerance: f64,
}

/// An incompressible fluid between grains, model A of the volume-averaged Navier–Stokes equations:
///
/// ∂(ρεu)/∂t + ∇·(ρε u⊗u) = −ε∇p + ε∇·τ + ρε(g + b) − drag, ∂ε/∂t + ∇·(εu) = 0.
///
/// P1 for u and p with orthogonal subscales, second-order backward differences, convecting velocity extrapolated.
///
/// Source: Anderson and Jackson, *Ind. Eng. Chem. Fundam.* 6 (1967) 527; Codina, *Comput. Methods Appl. Mech. Engrg.*
/// 191 (2002) 4295.
pub struct Flow<const D: usize, const N: usize> {
    pub(super) mesh: Mesh<D, N>,
    pub(super) incidence: Incidence<N>,
    pub(super) constraints: Constraints<D>,
    pub(super) outlets: Outlets<D>,
    pub(super) enclosed: bool,
    pub(super) properties: Properties<D>,
    /// g + b at the nodes (m/s²).
    pub(super) acceleration: Vec<Vector<D>>,
    pub(super) state: State<D>,
    pub(super) work: Workspace<D>,
}

/// Scratch of a step, and what its solution leaves for the ledger.
pub(super) struct Workspace<const D: usize> {
    pub matrices: Matrices<D>,
    pub schur: Schur,
    /// a (m/s).
    pub convecting: Vec<Vector<D>>,
    /// Left less right-hand side at the solution: force of the boundary on each node (N); net outflow (m³/s).
    pub rows: Vec<f64>,
    /// The time rule of the step.
    pub rule: TimeRule,
    assembly: AssemblyScratch<D>,
    sweep: VelocitySweep<D>,
    multigrid: VelocityMultigrid,
    krylov: FlexibleGmres,
    drag: Vec<f64>,
    drag_diagonal: Vec<f64>,
    drag_density: Vec<f64>,
    inertia: Vec<f64>,
    mobility: Vec<f64>,
    viscous: Vec<f64>,
    right: Vec<f64>,
    increment: Vec<f64>,
    volumes: Vec<f64>,
    forces: Vec<Vector<D>>,
    product: ProductScratch<D>,
}

impl<const D: usize, const N: usize> Flow<D, N> {
    /// A fluid at rest in hydrostatic pressure, with conditions on its boundaries.
    ///
    /// # Errors
    /// An inlet that cannot pass the speed stated.
    pub fn new(mesh: Mesh<D, N>, boundaries: &Boundaries<D>, properties: Properties<D>) -> Result<Self, FluidError> {
        let nodes = mesh.node_count();
        let elements = (0..mesh.cells().len()).map(|cell| mesh.cell_nodes(cell));
        let pattern = Arc::new(Pattern::from_elements(nodes, elements)?);
        let weight: Vector<D> = std::array::from_fn(|k| match mesh.periodicity().0[k] {
            // No pressure balances gravity along a periodic axis.
            Some(_) => 0.0,
            None => properties.density * properties.gravity[k],
        });
        let outlets = Outlets::new(&mesh, boundaries, &weight);
        let mut state = State::new(nodes);
        let (origin, pressure) = outlets.reference().unwrap_or_else(|| (highest(&mesh, &weight), 0.0));
        for (p, x) in state.pressure.iter_mut().zip(mesh.nodes()) {
            *p = pressure + dot(&weight, &difference(x, &origin));
        }
        let enclosed = boundaries.enclosed();
        let unknowns = (D + 1) * nodes;
        let work = Workspace {
            schur: Schur::new(pattern.clone(), enclosed),
            convecting: vec![[0.0; D]; nodes],
            rows: vec![0.0; unknowns],
            rule: TimeRule::new(1.0, None),
            assembly: AssemblyScratch::default(),
            sweep: VelocitySweep::default(),
            multigrid: VelocityMultigrid::new(pattern.clone()),
            krylov: FlexibleGmres::new(unknowns, (BASES / (2 * unknowns)).clamp(*RESTART.start(), *RESTART.end())),
            drag: vec![0.0; nodes],
            drag_diagonal: vec![0.0; nodes],
            drag_density: vec![0.0; nodes],
            inertia: vec![0.0; nodes],
            mobility: vec![0.0; nodes],
            viscous: vec![0.0; nodes],
            right: vec![0.0; unknowns],
            increment: vec![0.0; unknowns],
            volumes: Vec::new(),
            forces: Vec::new(),
            product: ProductScratch::default(),
            matrices: Matrices::zeros(pattern.clone()),
        };
        Ok(Self {
            incidence: Incidence::new(&mesh, &pattern),
            constraints: Constraints::new(&mesh, boundaries)?,
            acceleration: vec![properties.gravity; nodes],
            mesh,
            outlets,
            enclosed,
            properties,
            state,
            work,
        })
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh<D, N> {
        &self.mesh
    }

    /// What the fluid is.
    pub fn properties(&self) -> &Properties<D> {
        &self.properties
    }

    /// The fields.
    pub fn state(&self) -> &State<D> {
        &self.state
    }

    /// The fields, to be changed between steps.
    pub fn state_mut(&mut self) -> &mut State<D> {
        &mut self.state
    }

    /// Sets the initial velocity (m/s); prescribed components take their values at time 0.
    pub fn set_velocity(&mut self, velocity: impl Fn(&Vector<D>) -> Vector<D>) {
        let State { velocity: new, velocity_old, .. } = &mut self.state;
        for (u, x) in new.iter_mut().zip(self.mesh.nodes()) {
            *u = velocity(x);
        }
        self.constraints.prescribe(0.0, new);
        velocity_old.copy_from_slice(new);
    }

    /// Sets the body force per mass b (m/s²) besides gravity.
    pub fn set_body_force(&mut self, force: impl Fn(&Vector<D>) -> Vector<D>) {
        for (sum, x) in self.acceleration.iter_mut().zip(self.mesh.nodes()) {
            let force = force(x);
            *sum = std::array::from_fn(|k| self.properties.gravity[k] + force[k]);
        }
    }

    /// The present step becomes history.
    pub fn commit(&mut self, step: Step) {
        self.state.commit(step.length);
    }

    /// Solves for u and p at the end of a step, from the iterate given or from the history; the number of linear
    /// iterations.
    ///
    /// # Errors
    /// The linear solver does not converge; a number that is not finite.
    pub fn solve(
        &mut self,
        step: Step,
        exchange: &Exchange<D>,
        iterate: Option<(&[Vector<D>], &[f64])>,
    ) -> Result<u64, FluidError> {
        let rule = TimeRule::new(step.length, self.state.previous_step);
        self.work.rule = rule;
        self.extrapolate(rule);
        match iterate {
            Some((velocity, pressure)) => {
                self.state.velocity.copy_from_slice(velocity);
                self.state.pressure.copy_from_slice(pressure);
            }
            None => self.state.velocity.copy_from_slice(&self.work.convecting),
        }
        self.constraints.prescribe(step.end(), &mut self.state.velocity);
        self.assemble(rule, step, exchange);
        self.refresh_preconditioner(rule).map_err(|fault| self.fault(fault, step))?;
        let iterations = self.improve(rule, step, exchange)?;
        self.check_finite(step)?;
        let state = &mut self.state;
        for (i, rate) in state.acceleration.iter_mut().enumerate() {
            let [new, old, older] = [&state.velocity[i], &state.velocity_old[i], &state.velocity_older[i]];
            *rate = std::array::from_fn(|k| rule.rate(new[k], old[k], older[k]));
        }
        Ok(iterations)
    }

    /// a = u*, the extrapolation.
    fn extrapolate(&mut self, rule: TimeRule) {
        let State { velocity_old, velocity_older, .. } = &self.state;
        for (i, a) in self.work.convecting.iter_mut().enumerate() {
            *a = std::array::from_fn(|k| rule.extrapolate(velocity_old[i][k], velocity_older[i][k]));
        }
    }

    fn assemble(&mut self, rule: TimeRule, step: Step, exchange: &Exchange<D>) {
        let work = &mut self.work;
        if exchange.is_silent() {
            work.drag.fill(0.0);
            work.drag_diagonal.fill(0.0);
        } else {
            exchange.lumped(&mut work.drag);
            exchange.diagonal(&mut work.drag_diagonal);
        }
        for (i, density) in work.drag_density.iter_mut().enumerate() {
            *density = work.drag[i] / self.mesh.measure()[i];
        }
        let ingredients = Ingredients {
            mesh: &self.mesh,
            incidence: &self.incidence,
            outlets: &self.outlets,
            density: self.properties.density,
            viscosity: self.properties.viscosity,
            acceleration: &self.acceleration,
            convecting: &work.convecting,
            drag: &work.drag_density,
            rule,
            step: step.length,
            state: &self.state,
        };
        ingredients.assemble(&mut work.assembly, &mut work.matrices);
    }

    /// Nodal spacing (m).
    fn spacing(&self) -> f64 {
        let measure = self.mesh.measure();
        (vector::sum(measure) / measure.len() as f64).powf(1.0 / D as f64)
    }

    /// Whether viscosity couples more than the next nodes: μ/(a₀ρh²).
    fn is_viscous(&self, rule: TimeRule) -> bool {
        let Properties { density, viscosity, .. } = self.properties;
        viscosity > VISCOUS * rule.new * density * self.spacing().powi(2)
    }

    fn refresh_preconditioner(&mut self, rule: TimeRule) -> Result<(), linear::Error> {
        let Properties { density, viscosity, .. } = self.properties;
        let viscous = self.is_viscous(rule);
        let work = &mut self.work;
        let diagonal = work.matrices.pattern.diagonal_slots()?;
        for (i, &slot) in diagonal.iter().enumerate() {
            let (void, measure) = (self.state.void_fraction[i], self.mesh.measure()[i]);
            let resistance = rule.new * density * void + work.drag_density[i];
            let block = &work.matrices.momentum.blocks()[slot as usize];
            let trace: f64 = (0..D).map(|k| block[k][k]).sum();
            work.inertia[i] = (resistance * measure).max(trace / D as f64 + work.drag[i]);
            work.mobility[i] = void * void / resistance;
            work.viscous[i] = 4.0 / 3.0 * viscosity / (void * measure);
        }
        let (momentum, drag) = (&work.matrices.momentum, &work.drag_diagonal);
        if viscous {
            work.multigrid.refresh(momentum, drag, &self.constraints)?;
        } else {
            work.sweep.refresh(momentum, drag, &self.constraints)?;
        }
        work.schur.refresh(&self.mesh, &self.incidence, &self.outlets, &work.mobility)
    }

    /// Adds to (u, p) what makes the residual small, then the constant that makes its sum vanish.
    fn improve(&mut self, rule: TimeRule, step: Step, exchange: &Exchange<D>) -> Result<u64, FluidError> {
        let measure = self.mesh.measure();
        let total: f64 = vector::sum(measure);
        let (spacing, is_viscous) = (self.spacing(), self.is_viscous(rule));
        let resistance = rule.new * self.properties.density + vector::sum(&self.work.drag) / total;
        let (inertia, round_off) = (self.inertia_scale(), self.round_off());
        let Workspace { matrices, schur, sweep, multigrid, krylov, viscous, inertia: lumped, right, increment, volumes, forces, rows, product, .. } =
            &mut self.work;
        let operator = StepOperator {
            matrices,
            exchange,
            constraints: &self.constraints,
            measure,
            scale: resistance * spacing,
            enclosed: self.enclosed,
            scratch: RefCell::new(product),
        };
        let state = &mut self.state;
        {
            let (momentum, continuity) = split_mut(right);
            let fields = (&*state.velocity, &*state.pressure);
            operator.evaluate(Part::Affine, fields, (&mut *momentum, &mut *continuity));
            operator.restrict(momentum, continuity);
        }
        vector::scale(-1.0, right);
        let target = (self.properties.tolerance * (vector::norm(right) + inertia)).max(round_off);
        let mut preconditioner = StepPreconditioner {
            matrices,
            constraints: &self.constraints,
            velocity: if is_viscous { VelocitySolver::Multigrid(multigrid) } else { VelocitySolver::Sweep(sweep) },
            schur,
            viscous,
            inertia: lumped,
            measure,
            scale: operator.scale,
            enclosed: self.enclosed,
            volumes,
            forces,
        };
        increment.fill(0.0);
        let stopping = Stopping { relative: 0.0, absolute: target, iterations: MOST_ITERATIONS };
        let outcome = krylov.solve(&operator, &mut preconditioner, right, increment, stopping);
        if outcome.verdict == Verdict::NonFinite {
            self.check_finite(step)?;
            return Err(self.fault_in_rows(step));
        }
        if outcome.verdict != Verdict::Converged {
            return Err(FluidError::NotConverged {
                iterations: outcome.iterations,
                residual: outcome.residual_norm,
                target,
                time: step.end(),
            });
        }
        let (du, dp) = split::<D>(increment);
        vector::axpy(1.0, du.as_flattened(), state.velocity.as_flattened_mut());
        vector::axpy(1.0, dp, &mut state.pressure);
        balance_momentum(&operator, &mut state.velocity, &state.pressure, rows, increment);
        Ok(outcome.iterations as u64)
    }

    /// ‖Δ u‖: the size of the forces that the inertia and the drag of the flow amount to (N).
    fn inertia_scale(&self) -> f64 {
        let square = |(i, u): (usize, &Vector<D>)| self.work.inertia[i].powi(2) * dot(u, u);
        self.state.velocity.iter().enumerate().map(square).sum::<f64>().sqrt()
    }

    /// The part of the residual that is round-off: a share of the norm of Σ_j|G_ij p_j| + |f_i| (N).
    fn round_off(&self) -> f64 {
        let matrices = &self.work.matrices;
        let square = |i: usize| {
            let row = matrices.pattern.row(i).iter().zip(&matrices.coupling[matrices.pattern.slots(i)]);
            let mut sizes = matrices.right[i].force.map(f64::abs);
            for (&j, entry) in row {
                for k in 0..D {
                    sizes[k] += (entry.gradient[k] * self.state.pressure[j as usize]).abs();
                }
            }
            dot(&sizes, &sizes)
        };
        ROUND_OFF * (0..self.mesh.node_count()).map(square).sum::<f64>().sqrt()
    }

    fn check_finite(&self, step: Step) -> Result<(), FluidError> {
        for (quantity, field) in [("velocity", &self.state.velocity), ("body force", &self.acceleration)] {
            let faulty = |u: &Vector<D>| u.iter().copied().find(|component| !component.is_finite());
            if let Some((node, value)) = field.iter().enumerate().find_map(|(i, u)| Some((i, faulty(u)?))) {
                return Err(self.not_finite(quantity, node, value, step));
            }
        }
        match self.state.pressure.iter().position(|p| !p.is_finite()) {
            Some(node) => Err(self.not_finite("pressure", node, self.state.pressure[node], step)),
            None => Ok(()),
        }
    }

    /// Where the system of a step stopped being finite, though the fields are.
    fn fault_in_rows(&self, step: Step) -> FluidError {
        let place = self.work.right.iter().position(|value| !value.is_finite()).unwrap_or(0);
        let nodes = self.mesh.node_count();
        let node = if place < D * nodes { place / D } else { place - D * nodes };
        self.not_finite("a force", node, self.work.right[place], step)
    }

    fn not_finite(&self, quantity: &'static str, node: usize, value: f64, step: Step) -> FluidError {
        FluidError::NonFinite { quantity, node, position: in_space(&self.mesh.nodes()[node]), value, time: step.end() }
    }

    /// A matrix that cannot be used: the node behind it where it is known.
    fn fault(&self, fault: linear::Error, step: Step) -> FluidError {
        match fault {
            linear::Error::NonFinite { row, value, .. } | linear::Error::DiagonalNotPositive { row, value } => {
                self.not_finite("a matrix coefficient", row, value, step)
            }
            other => FluidError::Linear(other),
        }
    }
}

/// Three components, z = 0 in 2D.
pub fn in_space<const D: usize>(x: &Vector<D>) -> [f64; 3] {
    std::array::from_fn(|k| if k < D { x[k] } else { 0.0 })
}

/// The node against the weight most.
fn highest<const D: usize, const N: usize>(mesh: &Mesh<D, N>, weight: &Vector<D>) -> Vector<D> {
    let height = |x: &&Vector<D>| -dot(weight, x);
    mesh.nodes().iter().max_by(|a, b| height(a).total_cmp(&height(b))).copied().unwrap_or([0.0; D])
}
