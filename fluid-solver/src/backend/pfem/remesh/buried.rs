//! Cells in walls: they cut the corner of an obstacle.

use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::{Contacts, Wall};
use crate::element::simplex::Vector;

/// A cell whose corners all lie on one wall is buried in it if its middle is behind by more than this share of h.
const BURIED: f64 = 0.05;

/// Whether the corners of a cell of size `h` (m) lie on one wall and its middle in it.
pub fn is_buried<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    walls: &[Wall<D>],
    time: f64,
    cell: &[u32; N],
    h: f64,
) -> bool {
    let common = cell.map(|node| cloud.contacts[node as usize]).into_iter().reduce(Contacts::common);
    let Some(common) = common.filter(|common| !common.is_empty()) else { return false };
    let vertices = cloud.vertices(cell);
    let middle: Vector<D> = std::array::from_fn(|k| vertices.iter().map(|x| x[k]).sum::<f64>() / N as f64);
    common.iter().any(|wall| walls[wall].gap(&middle, time) < -BURIED * h)
}
