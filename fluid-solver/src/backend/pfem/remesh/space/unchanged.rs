//! Cells that still are as good as new ones stay, lest a mesh at rest flickers.

use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::element::simplex::{Vector, difference, dot, volume_and_areas};

/// How far inside a sphere a point counts as on it, as a share of the fifth power of the distance.
const ROUNDOFF: f64 = 1e-9;

/// Whether all cells are positive and no neighbour's corner lies in the sphere of a cell by more than round-off.
pub fn still_delaunay(cloud: &Cloud<3, 4>) -> bool {
    cloud.cells.iter().zip(&cloud.neighbours).enumerate().all(|(index, (cell, around))| {
        let vertices = cloud.vertices(cell);
        volume_and_areas(&vertices).0 > 0.0
            && (0..4).filter(|&i| around[i] != OUTSIDE && around[i] as usize > index).all(|i| {
                let other = &cloud.cells[around[i] as usize];
                let apex = other.iter().find(|node| !cell.contains(node));
                apex.is_some_and(|&apex| !inside_sphere(&vertices, &cloud.place[apex as usize]))
            })
    })
}

/// Whether a point lies in the sphere through the corners by more than round-off.
///
/// Seen from the first corner, 2 V c = Σ |x_i|² V∇N_i, and e lies inside if |e|² < 2 c · e.
fn inside_sphere(vertices: &[Vector<3>; 4], point: &Vector<3>) -> bool {
    let (volume, areas) = volume_and_areas(vertices);
    let e = difference(point, &vertices[0]);
    let mut excess = -volume * dot(&e, &e);
    let mut reach = dot(&e, &e);
    for i in 1..4 {
        let x = difference(&vertices[i], &vertices[0]);
        excess += dot(&x, &x) * dot(&areas[i], &e);
        reach = reach.max(dot(&x, &x));
    }
    excess > ROUNDOFF * reach.powf(2.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_eighth_corner_of_a_cube_lies_on_the_sphere_and_its_middle_in_it() {
        let cell = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!(!inside_sphere(&cell, &[1.0; 3]));
        assert!(inside_sphere(&cell, &[1.0 - 1e-6; 3]));
        assert!(!inside_sphere(&cell, &[1.0 + 1e-6; 3]));
    }
}
