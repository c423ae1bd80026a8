//! A disc of concentric rings, and the body it leaves when it is swept along a line.

use crate::element::simplex::{Vector, volume_and_gradients};
use std::f64::consts::TAU;

/// A disc of `rings` rings: node 0 at the centre, then `6 k` nodes on ring `k`.
pub struct Disc {
    /// Positions in the plane of the disc.
    pub points: Vec<Vector<2>>,
    /// Triangles, corners in ascending order.
    pub triangles: Vec<[u32; 3]>,
    /// Nodes from this one on lie on the rim.
    pub rim: usize,
}

impl Disc {
    /// Number of nodes of a disc.
    pub fn node_count(rings: usize) -> Option<usize> {
        rings.checked_add(1)?.checked_mul(rings)?.checked_mul(3)?.checked_add(1)
    }

    pub fn new(radius: f64, rings: usize) -> Self {
        let first = |ring: usize| if ring == 0 { 0 } else { 1 + 3 * ring * (ring - 1) };
        let node =
            |ring: usize, step: usize| (first(ring) + if ring == 0 { 0 } else { step % (6 * ring) }) as u32;
        let mut points = vec![[0.0; 2]];
        let mut triangles = Vec::with_capacity(6 * rings * rings);
        for ring in 1..=rings {
            let r = radius * ring as f64 / rings as f64;
            points.extend((0..6 * ring).map(|step| {
                let (sine, cosine) = (TAU * step as f64 / (6 * ring) as f64).sin_cos();
                [r * cosine, r * sine]
            }));
            for sector in 0..6 {
                for k in 0..ring {
                    let (outer, inner) = (sector * ring + k, sector * (ring - 1) + k);
                    triangles.push([node(ring - 1, inner), node(ring, outer), node(ring, outer + 1)]);
                    if k + 1 < ring {
                        triangles.push([
                            node(ring - 1, inner),
                            node(ring - 1, inner + 1),
                            node(ring, outer + 1),
                        ]);
                    }
                }
            }
        }
        triangles.iter_mut().for_each(|triangle| triangle.sort_unstable());
        Self { points, triangles, rim: first(rings) }
    }

    /// Tetrahedra between successive copies of the disc, whose points are given one copy after the other.
    ///
    /// Each prism is cut along the path bottom → top over its corners in ascending order, which makes the diagonals of
    /// shared sides agree.
    pub fn sweep(&self, points: &[Vector<3>]) -> Vec<[u32; 4]> {
        let copy = self.points.len() as u32;
        let layers = points.len() / self.points.len() - 1;
        let mut cells = Vec::with_capacity(3 * layers * self.triangles.len());
        for layer in 0..layers as u32 {
            for triangle in &self.triangles {
                let [a, b, c] = triangle.map(|node| node + layer * copy);
                let [top_a, top_b, top_c] = [a, b, c].map(|node| node + copy);
                for mut cell in [[a, b, c, top_c], [a, b, top_b, top_c], [a, top_a, top_b, top_c]] {
                    if volume_and_gradients(&cell.map(|point| points[point as usize])).0 < 0.0 {
                        cell.swap(2, 3);
                    }
                    cells.push(cell);
                }
            }
        }
        cells
    }
}
