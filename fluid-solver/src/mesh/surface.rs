//! The surface of a mesh as grains may touch it.

use super::Mesh;
use interface::message::Surface;
use std::collections::BTreeMap;

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// The boundary faces by group, and the box around all points.
    pub fn surface(&self) -> Surface {
        let embed = |point: u32| -> [f64; 3] {
            let position = &self.points()[point as usize];
            std::array::from_fn(|axis| if axis < D { position[axis] } else { 0.0 })
        };
        let mut facets: BTreeMap<String, Vec<[[f64; 3]; 3]>> = BTreeMap::new();
        for face in self.boundary() {
            // In 2D the third vertex repeats the second.
            let vertices = std::array::from_fn(|vertex| embed(face.points[vertex.min(D - 1)]));
            facets.entry(self.groups()[face.group as usize].clone()).or_default().push(vertices);
        }
        let (mut lower, mut upper) = ([0.0; 3], [0.0; 3]);
        for axis in 0..D {
            let coordinates = self.points().iter().map(|point| point[axis]);
            (lower[axis], upper[axis]) = coordinates
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        }
        Surface { lower, upper, facets }
    }
}
