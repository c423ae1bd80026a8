//! Cells that are fine near some things and grow away from them.

use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, distance, in_space};

/// h = min(h₀, min_s (h_s + g d_s)), d_s the way to the nearest node of a source s along the edges of the mesh, but no less than
/// half of the longest edge at a node: cells that are still coarse, as at the start, become finer by halves, for what is long,
/// thin or close is told by h.
#[derive(Clone, Debug, PartialEq)]
pub struct Grading {
    /// h₀ (m).
    pub coarse: f64,
    /// g: what h gains per way (-).
    pub growth: f64,
    /// The sources.
    pub sources: Vec<Source>,
    /// For each node whether grains are there; empty if nobody asks.
    pub by_grains: Vec<bool>,
}

/// Where cells are fine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source {
    /// Where.
    pub near: Near,
    /// h_s (m).
    pub size: f64,
}

/// What nodes may be near to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Near {
    /// They are on the free surface.
    Surface,
    /// They touch a wall.
    Walls,
    /// Grains take some of the fluid's place around them.
    Grains,
    /// They are in a box along the axes.
    Box([f64; 3], [f64; 3]),
    /// They are in a ball (2D: a disc).
    Sphere([f64; 3], f64),
}

/// h that falls by less, relative, is the same.
const SAME: f64 = 1e-9;

impl Grading {
    /// Whether the grains matter.
    pub fn asks_for_grains(&self) -> bool {
        self.sources.iter().any(|source| source.near == Near::Grains)
    }

    /// Writes h at each node.
    pub fn at_nodes<const D: usize, const N: usize>(&self, cloud: &Cloud<D, N>, sizes: &mut Vec<f64>) {
        sizes.resize(cloud.place.len(), self.coarse);
        for source in &self.sources {
            if source.near == Near::Surface {
                cloud.for_each_free_face(|cell, opposite| {
                    for corner in (0..N).filter(|&corner| corner != opposite) {
                        let size = &mut sizes[cloud.cells[cell][corner] as usize];
                        *size = size.min(source.size);
                    }
                });
                continue;
            }
            for (node, size) in sizes.iter_mut().enumerate() {
                if self.is_near(source.near, cloud, node) {
                    *size = size.min(source.size);
                }
            }
        }
        while self.grow(cloud, sizes) {}
        for cell in &cloud.cells {
            let vertices = cloud.vertices(cell);
            for (i, j) in (0..N).flat_map(|i| (0..i).map(move |j| (i, j))) {
                let half = 0.5 * distance(&vertices[i], &vertices[j]);
                for node in [cell[i], cell[j]].map(|node| node as usize) {
                    sizes[node] = sizes[node].max(half.min(self.coarse));
                }
            }
        }
    }

    /// Lets h be at most that of a neighbour and g times the way to it; whether that changed any.
    fn grow<const D: usize, const N: usize>(&self, cloud: &Cloud<D, N>, sizes: &mut [f64]) -> bool {
        let mut changed = false;
        for cell in &cloud.cells {
            let nodes = cell.map(|node| node as usize);
            for (i, j) in (0..N).flat_map(|i| (0..N).filter(move |&j| j != i).map(move |j| (i, j))) {
                let (from, to) = (nodes[i], nodes[j]);
                let most = sizes[from] + self.growth * distance(&cloud.place[from], &cloud.place[to]);
                if most < sizes[to] * (1.0 - SAME) {
                    sizes[to] = most;
                    changed = true;
                }
            }
        }
        changed
    }

    fn is_near<const D: usize, const N: usize>(&self, near: Near, cloud: &Cloud<D, N>, node: usize) -> bool {
        let x: Vector<3> = in_space(&cloud.place[node]);
        match near {
            Near::Surface => false,
            Near::Walls => !cloud.contacts[node].is_empty(),
            Near::Grains => self.by_grains.get(node).is_some_and(|&there| there),
            Near::Box(lower, upper) => (0..D).all(|k| (lower[k]..=upper[k]).contains(&x[k])),
            Near::Sphere(centre, radius) => {
                (0..D).map(|k| (x[k] - centre[k]).powi(2)).sum::<f64>() <= radius * radius
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A strip of squares of 0.5 m along x, each cut in two; the nodes below come first.
    fn strip(cells: usize) -> Cloud<2, 3> {
        let row = |y: f64| (0..=cells).map(move |k| [0.5 * k as f64, y]);
        let place: Vec<_> = row(0.0).chain(row(0.5)).collect();
        let above = cells as u32 + 1;
        let square = |k: u32| [[k, k + 1, above + k + 1], [k, above + k + 1, above + k]];
        let nodes = place.len();
        Cloud {
            place,
            cells: (0..cells as u32).flat_map(square).collect(),
            contacts: vec![Default::default(); nodes],
            ..Cloud::default()
        }
    }

    #[test]
    fn cells_grow_with_the_way_from_what_they_are_fine_at() {
        let source = Source { near: Near::Sphere([0.0; 3], 0.1), size: 0.5 };
        let grading = Grading { coarse: 2.0, growth: 0.25, sources: vec![source], by_grains: Vec::new() };
        let (cloud, mut sizes) = (strip(10), Vec::new());
        grading.at_nodes(&cloud, &mut sizes);
        for (x, size) in cloud.place.iter().zip(&sizes).take(11) {
            assert!((size - (0.5 + 0.25 * x[0]).min(2.0)).abs() < 1e-12, "{x:?}: {size}");
        }
    }

    #[test]
    fn cells_that_are_coarse_yet_become_finer_by_halves() {
        let source = Source { near: Near::Box([-9.0; 3], [9.0; 3]), size: 0.01 };
        let grading = Grading { coarse: 2.0, growth: 0.25, sources: vec![source], by_grains: Vec::new() };
        let (cloud, mut sizes) = (strip(3), Vec::new());
        grading.at_nodes(&cloud, &mut sizes);
        // All but the two ends of the strip that no diagonal meets.
        let half = |node: usize| if [3, 4].contains(&node) { 0.25 } else { 0.25 * 2.0_f64.sqrt() };
        assert!((0..8).all(|node| (sizes[node] - half(node)).abs() < 1e-12), "{sizes:?}");
    }

    #[test]
    fn grains_count_where_they_are_known_only() {
        let source = Source { near: Near::Grains, size: 0.5 };
        let mut grading = Grading { coarse: 2.0, growth: 10.0, sources: vec![source], by_grains: Vec::new() };
        let (cloud, mut sizes) = (strip(3), Vec::new());
        grading.at_nodes(&cloud, &mut sizes);
        assert!(sizes.iter().all(|&size| size == 2.0) && grading.asks_for_grains());
        grading.by_grains = vec![false; 8];
        grading.by_grains[5] = true;
        sizes.clear();
        grading.at_nodes(&cloud, &mut sizes);
        assert_eq!((sizes[5], sizes[0]), (0.5, 2.0));
    }
}
