//! How much of a cell lies in the moved old mesh, by samples.

use super::super::super::draft::Draft;
use super::size;
use super::stars::Stars;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::{Vector, longest_edge};

/// A cell with an edge longer than this many h is void.
const LONGEST: f64 = 3.0;
/// Weight of the middle of a cell among its samples; those towards its corners weigh 1 each.
const MIDDLE: f64 = 1.5;

/// Whether a cell was there before, or at least half the weight of its samples lies in the moved old mesh.
pub fn existed(cloud: &Cloud<3, 4>, draft: &Draft<3>, stars: &mut Stars, corners: &[u32; 4]) -> bool {
    let vertices = cloud.vertices(corners);
    longest_edge(&vertices) <= LONGEST * size(draft, corners)
        && (stars.has(cloud, corners) || covered(cloud, stars, corners, &vertices))
}

fn covered(cloud: &Cloud<3, 4>, stars: &mut Stars, corners: &[u32; 4], vertices: &[Vector<3>; 4]) -> bool {
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
