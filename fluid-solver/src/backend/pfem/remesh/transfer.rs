//! Momentum and energy go over from mesh to mesh.

use super::books::{Energy, EnergyBooks};
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

/// Takes what remeshing would give of energy in all since the start, as other cells between the same nodes do, volume gained in
/// a blow, and volume that is lost below and restored above: from all nodes, as the whole surface was shifted.
///
/// `before` is the energy before the remeshing, `mass` and `volumes` as in [`keep_momentum`].
pub fn keep_energy<const D: usize, const N: usize>(
    cloud: &mut Cloud<D, N>,
    (mass, volumes): (&[f64], &[f64]),
    before: &Energy<D>,
    acceleration: &Vector<D>,
    books: &mut EnergyBooks<D>,
) {
    let mut after = Energy::of(cloud, volumes);
    let gained = after.total(acceleration) - before.total(acceleration);
    let surplus = gained + books.given(acceleration).min(0.0);
    // Bare nodes had no energy that there could be more of.
    if surplus > 0.0 && mass.iter().any(|mass| *mass > 0.0) {
        books.limiter.add(-take_surplus(cloud, volumes, surplus));
        after = Energy::of(cloud, volumes);
    }
    books.add(before, &after);
}

/// Takes a surplus of Σ ½ V_i |v_i|²: the nodes of the mesh that touch no wall lose relative velocity, (v − v̄) → s (v − v̄) with
/// s² = 1 − surplus/Σ ½ m |v − v̄|² ≥ 0, and keep their momentum. Drops fly on as they do. Returns what was taken.
fn take_surplus<const D: usize, const N: usize>(
    cloud: &mut Cloud<D, N>,
    volumes: &[f64],
    surplus: f64,
) -> f64 {
    let Cloud { contacts, velocity, drop, .. } = cloud;
    let weight = |node: usize| {
        let free = contacts[node].is_empty() && drop[node] == 0.0;
        if free { volumes[node] } else { 0.0 }
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
