//! Nodes that grains sit on: the nodal algorithm.
//!
//! Before the mesh is made anew, an inner node of the cell that a grain is in is put where the grain is, with velocity and
//! pressure of the moved fluid there. As a grain slips by little in a step, its node remains its own; where a wall, the
//! surface or another grain is nearer than a cell, it stays without one.
//!
//! Source: Oñate et al., *Comput. Part. Mech.* 1 (2014) 85, §11.

use super::cloud::{Cloud, OUTSIDE};
use crate::element::simplex::{Vector, distance, volume_and_areas};
use rayon::prelude::*;

/// A grain nearer to another than this share of the target size has no node of its own: remeshing would take one of them
/// away.
const CLOSEST: f64 = 0.6;

/// A grain on a face is in one of its cells, though either finds it outside by this much.
const ROUND_OFF: f64 = 1e-9;

/// Puts nodes to grains at these places; returns those nodes. `size` is the target size at the nodes (m).
///
/// They become the oldest of the cloud: of two nodes too close to each other the younger goes.
pub fn seat<const D: usize, const N: usize>(
    cloud: &mut Cloud<D, N>,
    grains: &[Vector<D>],
    size: &[f64],
) -> Vec<usize> {
    let mut free: Vec<bool> = cloud.contacts.iter().map(|contacts| contacts.is_empty()).collect();
    for (cell, around) in cloud.cells.iter().zip(&cloud.neighbours) {
        for outside in (0..N).filter(|&i| around[i] == OUTSIDE) {
            (0..N).filter(|&i| i != outside).for_each(|i| free[cell[i] as usize] = false);
        }
    }
    let mut seats: Vec<Seat<D>> = Vec::new();
    for place in grains {
        let Some(seat) = find(cloud, place, &free) else { continue };
        let room = CLOSEST * size[seat.node];
        if seats.iter().all(|other| distance(&other.place, place) >= room) {
            free[seat.node] = false;
            seats.push(seat);
        }
    }
    for seat in &seats {
        cloud.place[seat.node] = seat.place;
        cloud.velocity[seat.node] = seat.velocity;
        cloud.pressure[seat.node] = seat.pressure;
    }
    let nodes: Vec<usize> = seats.iter().map(|seat| seat.node).collect();
    make_oldest(&mut cloud.birth, &nodes);
    nodes
}

/// A node where it is to be, and what the fluid is there.
struct Seat<const D: usize> {
    node: usize,
    place: Vector<D>,
    velocity: Vector<D>,
    pressure: f64,
}

/// The nearest free corner of the cell that holds a place.
fn find<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    place: &Vector<D>,
    free: &[bool],
) -> Option<Seat<D>> {
    let weights = |cell: &[u32; N]| -> Option<[f64; N]> {
        let vertices = cloud.vertices(cell);
        let (volume, areas) = volume_and_areas(&vertices);
        let weights = std::array::from_fn(|i| {
            1.0 + (0..D).map(|k| areas[i][k] * (place[k] - vertices[i][k])).sum::<f64>() / volume
        });
        weights.iter().all(|&weight| weight >= -ROUND_OFF).then_some(weights)
    };
    let (cell, weights) = cloud.cells.par_iter().find_map_first(|cell| Some((cell, weights(cell)?)))?;
    let corners = cell.map(|node| node as usize);
    let away = |node: usize| distance(&cloud.place[node], place);
    let node = corners.into_iter().filter(|&node| free[node]).min_by(|&a, &b| away(a).total_cmp(&away(b)))?;
    let mean = |value: &dyn Fn(usize) -> f64| (0..N).map(|i| weights[i] * value(corners[i])).sum::<f64>();
    Some(Seat {
        node,
        place: *place,
        velocity: std::array::from_fn(|k| mean(&|node| cloud.velocity[node][k])),
        pressure: mean(&|node| cloud.pressure[node]),
    })
}

/// Gives nodes the lowest numbers of birth; those they had go to the nodes that had these.
fn make_oldest(birth: &mut [u32], nodes: &[usize]) {
    let mut order: Vec<usize> = (0..birth.len()).collect();
    if !nodes.is_empty() && nodes.len() < order.len() {
        order.select_nth_unstable_by_key(nodes.len(), |&node| birth[node]);
    }
    let mut oldest: Vec<usize> = order.into_iter().take(nodes.len()).collect();
    oldest.sort_unstable();
    let others = oldest.iter().filter(|node| !nodes.contains(node));
    for (&node, &other) in nodes.iter().filter(|node| !oldest.contains(node)).zip(others) {
        birth.swap(node, other);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nodes_of_grains_become_the_oldest_and_no_number_is_lost() {
        let mut birth = vec![3, 9, 0, 7, 1, 5];
        make_oldest(&mut birth, &[1, 4]);
        assert!(birth[1].max(birth[4]) == 1, "{birth:?}");
        birth.sort_unstable();
        assert_eq!(birth, [0, 1, 3, 5, 7, 9]);
    }
}
