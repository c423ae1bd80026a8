//! Drops that fall into the fluid are taken up.

use super::super::draft::Draft;
use super::super::tessellation::Tessellation;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, barycentric, distance, volume_and_gradients};

/// A drop closer to the fluid than this share of h is taken up.
const NEAR: f64 = 0.1;

/// Takes up the drops that lie in the fluid or touch it: the corners of the cell there get their momentum, and their
/// volume is owed. Returns their number and volume.
pub fn absorb_drops(cloud: &mut Cloud<2, 3>, draft: &mut Draft, triangles: &Tessellation) -> (u32, f64) {
    let (mut count, mut volume) = (0, 0.0);
    for drop in 0..cloud.place.len() {
        if cloud.drop[drop] == 0.0 || draft.removed[drop] {
            continue;
        }
        if let Some(host) = host(&cloud.place[drop], NEAR * draft.size[drop], triangles) {
            let nodes = triangles.nodes(host);
            let mass = cloud.drop[drop];
            let around: f64 = nodes.iter().map(|&node| draft.mass[node as usize]).sum();
            for k in 0..2 {
                let given = mass * cloud.velocity[drop][k] / (around + mass);
                for node in nodes.map(|node| node as usize) {
                    cloud.velocity[node][k] = cloud.velocity[node][k] * around / (around + mass) + given;
                }
            }
            draft.remove(drop as u32);
            cloud.drop[drop] = 0.0;
            count += 1;
            volume += mass;
        }
    }
    (count, volume)
}

/// The cell that a drop lies in or next to.
fn host(place: &Vector<2>, near: f64, triangles: &Tessellation) -> Option<usize> {
    (0..triangles.len()).filter(|&triangle| triangles.fluid[triangle]).find(|&triangle| {
        let vertices = triangles.vertices(triangle);
        let outside = (0..2).any(|k| {
            let low = vertices.iter().map(|x| x[k]).fold(f64::INFINITY, f64::min);
            let high = vertices.iter().map(|x| x[k]).fold(f64::NEG_INFINITY, f64::max);
            place[k] < low - near || place[k] > high + near
        });
        !outside && (inside(&vertices, place) || distance_to(&vertices, place) <= near)
    })
}

fn inside(vertices: &[Vector<2>; 3], place: &Vector<2>) -> bool {
    let (_, gradients) = volume_and_gradients(vertices);
    barycentric(&gradients, vertices, place).iter().all(|&share| share >= 0.0)
}

/// Distance of a point from the sides of a triangle (m).
fn distance_to(vertices: &[Vector<2>; 3], place: &Vector<2>) -> f64 {
    let side = |k: usize| {
        let (a, b) = (vertices[k], vertices[(k + 1) % 3]);
        let along = |p: &Vector<2>| (p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1]);
        let share = (along(place) / along(&b)).clamp(0.0, 1.0);
        distance(place, &[0, 1].map(|i| a[i] + share * (b[i] - a[i])))
    };
    (0..3).map(side).fold(f64::INFINITY, f64::min)
}
