//! What existed stays: a cell is fluid if the moved old mesh covers it.

use super::super::draft::Draft;
use super::stars::Stars;
use super::tetrahedra::Tetrahedra;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, longest_edge};

/// A cell between inner nodes with edges shorter than this many h cannot hold void.
const DENSE: f64 = 1.5;
/// A cell with an edge longer than this many h is void.
const LONGEST: f64 = 5.0;
/// Weight of the middle of a cell among its samples; those towards its corners weigh 1 each.
const MIDDLE: f64 = 1.5;

/// Marks the cells that are fluid: those that were there before, those between inner nodes, and those of whose samples at
/// least half the weight lies in the moved old mesh.
pub fn recognise(cloud: &Cloud<3, 4>, draft: &Draft<3>, stars: &mut Stars, tetrahedra: &mut Tetrahedra) {
    tetrahedra.fluid.clear();
    for corners in &tetrahedra.made.cells {
        let vertices = cloud.vertices(corners);
        let h = corners.iter().map(|&node| draft.size[node as usize]).sum::<f64>() / 4.0;
        let length = longest_edge(&vertices);
        let inner = |node: &u32| !draft.exposed[*node as usize] && cloud.drop[*node as usize] == 0.0;
        let fluid = length <= LONGEST * h
            && (corners.iter().all(inner) && length <= DENSE * h
                || stars.has(cloud, corners)
                || existed(cloud, stars, corners, &vertices));
        tetrahedra.fluid.push(fluid);
    }
}

/// Whether most of a cell lies in the moved old mesh.
fn existed(cloud: &Cloud<3, 4>, stars: &mut Stars, corners: &[u32; 4], vertices: &[Vector<3>; 4]) -> bool {
    stars.gather(cloud, corners);
    let middle: Vector<3> = std::array::from_fn(|k| 0.25 * vertices.iter().map(|x| x[k]).sum::<f64>());
    let covered = |point: Vector<3>| stars.cover(cloud, &point) > 0;
    let towards = |x: &Vector<3>| std::array::from_fn(|k| 0.4 * middle[k] + 0.6 * x[k]);
    let count = vertices.iter().filter(|x| covered(towards(x))).count();
    let weight = count as f64 + if covered(middle) { MIDDLE } else { 0.0 };
    weight >= 0.5 * (4.0 + MIDDLE)
}
