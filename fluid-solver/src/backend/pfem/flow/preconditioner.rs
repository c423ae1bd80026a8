//! Approximate inverse of the system of a pass.

use super::chunks::for_each;
use super::constraint::Constraint;
use super::krylov::{Scratch, StepOperator, split, split_mut};
use super::nodal::{Assembly, Fields};
use super::pressure::Pressure;
use super::suspended::{Part, Suspended};
use super::topology::Topology;
use super::velocity::Velocity;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::Vector;
use linear::Preconditioner;

/// The parts of the approximate inverse.
pub struct Preconditioning<const D: usize> {
    velocity: Velocity,
    pressure: Pressure,
    /// (4/3) μ/V_i (Pa/m³ s): what viscosity adds to the inverse of the Schur complement.
    viscous: Vec<f64>,
    forces: Vec<Vector<D>>,
    volumes: Vec<f64>,
    no_pressure: Vec<f64>,
}

impl<const D: usize> Preconditioning<D> {
    /// To be refreshed before use.
    pub fn new<const N: usize>(topology: &Topology<N>) -> Self {
        let nodes = topology.pattern().rows();
        Self {
            velocity: Velocity::new(topology),
            pressure: Pressure::new(topology),
            viscous: vec![0.0; nodes],
            forces: vec![[0.0; D]; nodes],
            volumes: vec![0.0; nodes],
            no_pressure: vec![0.0; nodes],
        }
    }

    /// Takes the cells of a pass: ρ/(θΔt) and 1/(κΔt) are those of the step.
    ///
    /// # Errors
    /// A coefficient that is not finite.
    pub fn refresh<const N: usize>(
        &mut self,
        cloud: &Cloud<D, N>,
        topology: &Topology<N>,
        assembly: &Assembly<D, N>,
        constraints: &[Constraint<D>],
        (inertia, compressibility): (f64, f64),
        grains: Option<Suspended<'_, D, N>>,
    ) -> Result<(), linear::Error> {
        self.velocity.refresh(topology, assembly, constraints, inertia, grains)?;
        self.pressure.refresh(cloud, assembly, inertia, compressibility, grains)?;
        for_each(&mut self.viscous, |node, viscous| {
            let cells = topology.corners(node).iter().map(|corner| &assembly.cells[corner.cell as usize]);
            let shear: f64 = cells.map(|cell| cell.viscosity / N as f64 * cell.volume).sum();
            let volume = assembly.volumes[node];
            *viscous = if volume > 0.0 { 4.0 / 3.0 * shear / (volume * volume) } else { 0.0 };
        });
        Ok(())
    }

    /// φ ← P⁻¹ r.
    pub fn press(&mut self, r: &[f64], phi: &mut [f64]) {
        self.pressure.apply(r, phi);
    }
}

/// An incomplete block factorisation.
///
/// Where inertia prevails v* = Â⁻¹ r_v, p = Ŝ⁻¹(r_p − B v*), v = v* + Â⁻¹ G p. Where viscosity does, p = Ŝ⁻¹ r_p and
/// v = Â⁻¹(r_v + G p). Ŝ⁻¹ = P⁻¹ + (4/3) μ M⁻¹.
///
/// Source: Cahouet and Chabard, *Int. J. Numer. Meth. Fluids* 8 (1988) 869.
pub struct StepPreconditioner<'a, const D: usize, const N: usize> {
    /// What is to be inverted.
    pub operator: &'a StepOperator<'a, D, N>,
    /// The approximate inverses of its blocks.
    pub parts: &'a mut Preconditioning<D>,
}

impl<const D: usize, const N: usize> Preconditioner for StepPreconditioner<'_, D, N> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let ((r_v, r_p), (v, p)) = (split::<D>(r), split_mut::<D>(z));
        let Preconditioning { velocity, pressure, viscous, forces, volumes, no_pressure } = &mut *self.parts;
        let StepOperator { topology, constraints, inertia, scale, grains, .. } = *self.operator;
        let Scratch { assembly, excess } = &mut *self.operator.scratch.borrow_mut();
        if velocity.is_viscous() {
            for_each(volumes, |node, volume| *volume = r_p[node] / scale);
        } else {
            velocity.apply(constraints, r_v, v);
            for_each(excess, |node, e| *e = v[node].map(|v| inertia * v));
            let linear = grains.map(|grains| (grains, Part::Linear));
            let fields = Fields { velocity: v, pressure: no_pressure, excess, grains: linear };
            assembly.evaluate(topology, fields, 0.0, forces, volumes);
            for_each(volumes, |node, volume| *volume = r_p[node] / scale - *volume);
        }
        pressure.apply(volumes, p);
        for_each(p, |node, p| *p += viscous[node] * volumes[node]);
        assembly.pressure_forces(topology, grains, p, forces);
        if velocity.is_viscous() {
            for_each(forces, |node, force| *force = std::array::from_fn(|k| force[k] + r_v[node][k]));
            velocity.apply(constraints, forces, v);
        } else {
            let inertia = velocity.inertia();
            for_each(v, |node, v| {
                let change = constraints[node].free(&forces[node].map(|force| force / inertia[node]));
                *v = std::array::from_fn(|k| v[k] + change[k]);
            });
        }
    }
}
