//! The inside of the moved surface.

use super::super::draft::Draft;
use super::super::tessellation::{Scratch, Tessellation};
use super::{Predicate, crossings};
use crate::backend::pfem::cloud::Cloud;
use delaunay::{Error, HULL};

/// Winding number of the moved surface > 0.
///
/// The edges of the surface are edges of the triangulation, so that the number is the same all over a triangle: it
/// grows by one from right to left of an edge. Where surfaces have crossed it is 2, and counts once; where the
/// surface has turned inside out it is −1, and does not count.
pub struct MovedDomain;

impl Predicate for MovedDomain {
    fn recognise(
        &self,
        cloud: &mut Cloud<2, 3>,
        draft: &mut Draft,
        triangles: &mut Tessellation,
    ) -> Result<bool, Error> {
        let untouched = crossings::force_surface(cloud, draft, triangles)?;
        find_steps(draft, triangles);
        let mut scratch = std::mem::take(&mut triangles.scratch);
        let Scratch { winding, steps, front, .. } = &mut scratch;
        winding.clear();
        winding.resize(triangles.len(), None);
        front.clear();
        for triangle in 0..triangles.len() {
            for i in (0..3).filter(|&i| triangles.neighbours(triangle)[i] == HULL) {
                if winding[triangle].is_none() {
                    winding[triangle] = Some(steps[triangle][i]);
                    front.push(triangle);
                }
            }
        }
        while let Some(triangle) = front.pop() {
            let Some(here) = winding[triangle] else { continue };
            for (i, &next) in triangles.neighbours(triangle).iter().enumerate() {
                if next != HULL && winding[next as usize].is_none() {
                    winding[next as usize] = Some(here - steps[triangle][i]);
                    front.push(next as usize);
                }
            }
        }
        triangles.fluid.clear();
        triangles.fluid.extend(winding.iter().map(|number| number.is_some_and(|w| w > 0)));
        triangles.scratch = scratch;
        Ok(untouched)
    }
}

/// Finds by how much the winding number grows across each edge into the triangle.
fn find_steps(draft: &Draft, triangles: &mut Tessellation) {
    let Tessellation { made, scratch, point_of, .. } = triangles;
    let steps = &mut scratch.steps;
    steps.clear();
    steps.resize(made.triangulation.cells.len(), [0; 3]);
    for [a, b] in draft.edges.iter().map(|edge| edge.map(|node| point_of[node as usize])) {
        if let Some((triangle, i)) = made.left_of(a, b) {
            steps[triangle][i] += 1;
        }
        if let Some((triangle, i)) = made.left_of(b, a) {
            steps[triangle][i] -= 1;
        }
    }
}
