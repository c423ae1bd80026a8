//! Fills the matrices of a step.

use super::compliance::{CompliantCell, Given};
use super::incidence::{Incidence, ROWS, for_each_node, for_each_row};
use super::matrices::{Coupling, Matrices, Recovery, Right};
use super::outlet::Outlets;
use super::state::State;
use super::time_rule::TimeRule;
use crate::element::simplex::{Vector, dot};
use crate::mesh::Mesh;
use crate::weak_form::{MomentumCell, PorousCell, PressureCell, Resistance, relaxation_time, share};
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
#[derive(Default)]
pub struct AssemblyScratch<const D: usize> {
    /// τ₁ of the cells.
    relaxation_times: Vec<f64>,
    /// Projection of ρε a·∇a on the nodes (Pa/m).
    convection: Vec<Vector<D>>,
}

impl<const D: usize, const N: usize> Ingredients<'_, D, N> {
    /// Fills the matrices and right-hand sides.
    pub fn assemble(&self, scratch: &mut AssemblyScratch<D>, matrices: &mut Matrices<D>) {
        let AssemblyScratch { relaxation_times, convection } = scratch;
        relaxation_times.resize(self.mesh.cells().len(), 0.0);
        relaxation_times.par_chunks_mut(ROWS).enumerate().for_each(|(chunk, times)| {
            for (cell, time) in (chunk * ROWS..).zip(times) {
                *time = self.relaxation_time(cell);
            }
        });
        convection.resize(self.mesh.node_count(), [0.0; D]);
        for_each_node(convection, |node, value| *value = self.projected_convection(node, relaxation_times));

        let Matrices { pattern, momentum, coupling, recovery, right, .. } = matrices;
        for_each_row(pattern, momentum.blocks_mut(), right, |row, blocks, right| {
            blocks.fill([[0.0; D]; D]);
            *right = Right::ZERO;
            for corner in self.incidence.of(row) {
                let (cell, i) = (corner.cell as usize, corner.local as usize);
                let nodes = self.mesh.cell_nodes(cell);
                let element = self.momentum_cell(cell, &nodes, relaxation_times[cell]);
                for (j, &entry) in corner.entries.iter().enumerate() {
                    let block = element.block(self.rule.new, i, j);
                    let target = &mut blocks[entry as usize];
                    for (target, source) in target.as_flattened_mut().iter_mut().zip(block.as_flattened()) {
                        *target += source;
                    }
                }
                self.add_momentum_right(cell, &nodes, i, right);
                let mean = mean(&nodes.map(|node| convection[node as usize]));
                let subscale = element.subscale(i, &mean);
                for k in 0..D {
                    right.force[k] += subscale[k];
                }
            }
        });
        for_each_row(pattern, coupling, right, |row, entries, right| {
            entries.fill(Coupling::ZERO);
            for corner in self.incidence.of(row) {
                self.add_coupling(
                    corner.cell as usize,
                    corner.local as usize,
                    &corner.entries,
                    relaxation_times,
                    entries,
                    right,
                );
            }
        });
        for_each_row(pattern, recovery, right, |row, entries, right| {
            entries.fill(Recovery::ZERO);
            for corner in self.incidence.of(row) {
                let (cell, i) = (corner.cell as usize, corner.local as usize);
                let element = self.pressure_cell(cell, &self.mesh.cell_nodes(cell), relaxation_times[cell]);
                for (j, &entry) in corner.entries.iter().enumerate() {
                    let (gradient, target) = (element.recovery(i, j), &mut entries[entry as usize]);
                    for k in 0..D {
                        target.gradient[k] += gradient[k];
                    }
                    target.mass += element.mass(i, j);
                }
                right.recovery_mass += element.lumped_mass();
            }
        });
        let void = &self.state.void_fraction;
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

    fn momentum_cell(&self, cell: usize, nodes: &[u32; N], relaxation_time: f64) -> MomentumCell<'_, D, N> {
        let convecting = nodes.map(|node| self.convecting[node as usize]);
        MomentumCell::new(
            self.porous_cell(cell, nodes),
            self.density,
            self.viscosity,
            &convecting,
            relaxation_time,
        )
    }

    fn pressure_cell(&self, cell: usize, nodes: &[u32; N], relaxation_time: f64) -> PressureCell<'_, D, N> {
        PressureCell::new(self.porous_cell(cell, nodes), relaxation_time)
    }

    fn relaxation_time(&self, cell: usize) -> f64 {
        let nodes = self.mesh.cell_nodes(cell);
        let velocity = mean(&nodes.map(|node| self.convecting[node as usize]));
        let factorial = if D == 2 { 2.0 } else { 6.0 };
        relaxation_time(&Resistance {
            density: self.density,
            viscosity: self.viscosity,
            void_fraction: self.porous_cell(cell, &nodes).void_fraction.mean(),
            speed: dot(&velocity, &velocity).sqrt(),
            drag: nodes.iter().map(|&node| self.drag[node as usize]).sum::<f64>() / N as f64,
            step: self.step,
            size: (factorial * self.mesh.volumes()[cell]).powf(1.0 / D as f64),
        })
    }

    /// Σ τ₁ V/N ρε a·∇a / Σ τ₁ V/N over the cells around a node.
    fn projected_convection(&self, node: usize, relaxation_times: &[f64]) -> Vector<D> {
        let (mut sum, mut total) = ([0.0; D], 0.0);
        for corner in self.incidence.of(node) {
            let cell = corner.cell as usize;
            let nodes = self.mesh.cell_nodes(cell);
            let convecting = nodes.map(|node| self.convecting[node as usize]);
            let convection = self.momentum_cell(cell, &nodes, 0.0).convection(&convecting);
            let weight = relaxation_times[cell] * self.mesh.volumes()[cell];
            total += weight;
            for k in 0..D {
                sum[k] += weight * convection[k];
            }
        }
        sum.map(|sum| sum / total)
    }

    /// (ρε(g + b), w) − (a₁ρεⁿuⁿ + a₂ρεⁿ⁻¹uⁿ⁻¹, w).
    fn add_momentum_right(&self, cell: usize, nodes: &[u32; N], i: usize, right: &mut Right<D>) {
        let state = self.state;
        let void = self.porous_cell(cell, nodes).void_fraction;
        let void_old = PorousCell::new(self.mesh, cell, nodes, &state.void_fraction_old).void_fraction;
        let void_older = PorousCell::new(self.mesh, cell, nodes, &state.void_fraction_older).void_fraction;
        let mass = self.density * self.mesh.volumes()[cell];
        for (j, &node) in nodes.iter().enumerate() {
            let node = node as usize;
            let weight = mass * void.second(i, j);
            let old = -mass * self.rule.old() * void_old.second(i, j);
            let older = -mass * self.rule.older * void_older.second(i, j);
            for k in 0..D {
                right.force[k] += weight * self.acceleration[node][k]
                    + old * state.velocity_old[node][k]
                    + older * state.velocity_older[node][k];
            }
        }
    }

    fn add_coupling(
        &self,
        cell: usize,
        i: usize,
        places: &[u32; N],
        relaxation_times: &[f64],
        entries: &mut [Coupling<D>],
        right: &mut Right<D>,
    ) {
        let nodes = self.mesh.cell_nodes(cell);
        let element = self.pressure_cell(cell, &nodes, relaxation_times[cell]);
        let volume = self.mesh.volumes()[cell];
        for (j, &place) in places.iter().enumerate() {
            let target = &mut entries[place as usize];
            let (gradient, divergence, projection) =
                (element.gradient(i, j), element.gradient(j, i), element.recovery(j, i));
            for k in 0..D {
                target.gradient[k] += gradient[k];
                target.divergence[k] += divergence[k];
                target.projection[k] += projection[k];
            }
            target.laplacian += element.laplacian(i, j);
            right.source -= volume * share::<N>(i, j) * self.void_rate(nodes[j] as usize);
        }
        self.add_compliance(cell, i, &nodes, places, entries, right);
        let weight = mean(&nodes.map(|node| self.acceleration[node as usize])).map(|a| self.density * a);
        right.source += element.drive(i, &weight);
        let recovered = element.recover(i, &weight);
        for k in 0..D {
            right.recovered_weight[k] += recovered[k];
        }
    }

    fn add_compliance(
        &self,
        cell: usize,
        i: usize,
        nodes: &[u32; N],
        places: &[u32; N],
        entries: &mut [Coupling<D>],
        right: &mut Right<D>,
    ) {
        let Given { compliance, velocity, pressure } = self.given;
        if compliance.is_empty() {
            return;
        }
        let nodal = nodes.map(|node| compliance[node as usize]);
        let element = CompliantCell::new(self.porous_cell(cell, nodes), &nodal);
        for (j, (&place, &node)) in places.iter().zip(nodes).enumerate() {
            let (target, node) = (&mut entries[place as usize], node as usize);
            let (relay, entrain, press) = (element.relay(i, j), element.entrain(i, j), element.press(i, j));
            for k in 0..D {
                target.gradient[k] -= relay[k];
                target.divergence[k] += entrain[k];
                right.force[k] += relay[k] * pressure[node];
            }
            target.laplacian += press;
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

fn mean<const D: usize, const N: usize>(values: &[Vector<D>; N]) -> Vector<D> {
    std::array::from_fn(|k| values.iter().map(|value| value[k]).sum::<f64>() / N as f64)
}
