//! Momentum and energy go over from mesh to mesh.

use super::books::{Energy, EnergyBooks};
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::flow::Constraint;
use crate::backend::pfem::wall::{Wall, inlet_of};
use crate::element::simplex::{Vector, difference, dot};
use std::collections::BTreeMap;

/// A node that has so many times the volume it had moves as what it got.
const GROWN: f64 = 10.0;

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

/// Gives nodes off inlets that grew more than tenfold the velocity of what they got: v_i → (m_i v_i + (V_i − m_i) v̄)/V_i, along their
/// walls, v̄ being that of the other corners of their cells, by the mass that these had. A node of next to no mass, which any
/// blow makes fast, would have its speed with all that it got.
///
/// `mass` and `volumes` as in [`keep_momentum`], which is to follow.
pub fn mix<const D: usize, const N: usize>(
    cloud: &mut Cloud<D, N>,
    (mass, volumes): (&[f64], &[f64]),
    walls: &[Wall<D>],
    time: f64,
) {
    let is_free = |node: usize| inlet_of(walls, cloud.contacts[node]).is_none();
    let has_grown =
        |node: &usize| mass[*node] > 0.0 && volumes[*node] > GROWN * mass[*node] && is_free(*node);
    let mut grown: BTreeMap<usize, (f64, Vector<D>)> =
        (0..mass.len()).filter(has_grown).map(|node| (node, (0.0, [0.0; D]))).collect();
    if grown.is_empty() {
        return;
    }
    let Cloud { cells, place, contacts, velocity, .. } = cloud;
    for cell in cells {
        for node in cell.map(|node| node as usize) {
            let Some((sum, momentum)) = grown.get_mut(&node) else { continue };
            for other in cell.map(|other| other as usize).into_iter().filter(|other| *other != node) {
                *sum += mass[other];
                (0..D).for_each(|k| momentum[k] += mass[other] * velocity[other][k]);
            }
        }
    }
    for (node, (sum, momentum)) in grown.into_iter().filter(|(_, (sum, _))| *sum > 0.0) {
        let share = 1.0 - mass[node] / volumes[node];
        let mut held = Constraint::FREE;
        for wall in contacts[node].iter() {
            held.add(&walls[wall].touch(&place[node], time).normal, 0.0);
        }
        let change = held.free(&std::array::from_fn(|k| share * (momentum[k] / sum - velocity[node][k])));
        (0..D).for_each(|k| velocity[node][k] += change[k]);
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::backend::pfem::wall::{Contacts, Grip, Plane, Shape};

    #[test]
    fn a_node_of_next_to_no_mass_takes_the_velocity_of_what_it_gets_along_its_wall() {
        let floor = Plane { point: [0.0, 0.0], normal: [0.0, 1.0] };
        let walls = [Wall::new("floor", Shape::Plane(floor), Grip::Slip)];
        for on_floor in [false, true] {
            let mut cloud = Cloud::<2, 3> {
                place: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
                velocity: vec![[100.0, 0.0], [1.0, 2.0], [1.0, 2.0]],
                contacts: vec![Contacts::default(); 3],
                cells: vec![[0, 1, 2]],
                ..Cloud::default()
            };
            if on_floor {
                cloud.contacts[0].insert(0);
            }
            mix(&mut cloud, (&[0.001, 1.0, 1.0], &[1.0, 1.0, 1.0]), &walls, 0.0);
            let expected = [0.1 + 0.999, if on_floor { 0.0 } else { 1.998 }];
            let found = &cloud.velocity;
            assert!((0..2).all(|k| (found[0][k] - expected[k]).abs() < 1e-12), "{found:?}");
            assert_eq!(found[1..], [[1.0, 2.0]; 2]);
        }
    }
}
