//! The surface is shifted a little to restore the volume.

use super::draft::Draft;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::{Wall, inlet_of};
use crate::element::simplex::{Vector, dot};

/// Share of what is missing that one step restores.
const RATE: f64 = 0.2;
/// Largest shift as a share of h.
pub const LARGEST: f64 = 0.01;

/// Area inside of the edges of the surface.
pub fn enclosed(cloud: &Cloud<2, 3>, draft: &Draft) -> f64 {
    let at = |node: u32| cloud.place[node as usize];
    draft.edges.iter().map(|[a, b]| 0.5 * (at(*a)[0] * at(*b)[1] - at(*a)[1] * at(*b)[0])).sum()
}

/// Moves every node i of the free surface by λ G_i/|G_i|, G_i = ∂V/∂x_i (along the walls that it touches), with
/// λ = 0.2 B/Σ|G_i| within ±0.01 h, where B is the volume missing. Returns λ/h.
pub fn restore(
    cloud: &mut Cloud<2, 3>,
    draft: &Draft,
    walls: &[Wall<2>],
    time: f64,
    missing: f64,
    gradient: &mut Vec<Vector<2>>,
) -> f64 {
    gradient.clear();
    gradient.resize(cloud.place.len(), [0.0; 2]);
    for &[a, b] in &draft.edges {
        let (a, b) = (a as usize, b as usize);
        if cloud.contacts[a].common(cloud.contacts[b]).is_empty() {
            let (from, to) = (cloud.place[a], cloud.place[b]);
            for end in [a, b] {
                gradient[end][0] += 0.5 * (to[1] - from[1]);
                gradient[end][1] -= 0.5 * (to[0] - from[0]);
            }
        }
    }
    let (mut sum, mut size) = (0.0, f64::INFINITY);
    for (node, g) in gradient.iter_mut().enumerate() {
        for wall in cloud.contacts[node].iter() {
            let normal = walls[wall].touch(&cloud.place[node], time).normal;
            let into = dot(g, &normal);
            *g = [0, 1].map(|k| g[k] - into * normal[k]);
        }
        if cloud.contacts[node].iter().count() > 1 || inlet_of(walls, cloud.contacts[node]).is_some() {
            *g = [0.0; 2];
        }
        sum += dot(g, g).sqrt();
        size = size.min(draft.size[node]);
    }
    if sum < 1e-9 * size {
        return 0.0;
    }
    let shift = (RATE * missing / sum).clamp(-LARGEST * size, LARGEST * size);
    for (node, g) in gradient.iter().enumerate() {
        let norm = dot(g, g).sqrt();
        if norm > 1e-9 * size {
            let place = [0, 1].map(|k| cloud.place[node][k] + shift * g[k] / norm);
            let leaves = |(index, wall): (usize, &Wall<2>)| {
                !cloud.contacts[node].contains(index) && wall.gap(&place, time) <= 0.0
            };
            if !walls.iter().enumerate().any(leaves) {
                cloud.place[node] = place;
            }
        }
    }
    shift / size
}
