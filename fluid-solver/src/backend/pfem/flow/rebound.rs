//! What grains move of the fluid is not turned round.

use super::chunks::for_each;
use super::constraint::Constraint;
use super::contact::moved;
use super::nodal::Assembly;
use super::preconditioner::Preconditioning;
use super::solve::{Flow, Start};
use super::suspended::Suspended;
use super::topology::Topology;
use crate::element::simplex::{Vector, difference};
use interface::usage::ThreadClock;
use linear::{FlexibleGmres, LinearOperator, Stopping, vector};
use std::cell::RefCell;

/// What is left of the divergence, at most; and the most iterations that this may take.
const LEFT: f64 = 0.2;
const ITERATIONS: usize = 10;

/// The part of v_{n+1} − v_m that the fluid between grains cannot follow, and what takes it.
pub struct Rebound<const D: usize> {
    /// ∫ψ∇(εN_i) − N_i r∇ψ (N), which acts for Δt.
    pub force: Vec<Vector<D>>,
    /// ψ (Pa).
    pub pressure: Vec<f64>,
    krylov: FlexibleGmres,
    /// v_{n+1} − v_m (m/s).
    change: Vec<Vector<D>>,
    divergence: Vec<f64>,
}

impl<const D: usize> Rebound<D> {
    /// None.
    pub fn new() -> Self {
        Self {
            force: Vec::new(),
            pressure: Vec::new(),
            krylov: FlexibleGmres::new(0, ITERATIONS),
            change: Vec::new(),
            divergence: Vec::new(),
        }
    }
}

impl<const D: usize, const N: usize> Flow<D, N> {
    /// Whether v_{n+1} is to be freed of it: the divergence that grains prescribe of v_m changes from step to step.
    pub(super) fn rebounds(&self, start: Start<'_, D, N>) -> bool {
        start.forces.grains.is_some() && self.turns_round()
    }

    /// v_{n+1} = v̄ + [∫ψ∇(εN_i) − N_i r∇ψ]/(ρ∫εN_i/Δt + d_i) with D(v_{n+1}) ≈ D(v_m), where v̄ = v_n + (v_m − v_n)/θ as walls
    /// leave it and D(v) = ∫N_i∇·((ε + e)v), on the mesh of the solution.
    ///
    /// The midpoint rule turns round what v_m and v_n do not share, D(v̄) = 2D(v_m) − D(v_n), and grains that are placed by it
    /// in the next step feed on that. ψ is part of the pressure that they feel.
    pub(super) fn take_rebound(
        &mut self,
        start: Start<'_, D, N>,
        (topology, preconditioning): &mut (Topology<N>, Preconditioning<D>),
        middle: &[Vector<D>],
    ) {
        let Start { cloud, walls, step, .. } = start;
        let nodes = middle.len();
        let Rebound { force, pressure, .. } = &mut self.rebound;
        force.clear();
        force.resize(nodes, [0.0; D]);
        pressure.clear();
        pressure.resize(nodes, 0.0);
        if !self.rebounds(start) {
            return;
        }
        let mut clock = ThreadClock::start();
        let mut change = std::mem::take(&mut self.rebound.change);
        change.clear();
        change.extend(middle.iter().enumerate().map(|(node, middle)| {
            let end = self.contact.at_end(cloud, walls, step, node, middle, &self.unheld(node, middle));
            difference(&end, middle)
        }));
        let inertia = self.inertia(step);
        let Rebound { force, pressure, krylov, divergence, .. } = &mut self.rebound;
        divergence.resize(nodes, 0.0);
        if let Some(grains) = start.suspended(&self.porous, self.implicitness) {
            self.assembly.divergence(topology, grains, &change, divergence);
            for_each(divergence, |_, rate| *rate = -*rate);
            self.spent.assembly += clock.lap();
            let operator = GivenWay {
                topology,
                constraints: &self.contact.constraints,
                inertia,
                grains,
                scratch: RefCell::new((&mut self.assembly, &mut *force, &mut change)),
            };
            let stopping = Stopping { relative: LEFT, absolute: 0.0, iterations: ITERATIONS };
            // What it leaves goes in the next steps.
            let _ = krylov.solve(&operator, &mut preconditioning.pressure, divergence, pressure, stopping);
            vector::scale(self.implicitness, pressure);
            self.assembly.relayed_forces(topology, grains, pressure, force);
            self.spent.solve += clock.lap();
        }
        self.rebound.change = change;
    }
}

/// ψ/θ → D of the velocity that ψ gives in the free directions, [∫ψ∇(εN_i) − N_i r∇ψ]/(ρ∫εN_i/Δt + d_i): as P has it.
struct GivenWay<'a, const D: usize, const N: usize> {
    topology: &'a Topology<N>,
    constraints: &'a [Constraint<D>],
    /// ρ/(θΔt) (kg/(m³ s)).
    inertia: f64,
    grains: Suspended<'a, D, N>,
    /// What rows, forces and velocities are written to.
    scratch: RefCell<(&'a mut Assembly<D, N>, &'a mut Vec<Vector<D>>, &'a mut Vec<Vector<D>>)>,
}

impl<const D: usize, const N: usize> LinearOperator for GivenWay<'_, D, N> {
    fn size(&self) -> usize {
        self.constraints.len()
    }

    fn apply(&self, pressure: &[f64], divergence: &mut [f64]) {
        let Self { topology, constraints, inertia, grains, scratch } = self;
        let (assembly, forces, velocity) = &mut *scratch.borrow_mut();
        assembly.relayed_forces(topology, *grains, pressure, forces);
        let volumes = &assembly.volumes;
        for_each(velocity, |node, v| {
            let resistance = inertia * volumes[node] + grains.resistance(node);
            let share = if volumes[node] > 0.0 { 1.0 / resistance } else { 0.0 };
            *v = moved(&[0.0; D], share, &constraints[node].free(&forces[node]));
        });
        assembly.divergence(topology, *grains, velocity, divergence);
    }
}
