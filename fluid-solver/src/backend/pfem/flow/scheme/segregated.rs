//! Velocity and pressure one after the other.

use super::{Correct, Iterate, Verdict};
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::flow::cell::Cell;
use crate::backend::pfem::flow::chunks::for_each;
use crate::backend::pfem::flow::krylov::{StepOperator, split, split_mut};
use crate::backend::pfem::flow::nodal::Assembly;
use crate::backend::pfem::flow::preconditioner::Preconditioning;
use crate::backend::pfem::flow::pressure::for_each_surface_entry;
use crate::backend::pfem::flow::velocity::Velocity;
use crate::element::simplex::Vector;
use linear::{ConjugateGradient, LinearOperator, Preconditioner, Stopping, dense};
use std::cell::RefCell;

/// Passes, as the papers have it, and at most, where nodes met a wall in the last; what is left of the equations then is
/// what the scheme leaves.
const PASSES: [u64; 2] = [4, 10];
/// Relative change of velocity and pressure that counts as none.
const CHANGE: f64 = 1e-3;
/// Coefficient of K_v: ∫κ'(∇·v)(∇·w) with κ' = this many times (ρ/Δt)V^{2/D}.
const BULK: f64 = 10.0;
/// Linear iterations at most, and what they leave of the residual.
const ITERATIONS: usize = 200;
const REDUCTION: f64 = 1e-4;

/// (M/Δt + K + K_v)δv = −r_v, then (M₁/Δt + L + M_b)δp = −r_p(v + δv): K_v, the stiffness of a fluid as compressible as a
/// step can feel, makes the velocity solvable without a pressure; M_b = ∫_Γ(2τ/h_n)pq on the free surface the pressure
/// without a velocity, and takes volume for it. Backward Euler in time.
///
/// It stops because v and p hardly change: the map has an eigenvalue close to 1 in water, and the equations do not hold.
///
/// Source: Oñate, Franci and Carbonell, *Int. J. Numer. Meth. Fluids* 74 (2014) 699; Franci, Oñate and Carbonell,
/// *Int. J. Numer. Meth. Eng.* 102 (2015) 257.
#[derive(Default)]
pub struct Segregated {
    gradients: ConjugateGradient,
}

impl<const D: usize, const N: usize> Correct<D, N> for Segregated {
    fn implicitness(&self, _stated: f64) -> f64 {
        1.0
    }

    fn projects(&self) -> bool {
        false
    }

    fn mobility(&self) -> Option<fn(&Cell<D, N>) -> f64> {
        Some(|cell| cell.relaxation)
    }

    fn add_volumes(&self, cloud: &Cloud<D, N>, assembly: &Assembly<D, N>, p: &[f64], volumes: &mut [f64]) {
        let relaxation = |cell: usize, _: &[u32; N]| assembly.cells[cell].relaxation;
        for_each_surface_entry(cloud, assembly, relaxation, |i, j, entry| volumes[i] += entry * p[j]);
    }

    fn judge(&self, iterate: &Iterate) -> Verdict {
        let Iterate { passes, change, met, .. } = *iterate;
        let stands = met == 0 && (passes >= PASSES[0] || (passes > 0 && change <= CHANGE));
        match passes {
            _ if stands || iterate.residual <= iterate.allowed => Verdict::Done,
            passes if passes == PASSES[1] => Verdict::Failed,
            _ => Verdict::Again,
        }
    }

    fn correct(
        &mut self,
        _: &Iterate,
        operator: &StepOperator<'_, D, N>,
        parts: &mut Preconditioning<D>,
        right: &[f64],
        increment: &mut [f64],
    ) -> u64 {
        let Preconditioning { velocity, pressure, forces, volumes, no_pressure, .. } = parts;
        let ((r_v, r_p), (dv, dp)) = (split::<D>(right), split_mut::<D>(increment));
        dv.fill([0.0; D]);
        let stopping = Stopping { relative: REDUCTION, absolute: 0.0, iterations: ITERATIONS };
        let scratch = RefCell::new((volumes.as_mut_slice(), no_pressure.as_slice()));
        let alone = VelocityOperator { operator, scratch };
        let mut inertia = Inertia { velocity, operator };
        let (b, x) = (r_v.as_flattened(), dv.as_flattened_mut());
        let outcome = self.gradients.solve(&alone, &mut inertia, b, x, stopping);
        operator.rows(dv, no_pressure, 0.0, forces, volumes);
        let scale = operator.scale;
        for_each(volumes, |node, volume| *volume = r_p[node] / scale - *volume);
        pressure.apply(volumes, dp);
        outcome.iterations as u64
    }
}

/// M/Δt + K + K_v in the free directions.
struct VelocityOperator<'s, 'a, const D: usize, const N: usize> {
    operator: &'s StepOperator<'a, D, N>,
    /// Volumes, written to, and no pressure.
    scratch: RefCell<(&'s mut [f64], &'s [f64])>,
}

impl<const D: usize, const N: usize> LinearOperator for VelocityOperator<'_, '_, D, N> {
    fn size(&self) -> usize {
        D * self.operator.constraints.len()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let (volumes, no_pressure) = &mut *self.scratch.borrow_mut();
        let forces: &mut [Vector<D>] = dense::by_node_mut(y);
        let bulk = BULK * self.operator.inertia;
        self.operator.rows(dense::by_node(x), no_pressure, bulk, forces, volumes);
        for_each(forces, |node, force| *force = self.operator.constraints[node].free(force));
    }
}

/// (M/Δt)⁻¹ in the free directions.
struct Inertia<'s, 'a, const D: usize, const N: usize> {
    velocity: &'s mut Velocity,
    operator: &'s StepOperator<'a, D, N>,
}

impl<const D: usize, const N: usize> Preconditioner for Inertia<'_, '_, D, N> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let z: &mut [Vector<D>] = dense::by_node_mut(z);
        self.velocity.apply(self.operator.constraints, dense::by_node(r), z);
    }
}
