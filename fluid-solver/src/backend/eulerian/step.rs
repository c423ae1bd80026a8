//! One step: a linear system for u and p at its end.

use super::assembly::{AssemblyScratch, Ingredients};
use super::balance::balance_momentum;
use super::flow::{Flow, Properties};
use super::krylov::{StepOperator, split, split_mut};
use super::matrices::{Matrices, Part, ProductScratch};
use super::preconditioner::{Preconditioning, Resistances, StepPreconditioner, spacing};
use super::state::State;
use super::time_rule::TimeRule;
use crate::backend::{Stages, Step};
use crate::element::simplex::{Vector, dot};
use crate::error::FluidError;
use crate::grains::{Compliance, Exchange, Given};
use crate::parallel::for_each_node;
use interface::usage::ThreadClock;
use linear::{FlexibleGmres, Pattern, Stopping, Verdict, vector};
use std::cell::RefCell;
use std::ops::RangeInclusive;
use std::sync::Arc;

/// Numbers that the bases of the Krylov method may hold before it restarts, and the range of iterations kept.
const BASES: usize = 40_000_000;
const RESTART: RangeInclusive<usize> = 50..=400;
/// Iterations after which a step is given up.
const MOST_ITERATIONS: usize = 600;
/// The residual cannot fall below this share of the terms it is made of.
const ROUND_OFF: f64 = 4e-15;

/// Bound of the grains' k in parts of the fluid's own ε²/(a₀ρε + β): pressure on wavelengths that no grain samples follows
/// with k/(k + own) per solution. Met only by grains lighter than the fluid.
const MOST_PRESSED: f64 = 4.0;

/// Scratch of a step, and what its solution leaves for the ledger.
pub struct Workspace<const D: usize, const N: usize> {
    /// The system.
    pub matrices: Matrices<D>,
    /// Its approximate inverse.
    pub preconditioning: Preconditioning<D>,
    /// a (m/s).
    pub convecting: Vec<Vector<D>>,
    /// Left less right-hand side at the solution: force of the boundary on each node (N), volume rows (m³/s).
    pub rows: Vec<f64>,
    /// The time rule of the step.
    pub rule: TimeRule,
    /// The residual that the step began with, negative.
    pub right: Vec<f64>,
    /// u′ and p′: what the grains have felt.
    pub felt_velocity: Vec<Vector<D>>,
    pub felt_pressure: Vec<f64>,
    /// Where the time went.
    pub spent: Stages,
    compliance: Vec<Compliance>,
    assembly: AssemblyScratch<D, N>,
    krylov: FlexibleGmres,
    drag_density: Vec<f64>,
    increment: Vec<f64>,
    product: ProductScratch<D>,
}

impl<const D: usize, const N: usize> Workspace<D, N> {
    /// For the nodes of a pattern; `enclosed` if nothing can leave.
    pub fn new(pattern: &Arc<Pattern>, enclosed: bool) -> Self {
        let nodes = pattern.rows();
        let unknowns = (D + 1) * nodes;
        let restart = (BASES / (2 * unknowns)).clamp(*RESTART.start(), *RESTART.end());
        Self {
            matrices: Matrices::zeros(pattern.clone()),
            preconditioning: Preconditioning::new(pattern, enclosed),
            convecting: vec![[0.0; D]; nodes],
            rows: vec![0.0; unknowns],
            rule: TimeRule::new(1.0, None),
            right: vec![0.0; unknowns],
            felt_velocity: vec![[0.0; D]; nodes],
            felt_pressure: vec![0.0; nodes],
            spent: Stages::default(),
            compliance: Vec::new(),
            assembly: AssemblyScratch::new(),
            krylov: FlexibleGmres::new(unknowns, restart),
            drag_density: vec![0.0; nodes],
            increment: vec![0.0; unknowns],
            product: ProductScratch::default(),
        }
    }
}

impl<const D: usize, const N: usize> Flow<D, N> {
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
        let mut clock = ThreadClock::start();
        if self.state.previous_step.is_none() && !exchange.is_silent() {
            self.state.begin_with_grains(step.length);
        }
        let rule = TimeRule::new(step.length, self.state.previous_step);
        self.work.rule = rule;
        self.extrapolate(rule);
        if let Some((velocity, pressure)) = iterate {
            self.state.velocity.copy_from_slice(velocity);
            self.state.pressure.copy_from_slice(pressure);
        }
        self.work.felt_velocity.copy_from_slice(&self.state.velocity);
        self.work.felt_pressure.copy_from_slice(&self.state.pressure);
        if iterate.is_none() {
            self.state.velocity.copy_from_slice(&self.work.convecting);
        }
        let State { velocity, void_fraction, .. } = &mut self.state;
        self.constraints.prescribe(step.end(), void_fraction, velocity);
        self.assemble(rule, step, exchange);
        self.work.spent.assembly += clock.lap();
        self.precondition(rule).map_err(|fault| self.fault(fault, step))?;
        let iterations = self.improve(rule, step)?;
        self.work.spent.solve += clock.lap();
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
        let instant = (rule.new, step.length);
        let (measure, drag) = (self.mesh.measure(), &mut work.matrices.drag);
        exchange.lump(measure, instant, drag, &mut work.compliance);
        for ((density, resistance), measure) in
            work.drag_density.iter_mut().zip(&drag.resistance).zip(measure)
        {
            *density = resistance / measure;
        }
        let resistance = resistances(rule, &self.properties, &self.state, &work.drag_density);
        for (node, compliance) in work.compliance.iter_mut().enumerate() {
            compliance.pressed = compliance.pressed.min(MOST_PRESSED * resistance.own_mobility(node));
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
            given: Given {
                compliance: &work.compliance,
                velocity: &work.felt_velocity,
                pressure: &work.felt_pressure,
            },
            rule,
            step: step.length,
            state: &self.state,
        };
        ingredients.assemble(&mut work.assembly, &mut work.matrices);
    }

    fn precondition(&mut self, rule: TimeRule) -> Result<(), linear::Error> {
        let Workspace { matrices, preconditioning, drag_density, compliance, .. } = &mut self.work;
        let resistance = resistances(rule, &self.properties, &self.state, drag_density);
        preconditioning.refresh(&self.mesh, matrices, &self.constraints, &resistance)?;
        let mobility = resistance.mobility(compliance);
        preconditioning.schur.refresh(&self.mesh, &self.incidence, &self.outlets, &mobility)
    }

    /// Adds to (u, p) what makes the residual small, then the constant that makes its sum vanish.
    fn improve(&mut self, rule: TimeRule, step: Step) -> Result<u64, FluidError> {
        let (inertia, round_off) = (self.inertia_scale(), self.round_off());
        let measure = self.mesh.measure();
        let drag = vector::dot(&self.work.drag_density, measure) / vector::sum(measure);
        let resistance = rule.new * self.properties.density + drag;
        let spacing = spacing(&self.mesh);
        let Workspace { matrices, preconditioning, krylov, right, increment, rows, product, .. } =
            &mut self.work;
        let operator = StepOperator {
            matrices,
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
        let mut preconditioner = StepPreconditioner { operator: &operator, parts: preconditioning };
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
        balance_momentum(&operator, &mut state.velocity, &state.pressure, rows);
        Ok(outcome.iterations as u64)
    }

    /// ‖Δ u‖: the size of the forces that the inertia and the drag of the flow amount to (N).
    fn inertia_scale(&self) -> f64 {
        let square = |(i, u): (usize, &Vector<D>)| self.work.preconditioning.inertia()[i].powi(2) * dot(u, u);
        self.state.velocity.iter().enumerate().map(square).sum::<f64>().sqrt()
    }

    /// The part of the residual that is round-off: a share of the norm of Σ_j|G_ij p_j| + |f_i| (N).
    fn round_off(&mut self) -> f64 {
        let Workspace { matrices, increment, .. } = &mut self.work;
        let (sizes, _) = split_mut::<D>(increment);
        for_each_node(sizes, |i, size| *size = matrices.force_size(i, &self.state.pressure));
        ROUND_OFF * vector::norm(sizes.as_flattened())
    }
}

/// What resists a change of velocity in a step, with this drag per volume at the nodes (kg/(m³ s)).
fn resistances<'a, const D: usize>(
    rule: TimeRule,
    properties: &Properties<D>,
    state: &'a State<D>,
    drag: &'a [f64],
) -> Resistances<'a> {
    let Properties { density, viscosity, .. } = *properties;
    Resistances { rate: rule.new, density, viscosity, void_fraction: &state.void_fraction, drag }
}
