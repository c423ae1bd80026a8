//! Fills the matrices of a step.

use super::cell_fields::{CellFields, mean};
use super::incidence::{Corner, Incidence, ROWS};
use super::matrices::{Matrices, Right, RowEntries};
use super::outlet::Outlets;
use super::state::State;
use super::time_rule::TimeRule;
use crate::element::simplex::{Vector, dot};
use crate::grains::{CompliantCell, Given};
use crate::mesh::Mesh;
use crate::parallel::for_each_node;
use crate::weak_form::{MomentumRow, PorousCell, PressureCell, share};
use rayon::prelude::*;

/// All that a step's matrices are made of.
pub struct Ingredients<'a, const D: usize, const N: usize> {
    pub mesh: &'a Mesh<D, N>,
    pub incidence: &'a Incidence<N>,
    pub outlets: &'a Outlets<D>,
    pub density: f64,
    pub viscosity: f64,
    /// g + b at the nodes (m/s²).
    pub acceleration: &'a [Vector<D>],
    /// a at the nodes (m/s).
    pub convecting: &'a [Vector<D>],
    /// Drag coefficient per volume at the nodes (kg/(m³ s)).
    pub drag: &'a [f64],
    /// How the grains give way.
    pub given: Given<'a, D>,
    pub rule: TimeRule,
    pub step: f64,
    pub state: &'a State<D>,
}

/// Fields that the assembly computes on its way.
pub struct AssemblyScratch<const D: usize, const N: usize> {
    cells: Vec<CellFields<D, N>>,
    /// Projection of ρε a·∇a on the nodes (Pa/m).
    convection: Vec<Vector<D>>,
}

impl<const D: usize, const N: usize> AssemblyScratch<D, N> {
    /// Empty.
    pub fn new() -> Self {
        Self { cells: Vec::new(), convection: Vec::new() }
    }
}

impl<const D: usize, const N: usize> Ingredients<'_, D, N> {
    /// Fills the matrices and right-hand sides.
    pub fn assemble(&self, scratch: &mut AssemblyScratch<D, N>, matrices: &mut Matrices<D>) {
        let AssemblyScratch { cells, convection } = scratch;
        let all = (0..self.mesh.cells().len()).into_par_iter().with_min_len(ROWS);
        all.map(|cell| CellFields::new(self, cell)).collect_into_vec(cells);
        convection.resize(self.mesh.node_count(), [0.0; D]);
        for_each_node(convection, |node, value| *value = self.projected_convection(node, cells));

        matrices.for_each_row(|row, mut entries, right| {
            entries.clear();
            *right = Right::ZERO;
            for corner in self.incidence.of(row) {
                let fields = &cells[corner.cell as usize];
                self.add_momentum(corner, fields, convection, &mut entries, right);
                self.add_pressure(corner, fields, &mut entries, right);
                self.add_compliance(corner, &mut entries, right);
            }
        });
        let void = &self.state.void_fraction;
        let Matrices { momentum, right, .. } = matrices;
        self.outlets.add_outflow(self.density, void, self.convecting, momentum);
        self.outlets.for_each_traction(void, |node, force| {
            for k in 0..D {
                right[node].force[k] += force[k];
            }
        });
    }

    fn porous_cell(&self, cell: usize, nodes: &[u32; N]) -> PorousCell<'_, D, N> {
        PorousCell::new(self.mesh, cell, nodes, &self.state.void_fraction)
    }

    /// Σ τ₁ V/N ρε a·∇a / Σ τ₁ V/N over the cells around a node.
    fn projected_convection(&self, node: usize, cells: &[CellFields<D, N>]) -> Vector<D> {
        let (mut sum, mut total) = ([0.0; D], 0.0);
        for corner in self.incidence.of(node) {
            let CellFields { relaxation_time, convection, .. } = &cells[corner.cell as usize];
            let weight = relaxation_time * self.mesh.volumes()[corner.cell as usize];
            total += weight;
            for k in 0..D {
                sum[k] += weight * convection[k];
            }
        }
        sum.map(|sum| sum / total)
    }

    fn add_momentum(
        &self,
        corner: &Corner<N>,
        fields: &CellFields<D, N>,
        convection: &[Vector<D>],
        entries: &mut RowEntries<'_, D>,
        right: &mut Right<D>,
    ) {
        let (cell, i) = (corner.cell as usize, corner.local as usize);
        let nodes = self.mesh.cell_nodes(cell);
        let element = MomentumRow::new(
            self.porous_cell(cell, &nodes),
            &fields.flux,
            i,
            self.rule.new * self.density,
            self.viscosity,
            fields.relaxation_time,
        );
        for (j, &entry) in corner.entries.iter().enumerate() {
            let target = &mut entries.momentum[entry as usize];
            for (target, source) in target.as_flattened_mut().iter_mut().zip(element.block(j).as_flattened())
            {
                *target += source;
            }
        }
        let subscale = element.subscale(&mean(&nodes.map(|node| convection[node as usize])));
        for k in 0..D {
            right.force[k] += fields.force[i][k] + subscale[k];
        }
    }

    fn add_pressure(
        &self,
        corner: &Corner<N>,
        fields: &CellFields<D, N>,
        entries: &mut RowEntries<'_, D>,
        right: &mut Right<D>,
    ) {
        let (cell, i) = (corner.cell as usize, corner.local as usize);
        let nodes = self.mesh.cell_nodes(cell);
        let element = PressureCell::new(self.porous_cell(cell, &nodes), fields.relaxation_time);
        let volume = self.mesh.volumes()[cell];
        for (j, &entry) in corner.entries.iter().enumerate() {
            let entry = entry as usize;
            add(&mut entries.gradient[entry], element.gradient(i, j));
            add(&mut entries.divergence[entry], element.gradient(j, i));
            let subscale = &mut entries.subscale[entry];
            add(&mut subscale.projection, element.recovery(j, i));
            subscale.laplacian += element.laplacian(i, j);
            let recovery = &mut entries.recovery[entry];
            add(&mut recovery.gradient, element.recovery(i, j));
            recovery.mass += element.mass(i, j);
            right.source -= volume * share::<N>(i, j) * self.void_rate(nodes[j] as usize);
        }
        let weight = mean(&nodes.map(|node| self.acceleration[node as usize])).map(|a| self.density * a);
        right.source += element.drive(i, &weight);
        add(&mut right.recovered_weight, element.recover(i, &weight));
        right.recovery_mass += element.lumped_mass();
    }

    fn add_compliance(&self, corner: &Corner<N>, entries: &mut RowEntries<'_, D>, right: &mut Right<D>) {
        let Given { compliance, velocity, pressure } = self.given;
        if compliance.is_empty() {
            return;
        }
        let (cell, i) = (corner.cell as usize, corner.local as usize);
        let nodes = self.mesh.cell_nodes(cell);
        let nodal = nodes.map(|node| compliance[node as usize]);
        let element = CompliantCell::new(self.porous_cell(cell, &nodes), &nodal);
        for (j, (&entry, node)) in corner.entries.iter().zip(nodes).enumerate() {
            let (entry, node) = (entry as usize, node as usize);
            let (relay, entrain, press) = (element.relay(i, j), element.entrain(i, j), element.press(i, j));
            add(&mut entries.gradient[entry], relay.map(|relay| -relay));
            add(&mut entries.divergence[entry], entrain);
            entries.subscale[entry].laplacian += press;
            add(&mut right.force, relay.map(|relay| relay * pressure[node]));
            right.source += press * pressure[node] + dot(&entrain, &velocity[node]);
        }
    }

    /// D_t ε at a node (1/s).
    fn void_rate(&self, node: usize) -> f64 {
        let state = self.state;
        self.rule.rate(
            state.void_fraction[node],
            state.void_fraction_old[node],
            state.void_fraction_older[node],
        )
    }
}

fn add<const D: usize>(sum: &mut Vector<D>, term: Vector<D>) {
    for k in 0..D {
        sum[k] += term[k];
    }
}
