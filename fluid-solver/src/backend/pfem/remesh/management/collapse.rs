//! Short edges of the surface become one node, so placed that the enclosed area stays.

use super::super::draft::{Draft, NONE};
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::{Contacts, Wall, inlet_of};
use crate::element::simplex::{Vector, difference, distance, dot};

/// Collapses edges shorter than half of h, shortest first.
///
/// The edge b–c between a and d becomes a node m with area(a, m, d) = area(a, b, c, d). A node at more walls than
/// the other keeps its place; the contact node of a wall does so too, and every node in an inlet.
pub fn collapse_short_edges(cloud: &mut Cloud<2, 3>, draft: &mut Draft, walls: &[Wall<2>], time: f64) {
    let length = |edge: &[u32; 2]| distance(&cloud.place[edge[0] as usize], &cloud.place[edge[1] as usize]);
    let mut short: Vec<(f64, [u32; 2])> = draft
        .edges
        .iter()
        .map(|edge| (length(edge), *edge))
        .filter(|(length, [b, c])| *length < super::SHORTEST * draft.size_between(*b, *c))
        .collect();
    short.sort_unstable_by(|p, q| p.0.total_cmp(&q.0).then(p.1.cmp(&q.1)));
    let mut touched = vec![false; if short.is_empty() { 0 } else { cloud.place.len() }];
    let mut collapsed = false;
    for (length, [b, c]) in short {
        let (a, d) = (draft.previous[b as usize], draft.next[c as usize]);
        let patch = [a, b, c, d];
        let simple = a != NONE && d != NONE && draft.next[b as usize] == c && draft.previous[c as usize] == b;
        if !simple || a == d || draft.next[d as usize] == a || patch.iter().any(|&n| touched[n as usize]) {
            continue;
        }
        let Some((survivor, place)) = merged(cloud, patch, length, draft.size_between(b, c), walls, time)
        else {
            continue;
        };
        let gone = if survivor == b { c } else { b };
        if cloud.contacts[b as usize] == cloud.contacts[c as usize] {
            let (v, w) = (cloud.velocity[b as usize], cloud.velocity[c as usize]);
            cloud.velocity[survivor as usize] = [0, 1].map(|k| 0.5 * (v[k] + w[k]));
        }
        cloud.place[survivor as usize] = place;
        draft.remove(gone);
        draft.next[a as usize] = survivor;
        draft.previous[d as usize] = survivor;
        draft.next[survivor as usize] = d;
        draft.previous[survivor as usize] = a;
        patch.iter().for_each(|&n| touched[n as usize] = true);
        collapsed = true;
        for edge in &mut draft.edges {
            // b–c vanishes as an edge from the survivor to itself.
            *edge = edge.map(|node| if node == gone { survivor } else { node });
        }
    }
    if collapsed {
        draft.edges.retain(|[a, b]| a != b);
    }
}

/// Which node of an edge b–c survives and where; none if it must stay.
fn merged(
    cloud: &Cloud<2, 3>,
    [a, b, c, d]: [u32; 4],
    length: f64,
    h: f64,
    walls: &[Wall<2>],
    time: f64,
) -> Option<(u32, Vector<2>)> {
    let at = |node: u32| cloud.place[node as usize];
    let contacts = |node: u32| cloud.contacts[node as usize];
    let (kb, kc) = (contacts(b), contacts(c));
    let (nb, nc) = (kb.iter().count(), kc.iter().count());
    let middle = [0, 1].map(|k| 0.5 * (at(b)[k] + at(c)[k]));
    if nb != nc {
        let survivor = if nb > nc { b } else { c };
        let fewer = if nb > nc { kc } else { kb };
        let slides = nb.max(nc) == 1 && inlet_of(walls, contacts(survivor)).is_none();
        if nb.max(nc) > 1 && nb.min(nc) > 0 {
            // Along one wall into a corner: nothing changes but the spacing.
            return (contacts(survivor).common(fewer) == fewer).then_some((survivor, at(survivor)));
        }
        let direction = slides.then(|| along_wall(contacts(survivor), &at(survivor), walls, time));
        let place = neutral([at(a), at(b), at(c), at(d)], at(survivor), direction, length, h)?;
        return Some((survivor, onto_wall(contacts(survivor), place, walls, time)));
    }
    if kb != kc {
        return None;
    }
    if inlet_of(walls, kb).is_some() {
        let ends_beside = |node: u32| contacts(node).common(kb) != kb;
        return match [a, d].map(ends_beside) {
            [true, true] => None,
            [false, true] => Some((c, at(c))),
            [_, false] => Some((b, at(b))),
        };
    }
    if nb > 1 {
        return None;
    }
    if nb == 0 {
        let [x, y] = difference(&at(d), &at(a));
        let norm = (x * x + y * y).sqrt();
        let direction = (norm > 0.3 * h).then(|| [-y / norm, x / norm]);
        let place = neutral([at(a), at(b), at(c), at(d)], middle, direction, length, h)?;
        let inside = walls.iter().all(|wall| wall.gap(&place, time) > 0.0);
        return Some((b, if inside { place } else { middle }));
    }
    // Both on one wall: the contact node, where the surface leaves the wall, keeps its place.
    let leaves = |node: u32| contacts(node).common(kb).is_empty();
    Some(if leaves(a) {
        (b, at(b))
    } else if leaves(d) {
        (c, at(c))
    } else {
        (b, onto_wall(kb, middle, walls, time))
    })
}

/// The place m + s n at which the area of the patch stays; none if that is too far away.
fn neutral(
    patch: [Vector<2>; 4],
    m: Vector<2>,
    direction: Option<Vector<2>>,
    length: f64,
    h: f64,
) -> Option<Vector<2>> {
    let [a, _, _, d] = patch;
    let before = polygon(&patch);
    let after = |m: Vector<2>| polygon(&[a, m, d]);
    let mut place = m;
    if let Some(n) = direction {
        let moved = |s: f64| [m[0] + s * n[0], m[1] + s * n[1]];
        let rate = (after(moved(h)) - after(m)) / h;
        if rate.abs() > 0.15 * h {
            let s = (before - after(m)) / rate;
            if s.abs() < 0.5 * h {
                place = moved(s);
            } else if length > 0.15 * h {
                return None;
            }
        }
    }
    let small = (after(place) - before).abs() <= 0.05 * h * h;
    (small || length <= 0.1 * h).then_some(place)
}

/// Direction along the wall that a node touches.
fn along_wall(contacts: Contacts, x: &Vector<2>, walls: &[Wall<2>], time: f64) -> Vector<2> {
    let normal = contacts.iter().next().map_or([0.0, 1.0], |wall| walls[wall].touch(x, time).normal);
    [-normal[1], normal[0]]
}

/// The nearest place of the wall that a node touches.
pub fn onto_wall(contacts: Contacts, mut x: Vector<2>, walls: &[Wall<2>], time: f64) -> Vector<2> {
    for wall in contacts.iter() {
        let touch = walls[wall].touch(&x, time);
        x = [0, 1].map(|k| x[k] - touch.gap * touch.normal[k]);
    }
    x
}

/// Signed area of a polygon.
fn polygon(corners: &[Vector<2>]) -> f64 {
    let origin = corners[0];
    let fan = corners.windows(2).map(|pair| {
        let (p, q) = (difference(&pair[0], &origin), difference(&pair[1], &origin));
        dot(&[p[0], p[1]], &[q[1], -q[0]])
    });
    0.5 * fan.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_collapsed_edge_of_a_curved_surface_keeps_the_area() {
        let at = |angle: f64| [angle.cos(), angle.sin()];
        let patch = [0.3, 0.5, 0.55, 0.8].map(at);
        let middle = [0, 1].map(|k| 0.5 * (patch[1][k] + patch[2][k]));
        let chord = difference(&patch[3], &patch[0]);
        let place = neutral(patch, middle, Some([-chord[1], chord[0]]), 0.05, 0.2).expect("near");
        assert!((polygon(&[patch[0], place, patch[3]]) - polygon(&patch)).abs() < 1e-15);
        assert!(distance(&place, &middle) < 0.02);
    }
}
