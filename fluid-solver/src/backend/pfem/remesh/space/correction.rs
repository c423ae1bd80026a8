//! The surface is shifted a little to restore the volume.

use super::super::correction::{LARGEST, RATE};
use super::super::draft::Draft;
use super::surface::cross;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::{Contacts, Wall};
use crate::element::simplex::{Vector, difference, dot};

/// Moves every node i of the free surface by λ G_i/|G_i|, G_i = ∂V/∂x_i (along the walls that it touches), with
/// λ = 0.2 B/Σ|G_i| within ±0.01 h, where B is the volume missing.
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

/// The part of a vector along all walls that a node touches.
fn along_walls(g: &Vector<3>, contacts: Contacts, x: &Vector<3>, walls: &[Wall<3>], time: f64) -> Vector<3> {
    let mut normals = contacts.iter().map(|wall| walls[wall].touch(x, time).normal);
    match (normals.next(), normals.next(), normals.next()) {
        (None, ..) => *g,
        (Some(n), None, _) => {
            let into = dot(g, &n);
            std::array::from_fn(|k| g[k] - into * n[k])
        }
        (Some(n), Some(m), None) => {
            let edge = cross(&n, &m);
            let share = dot(g, &edge) / dot(&edge, &edge).max(f64::MIN_POSITIVE);
            edge.map(|e| share * e)
        }
        _ => [0.0; 3],
    }
}
