//! Approximate inverse of the system of a pass.

use super::cell::Cell;
use super::chunks::for_each;
use super::constraint::Constraint;
use super::krylov::{StepOperator, split, split_mut};
use super::nodal::Assembly;
use super::pressure::Pressure;
use super::suspended::Suspended;
use super::topology::Topology;
use super::velocity::Velocity;
use super::wall_function::Friction;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::Vector;
use linear::Preconditioner;

/// The parts of the approximate inverse.
pub struct Preconditioning<const D: usize> {
    /// Of the block of momentum.
    pub velocity: Velocity,
    /// Of the Schur complement of the pressure.
    pub pressure: Pressure,
    /// (4/3) μ/V_i (Pa/m³ s): what viscosity adds to the inverse of the Schur complement.
    viscous: Vec<f64>,
    /// W_i/V_i ≥ 1, see [`refresh`](Self::refresh).
    lightness: Vec<f64>,
    /// Scratch, one entry per node.
    pub forces: Vec<Vector<D>>,
    /// Scratch, one entry per node.
    pub volumes: Vec<f64>,
    /// Zeros.
    pub no_pressure: Vec<f64>,
}

/// What a step is divided by.
#[derive(Clone, Copy)]
pub struct Rates<'a, const D: usize, const N: usize> {
    /// ρ/(θΔt) (kg/(m³ s)).
    pub inertia: f64,
    /// 1/(κΔt) (1/(Pa s)).
    pub compressibility: f64,
    /// What the pressure matrix is a Laplacian of (m³ s/kg), where it is not θΔt/ρ with the drag of grains.
    pub mobility: Option<fn(&Cell<D, N>) -> f64>,
    /// That of walls.
    pub friction: &'a Friction<D>,
}

impl<const D: usize> Preconditioning<D> {
    /// To be refreshed before use.
    pub fn new<const N: usize>(topology: &Topology<N>) -> Self {
        let nodes = topology.pattern().rows();
        Self {
            velocity: Velocity::new(topology),
            pressure: Pressure::new(topology),
            viscous: vec![0.0; nodes],
            lightness: vec![1.0; nodes],
            forces: vec![[0.0; D]; nodes],
            volumes: vec![0.0; nodes],
            no_pressure: vec![0.0; nodes],
        }
    }

    /// Takes the cells of a pass.
    ///
    /// In a cell e the mobility of water alone is θΔt/ρ times the mean W_i/V_i of its corners, W_i = Σ V'/N with V' what is taken
    /// for V in 1/V_e: then Σ_i |Σ_e V∇p/N|²/V_i ≤ Σ_e |V∇p|²/V' × that mean (Cauchy and Schwarz), and P is not less than the
    /// D M⁻¹ Dᵀ of a projection. Where a node has slivers alone, its V_i is less than what they count for, and without the
    /// factor a projection would turn what it should take round.
    ///
    /// # Errors
    /// A coefficient that is not finite.
    pub fn refresh<const N: usize>(
        &mut self,
        cloud: &Cloud<D, N>,
        topology: &Topology<N>,
        assembly: &Assembly<D, N>,
        constraints: &[Constraint<D>],
        rates: Rates<'_, D, N>,
        grains: Option<Suspended<'_, D, N>>,
    ) -> Result<(), linear::Error> {
        let Rates { inertia, compressibility, mobility, friction } = rates;
        self.velocity.refresh(topology, assembly, constraints, (inertia, friction), grains)?;
        if grains.is_none() && mobility.is_none() {
            for_each(&mut self.lightness, |node, lightness| {
                let cells = topology.corners(node).iter().map(|corner| &assembly.cells[corner.cell as usize]);
                let lack: f64 = cells.map(|cell| (1.0 - cell.fullness) / (cell.inverse * N as f64)).sum();
                let volume = assembly.volumes[node];
                *lightness = if volume > 0.0 { 1.0 + lack / volume } else { 1.0 };
            });
        }
        let lightness = &self.lightness;
        let mobility = |index: usize, nodes: &[u32; N]| match (&grains, mobility) {
            (_, Some(mobility)) => mobility(&assembly.cells[index]),
            (Some(grains), _) => grains.mobility(index, nodes, inertia),
            (None, None) => {
                nodes.iter().map(|&node| lightness[node as usize]).sum::<f64>() / N as f64 / inertia
            }
        };
        self.pressure.refresh(cloud, assembly, mobility, compressibility)?;
        for_each(&mut self.viscous, |node, viscous| {
            let cells = topology.corners(node).iter().map(|corner| &assembly.cells[corner.cell as usize]);
            let shear: f64 = cells.map(|cell| cell.viscosity / N as f64 * cell.volume).sum();
            let volume = assembly.volumes[node];
            *viscous = if volume > 0.0 { 4.0 / 3.0 * shear / (volume * volume) } else { 0.0 };
        });
        Ok(())
    }
}

/// An incomplete block factorisation.
///
/// Where inertia prevails v* = Â⁻¹ r_v, p = Ŝ⁻¹(r_p − B v*), v = v* + Â⁻¹ G p. Where viscosity does, p = Ŝ⁻¹ r_p and
/// v = Â⁻¹(r_v + G p). Ŝ⁻¹ = P⁻¹ + (4/3) μ M⁻¹.
///
/// Source: Cahouet and Chabard, *Int. J. Numer. Meth. Fluids* 8 (1988) 869.
pub struct StepPreconditioner<'s, 'a, const D: usize, const N: usize> {
    /// What is to be inverted.
    pub operator: &'s StepOperator<'a, D, N>,
    /// The approximate inverses of its blocks.
    pub parts: &'s mut Preconditioning<D>,
}

impl<const D: usize, const N: usize> Preconditioner for StepPreconditioner<'_, '_, D, N> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let ((r_v, r_p), (v, p)) = (split::<D>(r), split_mut::<D>(z));
        let Preconditioning { velocity, pressure, viscous, forces, volumes, no_pressure, .. } =
            &mut *self.parts;
        let StepOperator { topology, constraints, scale, grains, .. } = *self.operator;
        if velocity.is_viscous() {
            for_each(volumes, |node, volume| *volume = r_p[node] / scale);
        } else {
            velocity.apply(constraints, r_v, v);
            self.operator.rows(v, no_pressure, 0.0, forces, volumes);
            for_each(volumes, |node, volume| *volume = r_p[node] / scale - *volume);
        }
        pressure.apply(volumes, p);
        for_each(p, |node, p| *p += viscous[node] * volumes[node]);
        self.operator.scratch.borrow().assembly.pressure_forces(topology, grains, p, forces);
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
