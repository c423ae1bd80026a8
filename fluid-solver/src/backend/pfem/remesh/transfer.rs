//! Momentum goes over from mesh to mesh.

use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, difference, dot};

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
    let Cloud { contacts, velocity, .. } = cloud;
    for strict in [true, false] {
        let free = |node: usize| contacts[node].is_empty() && volumes[node] > 0.0;
        let chosen = |node: usize| free(node) && (!strict || has_changed(mass, volumes, node));
        let sum: f64 = (0..volumes.len()).filter(|&node| chosen(node)).map(|node| volumes[node]).sum();
        if sum > 0.0 {
            let given: Vector<D> = std::array::from_fn(|k| (before[k] - after[k]) / sum);
            for node in (0..volumes.len()).filter(|&node| chosen(node)) {
                (0..D).for_each(|k| velocity[node][k] += given[k]);
            }
            return;
        }
    }
}

/// Takes a surplus of ∫ ½ |v|² dV, which volume gained in a blow or other cells between the same nodes have brought with them:
/// the nodes whose volume changed and that touch no wall lose relative velocity, (v − v̄) → s (v − v̄) with
/// s² = 1 − surplus/Σ ½ m |v − v̄|² ≥ 0, and keep their momentum. Returns what was taken.
pub fn take_surplus<const D: usize, const N: usize>(
    cloud: &mut Cloud<D, N>,
    mass: &[f64],
    volumes: &[f64],
    surplus: f64,
) -> f64 {
    if surplus <= 0.0 {
        return 0.0;
    }
    let Cloud { contacts, velocity, .. } = cloud;
    let weight = |node: usize| {
        let chosen = contacts[node].is_empty() && has_changed(mass, volumes, node);
        if chosen { volumes[node] } else { 0.0 }
    };
    let (mut sum, mut mean) = (0.0, [0.0; D]);
    for (node, v) in velocity.iter().enumerate() {
        let m = weight(node);
        sum += m;
        (0..D).for_each(|k| mean[k] += m * v[k]);
    }
    mean = mean.map(|momentum| momentum / sum);
    let relative = |(node, v): (usize, &Vector<D>)| {
        let d = difference(v, &mean);
        0.5 * weight(node) * dot(&d, &d)
    };
    let available: f64 = velocity.iter().enumerate().map(relative).sum();
    if available <= 0.0 {
        return 0.0;
    }
    let left = (1.0 - surplus / available).max(0.0).sqrt();
    for (node, v) in velocity.iter_mut().enumerate() {
        if weight(node) > 0.0 {
            *v = std::array::from_fn(|k| mean[k] + left * (v[k] - mean[k]));
        }
    }
    surplus.min(available)
}

fn has_changed(mass: &[f64], volumes: &[f64], node: usize) -> bool {
    (volumes[node] - mass[node]).abs() > 1e-12 * volumes[node]
}
