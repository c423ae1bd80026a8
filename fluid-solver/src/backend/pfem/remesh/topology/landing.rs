//! A node that a film keeps off a wet wall lands on it.

use super::super::draft::{Draft, area, height};
use super::super::tessellation::Tessellation;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::{Wall, inlet_of};
use crate::element::simplex::dot;
use delaunay::HULL;

/// A film thinner than this share of h is none.
const FILM: f64 = 0.05;

/// Puts nodes onto the wall that a thin cell keeps them off; the cell goes and the others around the node take its
/// place. The wall takes the momentum towards it. Returns their number and the change of area.
pub fn land_on_walls(
    cloud: &mut Cloud<2, 3>,
    draft: &Draft,
    triangles: &mut Tessellation,
    walls: &[Wall<2>],
    time: f64,
    momentum: &mut [f64; 2],
) -> (u32, f64) {
    let (mut count, mut change) = (0, 0.0);
    for triangle in 0..triangles.len() {
        for i in 0..3 {
            let nodes = triangles.nodes(triangle);
            let apex = nodes[i] as usize;
            let [a, b] = [1, 2].map(|k| cloud.contacts[nodes[(i + k) % 3] as usize]);
            let Some(wall) = a.common(b).iter().find(|&wall| !cloud.contacts[apex].contains(wall)) else {
                continue;
            };
            if inlet_of(walls, a.common(b)).is_some() {
                continue;
            }
            let next = triangles.neighbours(triangle)[i];
            let at_wall = next == HULL || !triangles.fluid[next as usize];
            let thin = || height(&triangles.vertices(triangle)) < FILM * draft.size[apex];
            if !triangles.fluid[triangle] || !at_wall || !thin() {
                continue;
            }
            let touch = walls[wall].touch(&cloud.place[apex], time);
            let landed = [0, 1].map(|k| cloud.place[apex][k] - touch.gap * touch.normal[k]);
            if touch.gap > FILM * draft.size[apex] {
                continue;
            }
            let Some(gained) = gained_without(triangles, triangle, nodes[i], landed) else { continue };
            change += gained;
            triangles.fluid[triangle] = false;
            triangles.points[triangles.point_of[apex] as usize] = landed;
            cloud.place[apex] = landed;
            cloud.contacts[apex].insert(wall);
            let v = cloud.velocity[apex];
            let into = dot(&v, &touch.normal) - dot(&touch.velocity, &touch.normal);
            cloud.velocity[apex] = [0, 1].map(|k| v[k] - into * touch.normal[k]);
            *momentum = [0, 1].map(|k| momentum[k] - draft.mass[apex] * into * touch.normal[k]);
            count += 1;
        }
    }
    (count, change)
}

/// Area gained if a triangle goes and a node of it moves; none if another triangle would turn over.
fn gained_without(triangles: &Tessellation, gone: usize, node: u32, place: [f64; 2]) -> Option<f64> {
    let mut gained = -area(&triangles.vertices(gone));
    for other in (0..triangles.len()).filter(|&other| other != gone && triangles.fluid[other]) {
        if let Some(corner) = triangles.nodes(other).iter().position(|&n| n == node) {
            let mut vertices = triangles.vertices(other);
            gained -= area(&vertices);
            vertices[corner] = place;
            if area(&vertices) <= 0.0 {
                return None;
            }
            gained += area(&vertices);
        }
    }
    Some(gained)
}
