//! The edges of the surface become edges of the triangulation; where they cross there is a node.

use super::super::draft::Draft;
use super::super::tessellation::Tessellation;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::Contacts;
use crate::element::simplex::{Vector, difference, distance, dot};
use delaunay::Error;
use delaunay::constrained::Obstacle;

/// Rounds of triangulation after which edges that still cross are left out.
const ROUNDS: usize = 12;
/// A crossing closer than this share of h to a node is that node, in the first rounds: edges that lie along each other can
/// cross again for ever where they are moved onto nodes.
const SNAP: f64 = 0.1;
/// Those rounds.
const SNAPPING: usize = 6;

/// Triangulates the nodes and forces the surface; false if the surface had to be changed for it.
///
/// # Errors
/// A place that is not finite.
pub fn force_surface(
    cloud: &mut Cloud<2, 3>,
    draft: &mut Draft,
    triangles: &mut Tessellation,
) -> Result<bool, Error> {
    let mut untouched = true;
    for round in 0.. {
        triangles.triangulate(cloud, draft)?;
        let crossing = force(draft, triangles, &mut untouched);
        if crossing.is_empty() || round == ROUNDS {
            triangles.made.restore(&triangles.points);
            break;
        }
        untouched = false;
        let mut splits = Vec::new();
        let snap = if round < SNAPPING { SNAP } else { 0.0 };
        for (edge, other) in &crossing {
            let node = node_at_crossing(cloud, draft, *edge, *other, snap);
            splits.extend([(sorted(*edge), node), (sorted(*other), node)]);
        }
        splits.sort_unstable();
        splits.dedup();
        draft.edges.extend(crossing.iter().map(|(edge, _)| *edge));
        split(cloud, draft, &splits);
    }
    Ok(untouched)
}

/// Forces the edges of the draft in; those that could not be are taken out of it and returned with what they cross.
fn force(draft: &mut Draft, triangles: &mut Tessellation, untouched: &mut bool) -> Vec<([u32; 2], [u32; 2])> {
    let mut crossing = Vec::new();
    let mut waiting = std::mem::take(&mut draft.waiting);
    waiting.extend(draft.edges.drain(..).rev());
    while let Some(edge) = waiting.pop() {
        let [a, b] = edge;
        if a == b {
            continue;
        }
        let [p, q] = edge.map(|node| triangles.point_of[node as usize]);
        match triangles.made.force(&triangles.points, p, q) {
            Ok(()) => draft.edges.push(edge),
            Err(Obstacle::Point(m)) => {
                *untouched = false;
                let middle = triangles.node_of[m as usize];
                waiting.extend([[middle, b], [a, middle]]);
            }
            Err(Obstacle::Edge(other)) => {
                crossing.push((edge, other.map(|point| triangles.node_of[point as usize])));
            }
        }
    }
    draft.waiting = waiting;
    crossing
}

/// The node where two edges cross: one of their ends if that is nearer than a share of h, or a new one.
fn node_at_crossing(
    cloud: &mut Cloud<2, 3>,
    draft: &mut Draft,
    edge: [u32; 2],
    other: [u32; 2],
    snap: f64,
) -> u32 {
    let at = |node: u32| cloud.place[node as usize];
    let ([a, b], [c, d]) = (edge.map(at), other.map(at));
    let cross = |p: &Vector<2>, q: &Vector<2>| p[0] * q[1] - p[1] * q[0];
    let (ab, cd, ac) = (difference(&b, &a), difference(&d, &c), difference(&c, &a));
    let share = |along: f64| if along.is_nan() { 0.0 } else { along.clamp(0.0, 1.0) };
    let s = share(cross(&ac, &cd) / cross(&ab, &cd));
    let t = share(cross(&ac, &ab) / cross(&ab, &cd));
    let place = [0, 1].map(|k| a[k] + s * ab[k]);
    let size = draft.size_between(edge[0], edge[1]);
    let ends = [edge[0], edge[1], other[0], other[1]];
    let near = |node: &u32| distance(&at(*node), &place) <= snap * size;
    if let Some(node) = ends.into_iter().find(near) {
        return node;
    }
    let v = |node: u32| cloud.velocity[node as usize];
    let p = |node: u32| cloud.pressure[node as usize];
    let between = |from: f64, to: f64, share: f64| (1.0 - share) * from + share * to;
    let velocity = [0, 1].map(|k| {
        0.5 * (between(v(edge[0])[k], v(edge[1])[k], s) + between(v(other[0])[k], v(other[1])[k], t))
    });
    let pressure = 0.5 * (between(p(edge[0]), p(edge[1]), s) + between(p(other[0]), p(other[1]), t));
    let mut contacts = Contacts::default();
    for [a, b] in [edge, other] {
        let common = cloud.contacts[a as usize].common(cloud.contacts[b as usize]);
        common.iter().for_each(|wall| contacts.insert(wall));
    }
    draft.add(cloud, place, velocity, pressure, contacts, size)
}

/// Splits edges at nodes: `splits` holds sorted pairs of an edge and a node.
fn split(cloud: &Cloud<2, 3>, draft: &mut Draft, splits: &[([u32; 2], u32)]) {
    let mut edges = Vec::with_capacity(draft.edges.len() + splits.len());
    for &[a, b] in &draft.edges {
        let key = sorted([a, b]);
        let from = splits.partition_point(|(edge, _)| *edge < key);
        let on_it = splits[from..].iter().take_while(|(edge, _)| *edge == key);
        let (start, end) = (cloud.place[a as usize], cloud.place[b as usize]);
        let direction = difference(&end, &start);
        let along = |node: u32| dot(&difference(&cloud.place[node as usize], &start), &direction);
        let mut nodes: Vec<u32> = on_it.map(|(_, node)| *node).filter(|n| ![a, b].contains(n)).collect();
        nodes.sort_unstable_by(|p, q| along(*p).total_cmp(&along(*q)).then(p.cmp(q)));
        let mut last = a;
        for node in nodes.into_iter().chain([b]) {
            edges.push([last, node]);
            last = node;
        }
    }
    draft.edges = edges;
}

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
