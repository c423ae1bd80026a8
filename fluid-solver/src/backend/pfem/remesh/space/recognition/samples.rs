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

/// Whether a cell is longer than those of fluid are.
pub fn is_long(cloud: &Cloud<3, 4>, draft: &Draft<3>, corners: &[u32; 4]) -> bool {
    longest_edge(&cloud.vertices(corners)) > LONGEST * size(draft, corners)
}

/// The share of a cell that lies in the moved old mesh, by the weight of its samples; 1 if it was there before, 0 if it is too
/// long.
pub fn covered(cloud: &Cloud<3, 4>, draft: &Draft<3>, stars: &mut Stars, corners: &[u32; 4]) -> f64 {
    if stars.has(cloud, corners) {
        return 1.0;
    }
    if is_long(cloud, draft, corners) {
        return 0.0;
    }
    let vertices = cloud.vertices(corners);
    stars.gather(cloud, corners);
    let middle: Vector<3> = std::array::from_fn(|k| 0.25 * vertices.iter().map(|x| x[k]).sum::<f64>());
    let weight = |point: Vector<3>, weight: f64| if stars.cover(&point) > 0 { weight } else { 0.0 };
    let towards = |x: &Vector<3>| std::array::from_fn(|k| 0.4 * middle[k] + 0.6 * x[k]);
    let of_corners: f64 = vertices.iter().map(|x| weight(towards(x), 1.0)).sum();
    (weight(middle, MIDDLE) + of_corners) / (4.0 + MIDDLE)
}
