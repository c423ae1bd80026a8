//! Surfaces merge where the gap between them is thin and closing.

use super::super::draft::{Draft, area, circumradius, height};
use super::super::tessellation::Tessellation;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, difference};

/// A gap thinner than this share of h closes.
const GAP: f64 = 0.1;
/// Only triangles of void with a circle smaller than this share of h are gaps: a hollow of the surface is none.
const REACH: f64 = 1.2;

/// Makes thin triangles of void fluid whose area shrinks; returns their number and area.
pub fn close_gaps(cloud: &Cloud<2, 3>, draft: &Draft, triangles: &mut Tessellation) -> (u32, f64) {
    let (mut count, mut volume) = (0, 0.0);
    for triangle in 0..triangles.len() {
        if triangles.fluid[triangle] {
            continue;
        }
        let nodes = triangles.nodes(triangle);
        let vertices = triangles.vertices(triangle);
        let h = nodes.map(|node| draft.size[node as usize]).iter().sum::<f64>() / 3.0;
        let at_walls = nodes.iter().all(|&node| !cloud.contacts[node as usize].is_empty());
        let velocities = nodes.map(|node| cloud.velocity[node as usize]);
        if height(&vertices) <= GAP * h
            && circumradius(&vertices) <= REACH * h
            && !at_walls
            && rate_of_area(&vertices, &velocities) < 0.0
        {
            triangles.fluid[triangle] = true;
            count += 1;
            volume += area(&vertices);
        }
    }
    (count, volume)
}

/// dA/dt of a triangle whose corners move.
fn rate_of_area(x: &[Vector<2>; 3], v: &[Vector<2>; 3]) -> f64 {
    let (p, q) = (difference(&x[1], &x[0]), difference(&x[2], &x[0]));
    let (u, w) = (difference(&v[1], &v[0]), difference(&v[2], &v[0]));
    0.5 * (u[0] * q[1] - u[1] * q[0] + p[0] * w[1] - p[1] * w[0])
}
