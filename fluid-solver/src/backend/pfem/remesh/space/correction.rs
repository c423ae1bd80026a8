//! The surface is shifted a little to restore the volume.

use super::super::correction::LARGEST;
use super::super::draft::Draft;
use super::freedom::along_walls;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::Wall;
use crate::element::simplex::{Vector, cross, difference, dot};

/// Share of what is missing that one step restores: more than in the plane. The rim of a jet that plunges in space gains in
/// nearly every step, and what a step gains stands for 1/RATE steps.
const RATE: f64 = 0.5;

/// Moves every node i of the free surface by λ G_i/|G_i|, G_i = ∂V/∂x_i (along the walls that it touches), with
/// λ = 0.5 B/Σ|G_i| within ±0.01 h, where B is the volume missing.
pub fn restore(
    cloud: &mut Cloud<3, 4>,
    draft: &Draft<3>,
    walls: &[Wall<3>],
    time: f64,
    missing: f64,
    gradient: &mut Vec<Vector<3>>,
) {
    gradient.clear();
    gradient.resize(cloud.place.len(), [0.0; 3]);
    for face in &draft.edges {
        let contacts = face.map(|node| cloud.contacts[node as usize]);
        if contacts[0].common(contacts[1]).common(contacts[2]).is_empty() {
            let [a, b, c] = face.map(|node| cloud.place[node as usize]);
            let area = cross(&difference(&b, &a), &difference(&c, &a));
            for &node in face {
                for k in 0..3 {
                    gradient[node as usize][k] += area[k] / 6.0;
                }
            }
        }
    }
    let (mut sum, mut size) = (0.0, f64::INFINITY);
    for (node, g) in gradient.iter_mut().enumerate() {
        size = size.min(draft.size[node]);
        if draft.exposed[node] {
            *g = along_walls(g, cloud.contacts[node], &cloud.place[node], walls, time);
            sum += dot(g, g).sqrt();
        }
    }
    let least = 1e-9 * size * size;
    if sum < least {
        return;
    }
    let shift = (RATE * missing / sum).clamp(-LARGEST * size, LARGEST * size);
    for (x, g) in cloud.place.iter_mut().zip(gradient) {
        let norm = dot(g, g).sqrt();
        if norm > least {
            *x = std::array::from_fn(|k| x[k] + shift * g[k] / norm);
        }
    }
}
