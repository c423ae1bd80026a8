//! All rows of the system, summed by node from the cells around it.

use super::cell::{Cell, exchange};
use super::chunks::for_each;
use super::contact::moved;
use super::porous::Porous;
use super::rheology::Rheology;
use super::suspended::Suspended;
use super::tangent::Tangent;
use super::topology::Topology;
use crate::element::simplex::Vector;

/// In so many passes of a step τ follows a viscosity that depends on the rate of shear. Then it stays: the tangent has none of it,
/// and where ∇p and the weight are far apart, as at the tip of a front, passes would go to and fro with it.
const FOLLOWED: usize = 4;

/// The cells in the middle of the step, and what they add to their corners.
#[derive(Debug)]
pub struct Assembly<const D: usize, const N: usize> {
    /// The cells.
    pub cells: Vec<Cell<D, N>>,
    /// How their stress changes; none where one viscosity holds.
    tangents: Vec<Tangent<D>>,
    /// How often the cells were placed in this step.
    placed: usize,
    /// V_i = Σ V/N, of the fluid alone Σ ∫εN_i (m³); 0 at drops.
    pub volumes: Vec<f64>,
    rows: Vec<Rows<D, N>>,
}

/// Forces and volumes on the corners of a cell.
type Rows<const D: usize, const N: usize> = ([Vector<D>; N], [f64; N]);

/// Fields at the nodes that the rows depend on.
#[derive(Clone, Copy)]
pub struct Fields<'a, const D: usize, const N: usize> {
    /// v (m/s).
    pub velocity: &'a [Vector<D>],
    /// p (Pa).
    pub pressure: &'a [f64],
    /// e = ρ(v − v_n)/(θΔt) − ρg: the residual of momentum but for the stresses (N/m³).
    pub excess: &'a [Vector<D>],
    /// ρ (kg/m³); of no account where increments are mapped.
    pub density: f64,
    /// bulk V^{2/D}∇·v (Pa) is added to the stress where increments are mapped (kg/(m³ s)): the K_v of segregated schemes.
    pub bulk: f64,
    /// Which part of the rows is meant.
    pub part: Part,
    /// The grains, if any.
    pub grains: Option<Suspended<'a, D, N>>,
}

/// Which part of the rows is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Without constants, with the tangent of the stress: the map of increments.
    Linear,
    /// With constants.
    Affine,
}

impl<const D: usize, const N: usize> Default for Assembly<D, N> {
    fn default() -> Self {
        Self { cells: Vec::new(), tangents: Vec::new(), placed: 0, volumes: Vec::new(), rows: Vec::new() }
    }
}

impl<const D: usize, const N: usize> Assembly<D, N> {
    /// Forgets the stresses that the last step arrived at.
    pub fn begin(&mut self, cells: usize, rheology: &Rheology) {
        self.placed = 0;
        self.tangents.clear();
        self.tangents.resize(if rheology.is_newtonian() { 0 } else { cells }, Tangent::UNKNOWN);
    }

    /// Goes on to the stresses of v + δv, as linearised.
    pub fn advance(&mut self, topology: &Topology<N>, velocity: &[Vector<D>], change: &[Vector<D>]) {
        let cells = &self.cells;
        for_each(&mut self.tangents, |index, tangent| {
            let nodes = topology.cells()[index].map(|node| node as usize);
            tangent.advance(
                &cells[index],
                &nodes.map(|node| velocity[node]),
                &nodes.map(|node| change[node]),
            );
        });
    }

    /// Takes the cells with their corners at places and with velocities; `inertia` is ρ/(θΔt).
    pub fn place(
        &mut self,
        topology: &Topology<N>,
        place: impl Fn(usize) -> Vector<D> + Sync,
        velocity: &[Vector<D>],
        inertia: f64,
        rheology: &Rheology,
    ) {
        let nowhere = [[0.0; D]; N];
        let empty = Cell::new(&nowhere, &nowhere, inertia, rheology);
        self.cells.resize(topology.cells().len(), empty);
        self.rows.resize(topology.cells().len(), ([[0.0; D]; N], [0.0; N]));
        let follows = rheology.is_newtonian() || self.placed < FOLLOWED;
        self.placed += 1;
        for_each(&mut self.cells, |index, cell| {
            let corners = topology.cells()[index].map(|node| place(node as usize));
            let v = topology.cells()[index].map(|node| velocity[node as usize]);
            let moved = Cell::new(&corners, &v, inertia, rheology);
            let relaxation = if follows { moved.relaxation } else { cell.relaxation };
            *cell = Cell { relaxation, ..moved };
        });
        self.volumes.resize(topology.pattern().rows(), 0.0);
        let cells = &self.cells;
        for_each(&mut self.tangents, |index, tangent| {
            let v = topology.cells()[index].map(|node| velocity[node as usize]);
            *tangent = tangent.at(&cells[index], &v, rheology);
        });
        for_each(&mut self.volumes, |node, volume| {
            *volume = topology.corners(node).iter().map(|c| cells[c.cell as usize].volume / N as f64).sum();
        });
    }

    /// Leaves to the fluid the volume that grains do not take.
    pub fn share_volume(&mut self, topology: &Topology<N>, porous: &[Porous<D, N>]) {
        let cells = &self.cells;
        for_each(&mut self.volumes, |node, volume| {
            let corners = topology.corners(node).iter().map(|c| (c.cell as usize, c.local as usize));
            *volume = corners.map(|(cell, local)| porous[cell].fluid_volume(&cells[cell], local)).sum();
        });
    }

    /// The rows of momentum (N) and of volume (m³/s); with `curvature` as [`Cell::rows`] has it.
    pub fn evaluate(
        &mut self,
        topology: &Topology<N>,
        fields: Fields<'_, D, N>,
        curvature: f64,
        momentum: &mut [Vector<D>],
        volume: &mut [f64],
    ) {
        let Self { cells, tangents, volumes, rows, .. } = self;
        let Fields { velocity, pressure, excess, density, bulk, part, grains } = fields;
        for_each(rows, |index, rows| {
            let nodes = topology.cells()[index].map(|node| node as usize);
            let (cell, v) = (&cells[index], nodes.map(|node| velocity[node]));
            *rows = match &grains {
                Some(grains) => {
                    let corners = grains.corners(part, &nodes, (velocity, pressure), excess);
                    grains.cells[index].rows(cell, &corners, curvature)
                }
                None => {
                    let (p, e) = (nodes.map(|node| pressure[node]), nodes.map(|node| excess[node]));
                    let passing = cell.passing(&p, &e);
                    let mut rows = cell.rows(&v, &p, &passing, curvature);
                    if part == Part::Affine {
                        let exchange = exchange(&passing, &v);
                        rows.0 = std::array::from_fn(|i| moved(&rows.0[i], density, &exchange[i]));
                    }
                    rows
                }
            };
            if part == Part::Affine {
                return;
            }
            if let Some(tangent) = tangents.get(index) {
                let areas = grains.map_or(cell.areas, |grains| grains.cells[index].areas(cell));
                tangent.relieve(cell, &areas, &v, &mut rows.0);
            }
            if bulk > 0.0 {
                cell.resist_expansion(bulk, &v, &mut rows.0);
            }
        });
        for_each(momentum, |node, force| {
            *force = excess[node].map(|e| volumes[node] * e);
            if let Some(grains) = &grains {
                *force = moved(force, 1.0, &grains.drag(part, node, &velocity[node]));
            }
            for corner in topology.corners(node) {
                let other = &rows[corner.cell as usize].0[corner.local as usize];
                for k in 0..D {
                    force[k] += other[k];
                }
            }
        });
        sum_volumes(topology, rows, volume);
    }

    /// The sum of [`exchange`] over all corners, −Σ q_i v_i (m⁴/s²).
    pub fn exchange(
        &self,
        nodes: &[[u32; N]],
        velocity: &[Vector<D>],
        pressure: &[f64],
        excess: &[Vector<D>],
    ) -> Vector<D> {
        let mut sum = [0.0; D];
        for (cell, nodes) in self.cells.iter().zip(nodes) {
            let nodes = nodes.map(|node| node as usize);
            let passing = cell.passing(&nodes.map(|node| pressure[node]), &nodes.map(|node| excess[node]));
            for (node, passing) in nodes.into_iter().zip(passing) {
                sum = moved(&sum, -passing, &velocity[node]);
            }
        }
        sum
    }

    /// ∫N_i ∇·((ε + e)v) (m³/s), see [`Porous::divergence`].
    pub fn divergence(
        &mut self,
        topology: &Topology<N>,
        grains: Suspended<'_, D, N>,
        velocity: &[Vector<D>],
        divergence: &mut [f64],
    ) {
        let Self { cells, rows, .. } = self;
        for_each(rows, |index, rows| {
            let nodes = topology.cells()[index].map(|node| node as usize);
            let entrained = grains.compliance(&nodes).map(|c| c.entrained);
            let v = nodes.map(|node| velocity[node]);
            rows.1 = grains.cells[index].divergence(&cells[index], &v, entrained);
        });
        sum_volumes(topology, rows, divergence);
    }

    /// ∫p∇(εN_i) − N_i r∇p (N): what a pressure does to the fluid between grains that relay r of it.
    pub fn relayed_forces(
        &mut self,
        topology: &Topology<N>,
        grains: Suspended<'_, D, N>,
        pressure: &[f64],
        forces: &mut [Vector<D>],
    ) {
        let Self { cells, rows, .. } = self;
        for_each(rows, |index, rows| {
            let nodes = topology.cells()[index].map(|node| node as usize);
            let relayed = grains.compliance(&nodes).map(|c| c.relayed);
            let p = nodes.map(|node| pressure[node]);
            rows.0 = grains.cells[index].relayed_forces(&cells[index], &p, relayed);
        });
        for_each(forces, |node, force| {
            let corners = topology.corners(node).iter();
            let forces = corners.map(|c| &rows[c.cell as usize].0[c.local as usize]);
            *force = forces.fold([0.0; D], |sum, force| moved(&sum, 1.0, force));
        });
    }

    /// ∫p∇(εN_i) (N).
    pub fn pressure_forces(
        &self,
        topology: &Topology<N>,
        grains: Option<Suspended<'_, D, N>>,
        p: &[f64],
        forces: &mut [Vector<D>],
    ) {
        for_each(forces, |node, force| {
            *force = [0.0; D];
            for corner in topology.corners(node) {
                let cell = corner.cell as usize;
                if let Some(grains) = &grains {
                    let p = topology.cells()[cell].map(|node| p[node as usize]);
                    let forces = grains.cells[cell].pressure_forces(&self.cells[cell], &p);
                    *force = moved(force, 1.0, &forces[corner.local as usize]);
                    continue;
                }
                let mean =
                    topology.cells()[cell].iter().map(|&node| p[node as usize]).sum::<f64>() / N as f64;
                let area = &self.cells[cell].areas[corner.local as usize];
                for k in 0..D {
                    force[k] += mean * area[k];
                }
            }
        });
    }
}

/// Sums what cells add to the rows of volume of their corners.
fn sum_volumes<const D: usize, const N: usize>(
    topology: &Topology<N>,
    rows: &[Rows<D, N>],
    volumes: &mut [f64],
) {
    for_each(volumes, |node, volume| {
        let corners = topology.corners(node).iter();
        *volume = corners.map(|c| rows[c.cell as usize].1[c.local as usize]).sum();
    });
}
