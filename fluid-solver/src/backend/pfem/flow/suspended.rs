//! The grains of a step, as its rows see them.

use super::cell::Cell;
use super::nodal::Part;
use super::porous::{Corners, Porous};
use crate::element::simplex::Vector;
use crate::grains::{Compliance, Suspension};

/// Grains among the nodes of a step, and the cells that they make porous.
#[derive(Clone, Copy)]
pub struct Suspended<'a, const D: usize, const N: usize> {
    /// What they do.
    pub suspension: &'a Suspension<'a, D>,
    /// v_n (m/s).
    pub before: &'a [Vector<D>],
    /// θ.
    pub implicitness: f64,
    /// The cells.
    pub cells: &'a [Porous<D, N>],
}

impl<const D: usize, const N: usize> Suspended<'_, D, N> {
    /// The cells with grains in them, where `cells` are.
    pub fn fill(
        suspension: &Suspension<'_, D>,
        implicitness: f64,
        nodes: &[[u32; N]],
        cells: &[Cell<D, N>],
        porous: &mut Vec<Porous<D, N>>,
    ) {
        porous.clear();
        porous.extend(nodes.iter().zip(cells).map(|(nodes, cell)| {
            let void = nodes.map(|node| suspension.void_fraction[node as usize]);
            Porous::new(cell, void, mean_resistance(suspension, implicitness, nodes))
        }));
    }

    /// d/θ (kg/s): what resists v_m, the drag being that of v_{n+1} = v_n + (v_m − v_n)/θ.
    pub fn resistance(&self, node: usize) -> f64 {
        self.suspension.drag.resistance[node] / self.implicitness
    }

    /// d v_{n+1} − g at a node that has v_m = v (N).
    pub fn drag(&self, part: Part, node: usize, v: &Vector<D>) -> Vector<D> {
        let (resistance, given) = (self.suspension.drag.resistance[node], &self.suspension.drag.given[node]);
        let end = self.end(part, node, v);
        match part {
            Part::Linear => end.map(|end| resistance * end),
            Part::Affine => std::array::from_fn(|k| resistance * end[k] - given[k]),
        }
    }

    /// v_{n+1} of v_m = v.
    fn end(&self, part: Part, node: usize, v: &Vector<D>) -> Vector<D> {
        match part {
            Part::Linear => v.map(|v| v / self.implicitness),
            Part::Affine => {
                let before = &self.before[node];
                std::array::from_fn(|k| before[k] + (v[k] - before[k]) / self.implicitness)
            }
        }
    }

    /// How the grains at the corners of a cell give way.
    pub fn compliance(&self, nodes: &[usize; N]) -> [Compliance; N] {
        match self.suspension.given.compliance {
            [] => [Compliance::default(); N],
            nodal => nodes.map(|node| nodal[node]),
        }
    }

    /// The fields at the corners of a cell.
    pub fn corners(
        &self,
        part: Part,
        nodes: &[usize; N],
        (velocity, pressure): (&[Vector<D>], &[f64]),
        excess: &[Vector<D>],
    ) -> Corners<D, N> {
        let Suspension { carrier, measure, given, .. } = self.suspension;
        let less = |a: &Vector<D>, b: &Vector<D>| -> Vector<D> {
            match part {
                Part::Linear => *a,
                Part::Affine => std::array::from_fn(|k| a[k] - b[k]),
            }
        };
        Corners {
            velocity: nodes.map(|node| velocity[node]),
            pressure: nodes.map(|node| pressure[node]),
            excess: nodes.map(|node| excess[node]),
            drag: nodes.map(|node| self.drag(part, node, &velocity[node]).map(|force| force / measure[node])),
            slip: nodes.map(|node| less(&velocity[node], &carrier[node])),
            compliance: self.compliance(nodes),
            velocity_change: nodes
                .map(|node| less(&self.end(part, node, &velocity[node]), &given.velocity[node])),
            pressure_change: nodes.map(|node| match part {
                Part::Linear => pressure[node],
                Part::Affine => pressure[node] - given.pressure[node],
            }),
        }
    }

    /// κ of a cell (m³ s/kg), see [`Porous::mobility`]; `inertia` is ρ/(θΔt).
    pub fn mobility(&self, cell: usize, nodes: &[u32; N], inertia: f64) -> f64 {
        let compliance = self.compliance(&nodes.map(|node| node as usize));
        let resistance = mean_resistance(self.suspension, self.implicitness, nodes);
        self.cells[cell].mobility(inertia, resistance, &compliance)
    }
}

/// Mean of d/(θ|N_a|) over the corners of a cell (kg/(m³ s)).
fn mean_resistance<const D: usize, const N: usize>(
    suspension: &Suspension<'_, D>,
    implicitness: f64,
    nodes: &[u32; N],
) -> f64 {
    let Suspension { drag, measure, .. } = suspension;
    let density = |node: &u32| drag.resistance[*node as usize] / measure[*node as usize];
    nodes.iter().map(density).sum::<f64>() / (N as f64 * implicitness)
}
