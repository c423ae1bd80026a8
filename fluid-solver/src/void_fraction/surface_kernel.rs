//! The node kernel in a fluid with a free surface, on nodes that move.

use super::node_kernel::{Grain, fill, radius};
use super::node_search::NodeSearch;
use super::weights::Weights;
use crate::element::simplex::Vector;
use crate::mesh::Mesh;
use crate::parallel::for_each_node;
use std::f64::consts::PI;

/// How often the gains are improved: the error of a uniform bed at a flat wall is 30 % with none, 13, 7, 5 % with 1, 2, 3.
const SWEEPS: usize = 2;

/// Weights `w_pa ∝ g_a |N_a| (1 - r_a²/R²)³₊`, scaled to `Σ_a w_pa = 1`, R as in [`super::NodeKernel`].
///
/// The gains `g_a` do what those of [`super::NodeKernel`] do, for a mesh that lasts for one window: of all gains that
/// make uniform beds look uniform those are found that do so with grains at the nodes, where the kernel is symmetric: `g ← √(g/c)`,
/// `c_a = Σ_b g_b |N_b| (1 - r_ab²/R²)³₊` over what it is in free space.
///
/// Source: Knight, Ruiz and Uçar, *SIAM J. Matrix Anal. Appl.* 35 (2014) 931.
#[derive(Debug, Clone)]
pub struct SurfaceKernel<const D: usize> {
    search: NodeSearch<D>,
    /// `|N_a|` and the mesh size (m) in the order of the search: nodes of no cell have no weight.
    measure: Vec<f64>,
    size: Vec<f64>,
    /// `g_a |N_a|`.
    gained: Vec<f64>,
}

impl<const D: usize> SurfaceKernel<D> {
    /// For the nodes of a mesh as they are now.
    pub fn new<const N: usize>(mesh: &Mesh<D, N>) -> Self {
        let search = NodeSearch::new(mesh);
        let of = |values: &[f64]| search.order().iter().map(|&node| values[node as usize]).collect();
        let (measure, size): (Vec<f64>, _) = (of(mesh.measure()), of(mesh.size()));
        Self { gained: measure.clone(), search, measure, size }
    }

    /// Finds the gains for grains of about this diameter (m).
    pub fn balance(&mut self, diameter: f64) {
        let Self { search, measure, size, gained } = self;
        let mut gains = vec![1.0; measure.len()];
        for _ in 0..SWEEPS {
            for_each_node(&mut gains, |place, gain| {
                if measure[place] > 0.0 {
                    let radius = radius::<D>(diameter.max(size[place]));
                    let reached = within(search, gained, &search.positions()[place], radius);
                    *gain = (*gain * free_space::<D>(radius) / reached).sqrt();
                }
            });
            gained.iter_mut().zip(&gains).zip(&*measure).for_each(|((g, gain), m)| *g = gain * m);
        }
    }

    /// Rebuilds the weights of all grains; `size` is the mesh size at a grain (m), none for a dry one, which gets no weights.
    pub fn weigh(
        &self,
        grains: &[Grain<D>],
        size: impl Fn(usize) -> Option<f64> + Sync,
        weights: &mut Weights,
    ) {
        weights.rebuild(grains, |chunk, number, grain| match size(number) {
            None => chunk.close_row(0.0),
            Some(size) => {
                let width = grain.diameter.max(size);
                fill(&self.search, &self.gained, &grain.position, width, chunk);
            }
        });
    }
}

/// Σ m_b (1 − r_b²/R²)³₊ over the nodes around x.
fn within<const D: usize>(search: &NodeSearch<D>, m: &[f64], x: &Vector<D>, radius: f64) -> f64 {
    let (mut sum, per_square) = (0.0, 1.0 / (radius * radius));
    search.for_each_run(x, radius, |run, x| {
        for (node, m) in search.positions()[run.clone()].iter().zip(&m[run]) {
            let squared: f64 = (0..D).map(|k| (node[k] - x[k]) * (node[k] - x[k])).sum();
            let height = (1.0 - squared * per_square).max(0.0);
            sum += m * (height * height * height);
        }
    });
    sum
}

/// ∫(1 − r²/R²)³ over the ball (disc) of radius R.
fn free_space<const D: usize>(radius: f64) -> f64 {
    match D {
        2 => 0.25 * PI * radius * radius,
        _ => 64.0 / 315.0 * PI * radius.powi(3),
    }
}
