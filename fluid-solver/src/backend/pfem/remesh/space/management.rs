//! Nodes come and go so that neighbours stand about h apart.

use super::super::draft::Draft;
use super::super::management::{CLOSEST, CLOSEST_TO_SURFACE, FARTHEST, LONGEST, SHORTEST};
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::backend::pfem::wall::{Contacts, Wall};
use crate::element::simplex::{Vector, distance, dot, volume_and_areas};

/// Manages the nodes of the moved cloud. The old cells keep the nodes that go until the new ones replace them.
pub fn manage(cloud: &mut Cloud<3, 4>, draft: &mut Draft<3>, walls: &[Wall<3>], time: f64) {
    let mut settled = vec![false; cloud.place.len()];
    for (_, goes, stays, both) in close(cloud, draft) {
        let [gone, left] = [goes as usize, stays as usize];
        let inner = !draft.exposed[gone];
        if settled[gone]
            || draft.removed[gone]
            || draft.removed[left]
            || (settled[left] && !(inner && draft.exposed[left]))
        {
            continue;
        }
        if both && cloud.contacts[gone] == cloud.contacts[left] {
            let middle =
                |values: &[Vector<3>]| std::array::from_fn(|k| 0.5 * (values[gone][k] + values[left][k]));
            let place = middle(&cloud.place);
            cloud.velocity[left] = middle(&cloud.velocity);
            cloud.place[left] = onto_walls(cloud.contacts[left], place, walls, time);
        }
        draft.remove(goes);
        (settled[gone], settled[left]) = (true, true);
    }
    for (_, [a, b], surface) in far(cloud, draft) {
        if settled[a as usize] || settled[b as usize] {
            continue;
        }
        (settled[a as usize], settled[b as usize]) = (true, true);
        let common = cloud.contacts[a as usize].common(cloud.contacts[b as usize]);
        let contacts = if surface { common } else { Contacts::default() };
        let node = draft.add_between(cloud, a, b, contacts);
        cloud.place[node as usize] = onto_walls(contacts, cloud.place[node as usize], walls, time);
        draft.exposed.push(surface);
    }
}

/// Nodes too close to another, closest first: distance, which goes, which stays, whether both are on the surface.
fn close(cloud: &Cloud<3, 4>, draft: &Draft<3>) -> Vec<(f64, u32, u32, bool)> {
    let exposed = |node: u32| draft.exposed[node as usize];
    let mut close = Vec::new();
    for (length, [a, b]) in inner_edges(cloud) {
        let h = draft.size_between(a, b);
        if length >= CLOSEST * h {
            continue;
        }
        let younger = cloud.birth[a as usize] > cloud.birth[b as usize];
        match (exposed(a), exposed(b)) {
            (false, false) if younger => close.push((length, a, b, false)),
            (false, false) => close.push((length, b, a, false)),
            (true, false) if length < CLOSEST_TO_SURFACE * h => close.push((length, b, a, false)),
            (false, true) if length < CLOSEST_TO_SURFACE * h => close.push((length, a, b, false)),
            _ => {}
        }
    }
    for [a, b] in surface_edges(draft) {
        let length = distance(&cloud.place[a as usize], &cloud.place[b as usize]);
        if length < SHORTEST * draft.size_between(a, b) {
            let (ka, kb) = (cloud.contacts[a as usize], cloud.contacts[b as usize]);
            let younger = cloud.birth[a as usize] > cloud.birth[b as usize];
            // Whoever touches all that the other touches, and more, stays.
            if ka.common(kb) == ka && (ka != kb || younger) {
                close.push((length, a, b, true));
            } else if ka.common(kb) == kb {
                close.push((length, b, a, true));
            }
        }
    }
    for (cell, around) in cloud.cells.iter().zip(&cloud.neighbours) {
        for i in (0..4).filter(|&i| around[i] == OUTSIDE && !exposed(cell[i])) {
            let (volume, areas) = volume_and_areas(&cloud.vertices(cell));
            let height = volume / dot(&areas[i], &areas[i]).sqrt();
            if height < CLOSEST_TO_SURFACE * draft.size[cell[i] as usize] {
                close.push((height, cell[i], cell[(i + 1) % 4], false));
            }
        }
    }
    close.sort_unstable_by(|p, q| p.0.total_cmp(&q.0).then((p.1, p.2).cmp(&(q.1, q.2))));
    close
}

/// Edges too long, longest first, those of the surface before all others: length, nodes, whether of the surface.
fn far(cloud: &Cloud<3, 4>, draft: &Draft<3>) -> Vec<(f64, [u32; 2], bool)> {
    let length = |[a, b]: [u32; 2]| distance(&cloud.place[a as usize], &cloud.place[b as usize]);
    let mut far: Vec<_> = surface_edges(draft)
        .map(|edge| (length(edge), edge, true))
        .filter(|(length, [a, b], _)| *length > LONGEST * draft.size_between(*a, *b))
        .collect();
    let inner = inner_edges(cloud).filter(|(length, [a, b])| *length > FARTHEST * draft.size_between(*a, *b));
    far.extend(inner.map(|(length, edge)| (length, edge, false)));
    far.sort_unstable_by(|p, q| q.2.cmp(&p.2).then(q.0.total_cmp(&p.0)).then(p.1.cmp(&q.1)));
    far
}

/// Edges of all cells with their lengths, many of them often.
fn inner_edges(cloud: &Cloud<3, 4>) -> impl Iterator<Item = (f64, [u32; 2])> + '_ {
    const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
    cloud.cells.iter().flat_map(move |cell| {
        let vertices = cloud.vertices(cell);
        EDGES.map(|[i, j]| {
            let edge = [cell[i].min(cell[j]), cell[i].max(cell[j])];
            (distance(&vertices[i], &vertices[j]), edge)
        })
    })
}

/// Edges of the surface, once each.
fn surface_edges(draft: &Draft<3>) -> impl Iterator<Item = [u32; 2]> + '_ {
    let around = |face: &[u32; 3]| [0, 1, 2].map(|k| [face[k], face[(k + 1) % 3]]);
    draft.edges.iter().flat_map(around).filter(|[a, b]| a < b)
}

/// The nearest place of the walls that a node touches.
fn onto_walls(contacts: Contacts, mut x: Vector<3>, walls: &[Wall<3>], time: f64) -> Vector<3> {
    for wall in contacts.iter() {
        let touch = walls[wall].touch(&x, time);
        x = std::array::from_fn(|k| x[k] - touch.gap * touch.normal[k]);
    }
    x
}
