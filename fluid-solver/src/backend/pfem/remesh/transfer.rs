//! Momentum goes over from mesh to mesh.

use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::Vector;

/// Momentum per density: Σ m_i v_i, m_i a node's share of its cells, or its drop.
pub fn momentum<const D: usize>(volumes: &[f64], velocity: &[Vector<D>]) -> Vector<D> {
    let mut sum = [0.0; D];
    for (m, v) in volumes.iter().zip(velocity) {
        for k in 0..D {
            sum[k] += m * v[k];
        }
    }
    sum
}

/// Gives what the new nodal volumes miss of the momentum `before` to the nodes whose volume changed and that touch no
/// wall, as one velocity for all of them.
///
/// `mass` are the nodal volumes before, `volumes` those now.
pub fn keep_momentum<const D: usize, const N: usize>(
    cloud: &mut Cloud<D, N>,
    mass: &[f64],
    before: Vector<D>,
    volumes: &[f64],
) {
    let after = momentum(volumes, &cloud.velocity);
    let free = |node: usize| cloud.contacts[node].is_empty() && volumes[node] > 0.0;
    let changed = |node: usize| (volumes[node] - mass[node]).abs() > 1e-12 * volumes[node];
    for strict in [true, false] {
        let chosen = |node: usize| free(node) && (!strict || changed(node));
        let sum: f64 = (0..volumes.len()).filter(|&node| chosen(node)).map(|node| volumes[node]).sum();
        if sum > 0.0 {
            let given: Vector<D> = std::array::from_fn(|k| (before[k] - after[k]) / sum);
            for node in (0..volumes.len()).filter(|&node| chosen(node)) {
                for k in 0..D {
                    cloud.velocity[node][k] += given[k];
                }
            }
            return;
        }
    }
}
