//! Gains that let a uniform bed look uniform.

use super::node_kernel::fill;
use super::node_search::NodeSearch;
use super::weights::Weights;
use crate::deposit::Deposit;
use crate::element::simplex::Vector;
use crate::mesh::Mesh;
use rayon::prelude::*;

/// Largest relative defect of the balance that ends the iteration.
const TOLERANCE: f64 = 5e-3;
/// Most sweeps: few, for each carries the gains of a wall further inside.
const MOST_SWEEPS: usize = 16;

/// `g_a |N_a|` in the order of the search, for grains of the given diameter.
///
/// Weights must sum to one over the nodes, `Σ_a w_a(x) = 1`, and a uniform bed must give every node the solid volume of its
/// measure, `∫ w_a(x) dx = |N_a|`. Both hold for a symmetric kernel in free space, and at a flat wall for the kernel
/// plus its mirror image. Mirror images do not fit curved or many-sided walls, so both are demanded directly: the
/// integral is taken by a lumped rule with one grain per node, and the gains follow from alternate scaling of rows and
/// columns (Sinkhorn & Knopp, Pacific J. Math. 21 (1967) 343): `g_a ← g_a |N_a| / Σ_b |N_b| w_a(x_b)`. Whatever the gains,
/// rows sum to one; the sweeps may stop early.
pub fn balance<const D: usize, const N: usize>(
    mesh: &Mesh<D, N>,
    search: &NodeSearch<D>,
    diameter: f64,
) -> Vec<f64> {
    let measure = mesh.measure();
    let mut gains: Vec<f64> = search.order().iter().map(|&node| measure[node as usize]).collect();
    let mut weights = Weights::default();
    let mut deposit = Deposit::default();
    let places = quadrature_points(mesh);
    let mut received = vec![[0.0]; mesh.node_count()];
    for _ in 0..MOST_SWEEPS {
        let chunks = weights.clear(mesh.node_count()).par_iter_mut();
        chunks.zip(places.par_chunks(Weights::GRAINS_PER_CHUNK)).enumerate().for_each(
            |(index, (chunk, places))| {
                for (node, place) in (index * Weights::GRAINS_PER_CHUNK..).zip(places) {
                    fill(search, &gains, place, diameter.max(mesh.size()[node]), chunk);
                }
            },
        );
        deposit.apply(&weights, measure.as_chunks().0, &mut received);
        let mut defect: f64 = 0.0;
        for (gain, &node) in gains.iter_mut().zip(search.order()) {
            let factor = measure[node as usize] / received[node as usize][0];
            defect = defect.max((factor - 1.0).abs());
            *gain *= factor;
        }
        if defect <= TOLERANCE {
            break;
        }
    }
    gains
}

/// Points `x_a + δ_a / 2`, `δ_a = ∫ N_a (x - x_a) / |N_a|`, that make `Σ_a |N_a| f` a good rule up to the boundary.
///
/// Inside a regular mesh they are the nodes. At a wall the rule with nodes errs by `-h² f'/12` and the rule with the
/// centroids of the shape functions by `+h² f'/12` (Euler–Maclaurin): the points half-way are right to this order.
fn quadrature_points<const D: usize, const N: usize>(mesh: &Mesh<D, N>) -> Vec<Vector<D>> {
    let mut moments = vec![[0.0; D]; mesh.node_count()];
    for (cell, volume) in mesh.volumes().iter().enumerate() {
        let vertices = mesh.vertices(cell);
        for (node, own) in mesh.cell_nodes(cell).into_iter().zip(&vertices) {
            for k in 0..D {
                let span: f64 = vertices.iter().map(|vertex| vertex[k] - own[k]).sum();
                moments[node as usize][k] += volume / (N * (N + 1)) as f64 * span;
            }
        }
    }
    let place = |node: usize| {
        let (x, measure) = (&mesh.nodes()[node], mesh.measure()[node]);
        mesh.periodicity().wrap(&std::array::from_fn(|k| x[k] + 0.5 * moments[node][k] / measure))
    };
    (0..mesh.node_count()).map(place).collect()
}
