//! The alpha shape: whatever was fluid before, cells of small spheres are.

use super::super::super::draft::Draft;
use super::super::tetrahedra::Tetrahedra;
use super::size;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, difference, dot, volume_and_areas};

/// Marks the cells that are fluid: those with a circumscribed sphere of at most α h in radius.
pub fn recognise(cloud: &Cloud<3, 4>, draft: &Draft<3>, alpha: f64, tetrahedra: &mut Tetrahedra) {
    tetrahedra.fluid.clear();
    for corners in &tetrahedra.made.cells {
        let radius = circumradius(&cloud.vertices(corners));
        tetrahedra.fluid.push(radius <= alpha * size(draft, corners));
    }
}

/// Radius of the circumscribed sphere (m): seen from the first corner its centre is Σ |x_i|² V∇N_i / 2V.
fn circumradius(vertices: &[Vector<3>; 4]) -> f64 {
    let (volume, areas) = volume_and_areas(vertices);
    let mut centre = [0.0; 3];
    for i in 1..4 {
        let x = difference(&vertices[i], &vertices[0]);
        for k in 0..3 {
            centre[k] += dot(&x, &x) * areas[i][k] / (2.0 * volume);
        }
    }
    dot(&centre, &centre).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corner_of_a_cube_has_the_sphere_of_the_cube() {
        let corner = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
        assert!((circumradius(&corner) - 3f64.sqrt()).abs() < 1e-15);
    }
}
