//! Approximate inverse of the block of momentum.

use super::chunks::for_each;
use super::constraint::Constraint;
use super::nodal::Assembly;
use super::suspended::Suspended;
use super::topology::Topology;
use super::wall_function::Friction;
use crate::element::simplex::{Vector, dot};
use linear::{Amg, AmgOptions, Csr, Preconditioner};

/// Above this μθΔt/(ρh²) viscosity couples more than the next nodes within a step.
const VISCOUS: f64 = 0.5;

/// The lumped inertia ρV_i/(θΔt) with the drag of grains and the friction of walls (kg/s), and where viscosity prevails a V-cycle for each component on it and ∫μ∇N_i·∇N_j.
///
/// Inertia alone is the same for all that falls freely, so free fall is exact. Nodes whose velocity is prescribed stand
/// alone; at slip walls the result is projected.
pub struct Velocity {
    inertia: Vec<f64>,
    matrix: Csr,
    multigrid: Option<Amg>,
    is_viscous: bool,
    right: Vec<f64>,
    solution: Vec<f64>,
}

impl Velocity {
    /// To be refreshed before use.
    pub fn new<const N: usize>(topology: &Topology<N>) -> Self {
        let nodes = topology.pattern().rows();
        Self {
            inertia: vec![0.0; nodes],
            matrix: Csr::zeros(topology.pattern().clone()),
            multigrid: None,
            is_viscous: false,
            right: vec![0.0; nodes],
            solution: vec![0.0; nodes],
        }
    }

    /// Whether viscosity prevails.
    pub fn is_viscous(&self) -> bool {
        self.is_viscous
    }

    /// ρV_i/(θΔt), the drag of grains and the friction of walls (kg/s); 1 at drops.
    pub fn inertia(&self) -> &[f64] {
        &self.inertia
    }

    /// Takes the cells of a pass.
    ///
    /// # Errors
    /// A coefficient that is not finite.
    pub fn refresh<const D: usize, const N: usize>(
        &mut self,
        topology: &Topology<N>,
        assembly: &Assembly<D, N>,
        constraints: &[Constraint<D>],
        (inertia, friction): (f64, &Friction<D>),
        grains: Option<Suspended<'_, D, N>>,
    ) -> Result<(), linear::Error> {
        let volumes = &assembly.volumes;
        for_each(&mut self.inertia, |node, own| {
            let drag = grains.map_or(0.0, |grains| grains.resistance(node));
            let sum = inertia * volumes[node] + drag + friction.resistance(node);
            *own = if sum > 0.0 { sum } else { 1.0 };
        });
        let shear: f64 = assembly.cells.iter().map(|cell| cell.viscosity * cell.volume).sum();
        let volume: f64 = volumes.iter().sum();
        let square = (volume / volumes.len() as f64).powf(2.0 / D as f64);
        self.is_viscous = shear > VISCOUS * inertia * square * volume;
        if !self.is_viscous {
            return Ok(());
        }
        self.matrix.values_mut().fill(0.0);
        for (nodes, cell) in topology.cells().iter().zip(&assembly.cells) {
            let nodes = nodes.map(|node| node as usize);
            for i in 0..N {
                for j in 0..N {
                    let stands_alone = constraints[nodes[i]].is_full() || constraints[nodes[j]].is_full();
                    if i == j || !stands_alone {
                        let entry = cell.viscosity * cell.inverse * dot(&cell.areas[i], &cell.areas[j]);
                        self.matrix.add(nodes[i], nodes[j], entry);
                    }
                }
            }
        }
        for (node, inertia) in self.inertia.iter().enumerate() {
            self.matrix.add(node, node, *inertia);
        }
        match &mut self.multigrid {
            Some(multigrid) => multigrid.refresh(&self.matrix),
            None => {
                self.multigrid = Some(Amg::new(&self.matrix, AmgOptions::default())?);
                Ok(())
            }
        }
    }

    /// z ← approximate A⁻¹ r in the free directions.
    pub fn apply<const D: usize>(
        &mut self,
        constraints: &[Constraint<D>],
        r: &[Vector<D>],
        z: &mut [Vector<D>],
    ) {
        let inertia = &self.inertia;
        match self.multigrid.as_mut().filter(|_| self.is_viscous) {
            None => for_each(z, |node, z| *z = constraints[node].free(&r[node].map(|r| r / inertia[node]))),
            Some(multigrid) => {
                for k in 0..D {
                    for_each(&mut self.right, |node, right| *right = r[node][k]);
                    multigrid.apply(&self.right, &mut self.solution);
                    let solution = &self.solution;
                    for_each(z, |node, z| z[k] = solution[node]);
                }
                for_each(z, |node, z| *z = constraints[node].free(z));
            }
        }
    }
}
