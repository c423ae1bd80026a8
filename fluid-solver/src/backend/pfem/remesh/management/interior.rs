//! Nodes inside: those too close to others go, wide gaps get one.

use super::super::draft::{Draft, area};
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::backend::pfem::wall::Contacts;
use crate::element::simplex::distance;

/// Removes inner nodes that stand too close to others, closest first, and those of flat cells under the surface.
pub fn remove_close_nodes(cloud: &Cloud<2, 3>, draft: &mut Draft) {
    let mut close = Vec::new();
    for (length, [a, b]) in inner_edges(cloud) {
        let h = draft.size_between(a, b);
        let exposed = [a, b].map(|node| draft.exposed[node as usize]);
        if exposed != [true, true] && length < super::CLOSEST * h {
            let limit = if exposed == [false, false] { super::CLOSEST } else { super::CLOSEST_TO_SURFACE };
            if length < limit * h {
                let younger = if cloud.birth[a as usize] > cloud.birth[b as usize] { a } else { b };
                let goes = if exposed[0] {
                    b
                } else if exposed[1] {
                    a
                } else {
                    younger
                };
                close.push((length, goes, a + b - goes));
            }
        }
    }
    for (cell, around) in cloud.cells.iter().zip(&cloud.neighbours) {
        for i in (0..3).filter(|&i| around[i] == OUTSIDE) {
            let (node, base) = (cell[i], [cell[(i + 1) % 3], cell[(i + 2) % 3]]);
            let height = 2.0 * area(&cloud.vertices(cell)) / base_length(cloud, base);
            let limit = super::CLOSEST_TO_SURFACE * draft.size[node as usize];
            if !draft.exposed[node as usize] && height < limit {
                close.push((height, node, base[0]));
            }
        }
    }
    close.sort_unstable_by(|p, q| p.0.total_cmp(&q.0).then((p.1, p.2).cmp(&(q.1, q.2))));
    let mut near_removed = vec![false; if close.is_empty() { 0 } else { cloud.place.len() }];
    for (_, goes, stays) in close {
        let stays_there = draft.exposed[stays as usize] || !near_removed[stays as usize];
        if !near_removed[goes as usize] && stays_there && !draft.removed[goes as usize] {
            draft.remove(goes);
            near_removed[goes as usize] = true;
            near_removed[stays as usize] = true;
        }
    }
}

/// Adds a node in the middle of inner edges longer than 1.6 h, longest first, one per patch.
pub fn insert_between_far_nodes(cloud: &mut Cloud<2, 3>, draft: &mut Draft) {
    let mut far: Vec<_> = inner_edges(cloud)
        .filter(|(length, [a, b])| *length > super::FARTHEST * draft.size_between(*a, *b))
        .collect();
    far.sort_unstable_by(|p, q| q.0.total_cmp(&p.0).then(p.1.cmp(&q.1)));
    let mut used = vec![false; if far.is_empty() { 0 } else { cloud.place.len() }];
    for (_, [a, b]) in far {
        if [a, b].iter().all(|&n| !used[n as usize] && !draft.removed[n as usize]) {
            used[a as usize] = true;
            used[b as usize] = true;
            draft.add_between(cloud, a, b, Contacts::default());
        }
    }
}

/// Edges between two cells with their lengths.
fn inner_edges(cloud: &Cloud<2, 3>) -> impl Iterator<Item = (f64, [u32; 2])> + '_ {
    cloud.cells.iter().zip(&cloud.neighbours).enumerate().flat_map(move |(c, (cell, around))| {
        (0..3).filter(move |&i| around[i] != OUTSIDE && c < around[i] as usize).map(move |i| {
            let edge = [cell[(i + 1) % 3], cell[(i + 2) % 3]];
            (base_length(cloud, edge), edge)
        })
    })
}

fn base_length(cloud: &Cloud<2, 3>, [a, b]: [u32; 2]) -> f64 {
    distance(&cloud.place[a as usize], &cloud.place[b as usize])
}
