//! Momentum goes over from mesh to mesh.

use super::draft::{Draft, nodal_volumes};
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::Vector;

/// Momentum per density: Σ m_i v_i, m_i a third of the cells of a node, or its drop.
pub fn momentum(volumes: &[f64], velocity: &[Vector<2>]) -> Vector<2> {
    let mut sum = [0.0; 2];
    for (m, v) in volumes.iter().zip(velocity) {
        for k in 0..2 {
            sum[k] += m * v[k];
        }
    }
    sum
}

/// Gives what the new nodal volumes miss of the momentum `before` to the nodes whose volume changed and that touch no
/// wall, as one velocity for all of them.
pub fn keep_momentum(cloud: &mut Cloud<2, 3>, draft: &Draft, before: Vector<2>, volumes: &mut Vec<f64>) {
    nodal_volumes(cloud, volumes);
    let after = momentum(volumes, &cloud.velocity);
    let free = |node: usize| cloud.contacts[node].is_empty() && volumes[node] > 0.0;
    let changed = |node: usize| (volumes[node] - draft.mass[node]).abs() > 1e-12 * volumes[node];
    for strict in [true, false] {
        let chosen = |node: usize| free(node) && (!strict || changed(node));
        let mass: f64 = (0..volumes.len()).filter(|&node| chosen(node)).map(|node| volumes[node]).sum();
        if mass > 0.0 {
            let given = [0, 1].map(|k| (before[k] - after[k]) / mass);
            for node in (0..volumes.len()).filter(|&node| chosen(node)) {
                for k in 0..2 {
                    cloud.velocity[node][k] += given[k];
                }
            }
            return;
        }
    }
}
