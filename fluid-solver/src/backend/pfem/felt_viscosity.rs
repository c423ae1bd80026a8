//! The viscosity of the fluid as grains feel it.

use super::flow::{Cell, Law, Rheology};
use crate::element::simplex::Vector;
use crate::mesh::{Corners, Mesh};
use crate::parallel::for_each_node;
use crate::void_fraction::Weights;

/// Viscosities of cells where fields were recovered last, and rates of shear at their nodes.
#[derive(Debug, Default)]
pub struct FeltViscosity {
    /// μ of the cells, less in slivers, as the flow has it (Pa s).
    of_cells: Vec<f64>,
    /// γ̇ of the cells and of the nodes (1/s); empty where one viscosity holds.
    sheared: Vec<f64>,
    sheared_at: Vec<f64>,
}

impl FeltViscosity {
    /// Takes the cells with their nodes at these velocities (m/s); |N_a| (m³) is `measure`.
    pub fn follow<const D: usize, const N: usize>(
        &mut self,
        mesh: &Mesh<D, N>,
        corners: &Corners,
        measure: &[f64],
        velocity: &[Vector<D>],
        rheology: &Rheology,
    ) {
        let cell = |index: usize| {
            let v = mesh.cell_nodes(index).map(|node| velocity[node as usize]);
            Cell::new(&mesh.vertices(index), &v, 0.0, rheology)
        };
        self.of_cells.resize(mesh.cells().len(), 0.0);
        for_each_node(&mut self.of_cells, |index, viscosity| {
            let cell = cell(index);
            *viscosity = cell.viscosity * cell.fullness;
        });
        if rheology.is_newtonian() {
            return;
        }
        self.sheared.resize(mesh.cells().len(), 0.0);
        for_each_node(&mut self.sheared, |index, rate| {
            let cell = cell(index);
            *rate = cell.shear_stress / cell.viscosity;
        });
        self.sheared_at.resize(measure.len(), 0.0);
        let (sheared, volumes) = (&self.sheared, mesh.volumes());
        for_each_node(&mut self.sheared_at, |node, rate| {
            let sum: f64 = corners.of(node).map(|(cell, _)| volumes[cell] / N as f64 * sheared[cell]).sum();
            *rate = if measure[node] > 0.0 { sum / measure[node] } else { 0.0 };
        });
    }

    /// μ of the cells (Pa s).
    pub fn of_cells(&self) -> &[f64] {
        &self.of_cells
    }

    /// μ (Pa s) that resists a grain of diameter d (m) with a slip (m/s): that of the fluid's own rate of shear there and of
    /// slip/d, which makes Stokes' drag 3πμdu + 3πτ_y d² in a Bingham fluid.
    ///
    /// Source: Ansley and Smith, *AIChE J.* 13 (1967) 1193, who find 0.92 in place of 1 for the part of the yield stress.
    pub fn at_grain(
        &self,
        rheology: &Rheology,
        weights: &Weights,
        grain: usize,
        slip: f64,
        diameter: f64,
    ) -> f64 {
        if rheology.is_newtonian() {
            return rheology.viscosity(0.0);
        }
        let (nodes, shares) = weights.row(grain);
        let own: f64 = nodes.iter().zip(shares).map(|(&node, w)| w * self.sheared_at[node as usize]).sum();
        rheology.viscosity(own + slip / diameter)
    }
}
