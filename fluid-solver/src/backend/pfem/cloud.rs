//! The nodes and the mesh between them: all that a step depends on.

use super::wall::Contacts;
use crate::element::simplex::Vector;

/// What lies behind a face of a cell where there is no cell: the free surface or a wall.
pub const OUTSIDE: u32 = u32::MAX;

/// Nodes of the fluid and the cells between them at t_n; `N = D + 1`. In 2D volumes are areas.
///
/// Every field of nodes has one entry per node. A node of no cell is a drop in flight.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cloud<const D: usize, const N: usize> {
    /// x (m).
    pub place: Vec<Vector<D>>,
    /// v (m/s).
    pub velocity: Vec<Vector<D>>,
    /// p (Pa), of the middle of the last step; 0 of a drop in flight.
    pub pressure: Vec<f64>,
    /// Walls that the node touches.
    pub contacts: Vec<Contacts>,
    /// Volume of a drop in flight (m³; m² in 2D); 0 for a node of the mesh.
    pub drop: Vec<f64>,
    /// Number of the node in order of birth: it breaks ties, so that a mesh at rest does not flicker.
    pub birth: Vec<u32>,
    /// Corners of the cells; their volumes are positive.
    pub cells: Vec<[u32; N]>,
    /// Neighbour of a cell across the face opposite to each corner, or [`OUTSIDE`].
    pub neighbours: Vec<[u32; N]>,
}

impl<const D: usize, const N: usize> Cloud<D, N> {
    /// Corners of a cell (m).
    pub fn vertices(&self, cell: &[u32; N]) -> [Vector<D>; N] {
        cell.map(|node| self.place[node as usize])
    }

    /// For each node whether it belongs to a cell.
    pub fn wet(&self) -> Vec<bool> {
        let mut wet = vec![false; self.place.len()];
        for node in self.cells.iter().flatten() {
            wet[*node as usize] = true;
        }
        wet
    }

    /// Takes the pressure off drops: nothing presses on them.
    pub fn relieve_drops(&mut self) {
        for (p, _) in self.pressure.iter_mut().zip(&self.drop).filter(|(_, drop)| **drop > 0.0) {
            *p = 0.0;
        }
    }

    /// Takes nodes of no cell out, and numbers the others anew: `number` is that of each, if it stays.
    pub fn remove(&mut self, removed: &[bool], number: &mut Vec<u32>) {
        number.clear();
        let mut kept = 0;
        for &removed in removed {
            number.push(if removed { OUTSIDE } else { kept });
            kept += u32::from(!removed);
        }
        retain(removed, &mut self.place);
        retain(removed, &mut self.velocity);
        retain(removed, &mut self.pressure);
        retain(removed, &mut self.contacts);
        retain(removed, &mut self.drop);
        retain(removed, &mut self.birth);
        for node in self.cells.iter_mut().flatten() {
            *node = number[*node as usize];
        }
    }
}

/// Takes out the values of nodes that are removed.
pub fn retain<T>(removed: &[bool], values: &mut Vec<T>) {
    let mut gone = removed.iter();
    values.retain(|_| gone.next() == Some(&false));
}
