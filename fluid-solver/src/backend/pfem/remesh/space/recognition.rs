//! Which tetrahedra between the moved nodes are fluid.

use super::super::draft::Draft;
use super::stars::Stars;
use super::tetrahedra::Tetrahedra;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, difference, dot, longest_edge, volume_and_areas};

/// A cell between inner nodes with edges shorter than this many h cannot hold void.
const DENSE: f64 = 1.5;
/// A cell with an edge longer than this many h is void.
const LONGEST: f64 = 3.0;
/// Weight of the middle of a cell among its samples; those towards its corners weigh 1 each.
const MIDDLE: f64 = 1.5;

/// Marks the cells that are fluid: those that were there before, those between inner nodes, and those of whose samples at
/// least half the weight lies in the moved old mesh.
pub fn moved_domain(cloud: &Cloud<3, 4>, draft: &Draft<3>, stars: &mut Stars, tetrahedra: &mut Tetrahedra) {
    tetrahedra.fluid.clear();
    for corners in &tetrahedra.made.cells {
        let vertices = cloud.vertices(corners);
        let h = size(draft, corners);
        let length = longest_edge(&vertices);
        let inner = |node: &u32| !draft.exposed[*node as usize] && cloud.drop[*node as usize] == 0.0;
        let fluid = length <= LONGEST * h
            && (corners.iter().all(inner) && length <= DENSE * h
                || stars.has(cloud, corners)
                || existed(cloud, stars, corners, &vertices));
        tetrahedra.fluid.push(fluid);
    }
}

/// Marks the cells that are fluid: those with a circumscribed sphere of at most α h in radius.
pub fn alpha_shape(cloud: &Cloud<3, 4>, draft: &Draft<3>, alpha: f64, tetrahedra: &mut Tetrahedra) {
    tetrahedra.fluid.clear();
    for corners in &tetrahedra.made.cells {
        let radius = circumradius(&cloud.vertices(corners));
        tetrahedra.fluid.push(radius <= alpha * size(draft, corners));
    }
}

/// Mean h of the corners (m).
fn size(draft: &Draft<3>, corners: &[u32; 4]) -> f64 {
    corners.iter().map(|&node| draft.size[node as usize]).sum::<f64>() / 4.0
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

/// Whether most of a cell lies in the moved old mesh.
fn existed(cloud: &Cloud<3, 4>, stars: &mut Stars, corners: &[u32; 4], vertices: &[Vector<3>; 4]) -> bool {
    stars.gather(cloud, corners);
    let middle: Vector<3> = std::array::from_fn(|k| 0.25 * vertices.iter().map(|x| x[k]).sum::<f64>());
    let covered = |point: Vector<3>| stars.cover(&point) > 0;
    let towards = |x: &Vector<3>| std::array::from_fn(|k| 0.4 * middle[k] + 0.6 * x[k]);
    let mut lacking = 0.5 * (4.0 + MIDDLE) - if covered(middle) { MIDDLE } else { 0.0 };
    for (tried, x) in vertices.iter().enumerate() {
        if lacking <= 0.0 || lacking > (4 - tried) as f64 {
            break;
        }
        lacking -= if covered(towards(x)) { 1.0 } else { 0.0 };
    }
    lacking <= 0.0
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
