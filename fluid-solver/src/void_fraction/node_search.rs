//! The nodes around a point, periodic images included.

use crate::element::simplex::Vector;
use crate::mesh::bins::Bins;
use crate::mesh::{Mesh, Periodicity};
use std::ops::Range;

/// Nodes per bin: wide bins mean few long runs of memory, narrow ones few candidates too far away.
const NODES_PER_BIN: usize = 6;

/// Node positions in the order of a grid of bins, so that a search reads few long runs of memory.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeSearch<const D: usize> {
    bins: Bins<D>,
    positions: Vec<Vector<D>>,
    periodicity: Periodicity<D>,
}

/// A search under way: around which point, how far.
struct Sphere<const D: usize> {
    centre: Vector<D>,
    /// Displacement of the periodic image of the mesh that is being looked at.
    offset: Vector<D>,
    bin: [usize; D],
}

impl<const D: usize> NodeSearch<D> {
    pub fn new<const N: usize>(mesh: &Mesh<D, N>) -> Self {
        let periodicity = *mesh.periodicity();
        let nodes: Vec<Vector<D>> = mesh.nodes().iter().map(|x| periodicity.wrap(x)).collect();
        let (mut lower, mut upper) = mesh.bounds();
        for (k, period) in periodicity.0.iter().enumerate() {
            if let Some(period) = period {
                (lower[k], upper[k]) = (period.lower, period.lower + period.length);
            }
        }
        let target = nodes.len().div_ceil(NODES_PER_BIN);
        let bins = Bins::new((lower, upper), target, nodes.len(), |node| (nodes[node], nodes[node]));
        let positions = bins.items().iter().map(|&node| nodes[node as usize]).collect();
        Self { bins, positions, periodicity }
    }

    /// The nodes, in the order of the bins.
    pub fn order(&self) -> &[u32] {
        self.bins.items()
    }

    /// Their positions.
    pub fn positions(&self) -> &[Vector<D>] {
        &self.positions
    }

    /// Whether a sphere around a point may reach two images of a node.
    pub fn sees_images_of_one_node(&self, radius: f64) -> bool {
        self.periodicity.0.iter().flatten().any(|period| 2.0 * radius >= period.length)
    }

    /// Calls `visit` for runs in [`Self::order`] that together hold every node closer to `x` than `radius`, and some
    /// others, with the place of `x` as seen from that image of the mesh. The calls depend on the point alone.
    pub fn for_each_run(&self, x: &Vector<D>, radius: f64, mut visit: impl FnMut(Range<usize>, &Vector<D>)) {
        let mut sphere = Sphere { centre: *x, offset: [0.0; D], bin: [0; D] };
        self.along_axis(D - 1, &mut sphere, radius * radius, &mut visit);
    }

    /// Loops over the bins of `axis` that reach into `rest`, what higher axes left of the squared radius.
    fn along_axis(
        &self,
        axis: usize,
        sphere: &mut Sphere<D>,
        rest: f64,
        visit: &mut impl FnMut(Range<usize>, &Vector<D>),
    ) {
        let (x, reach) = (sphere.centre[axis], rest.sqrt());
        let count = self.bins.counts()[axis] as i64;
        let first = self.bins.unbounded_index(axis, x - reach);
        let last = self.bins.unbounded_index(axis, x + reach);
        let (images, length) = match self.periodicity.0[axis] {
            Some(period) if first < 0 || last >= count => {
                (first.div_euclid(count)..=last.div_euclid(count), period.length)
            }
            _ => (0..=0, 0.0),
        };
        for image in images {
            let low = (first - image * count).clamp(0, count - 1) as usize;
            let high = (last - image * count).clamp(0, count - 1) as usize;
            sphere.offset[axis] = image as f64 * length;
            if axis == 0 {
                let seen = std::array::from_fn(|k| sphere.centre[k] - sphere.offset[k]);
                visit(self.bins.row(&sphere.bin, low, high), &seen);
                continue;
            }
            let width = self.bins.width()[axis];
            for bin in low..=high {
                let lower = self.bins.lower()[axis] + sphere.offset[axis] + bin as f64 * width;
                let gap = (lower - x).max(x - lower - width).max(0.0);
                if gap * gap < rest {
                    sphere.bin[axis] = bin;
                    self.along_axis(axis - 1, sphere, rest - gap * gap, visit);
                }
            }
        }
    }
}
