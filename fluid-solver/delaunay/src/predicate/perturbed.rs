//! The in-sphere predicate that is never zero.

use super::exact::{in_sphere, orientation};
use super::{rough_in_sphere, rough_orientation, unit_box};

/// Whether `point` lies inside the circumsphere of a positive simplex, the lifted coordinate of every point being raised by
/// an infinitesimal that is of a higher order the lower its rank is.
pub fn conflict<const D: usize, const N: usize>(
    corners: [&[f64; D]; N],
    point: &[f64; D],
    ranks: [u32; N],
    rank: u32,
) -> bool {
    if let Some((corners, point)) = unit_box::map(corners, point) {
        // Numbers so small and whole are not rounded.
        return raised(corners.each_ref(), &point, ranks, rank, rough_orientation);
    }
    let rounded = rough_in_sphere(corners, point);
    let sign = if rounded != 0.0 { rounded } else { in_sphere(corners, point) };
    if sign != 0.0 { sign > 0.0 } else { raised(corners, point, ranks, rank, orientation) }
}

/// The same for a point on the sphere.
///
/// The determinant vanishes; its derivative with respect to the coordinate raised most, which is the orientation of the
/// other points, tells; if that vanishes too, the next one does. That of `point` itself is the simplex's, so not zero.
fn raised<const D: usize, const N: usize>(
    corners: [&[f64; D]; N],
    point: &[f64; D],
    ranks: [u32; N],
    rank: u32,
    orientation: impl Fn([&[f64; D]; N]) -> f64,
) -> bool {
    let mut order: [usize; N] = std::array::from_fn(|k| k);
    order.sort_unstable_by_key(|k| std::cmp::Reverse(ranks[*k]));
    for k in order {
        if rank > ranks[k] {
            break;
        }
        // The simplex with `point` in the place of corner k.
        let side = orientation(std::array::from_fn(|i| if i == k { point } else { corners[i] }));
        if side != 0.0 {
            return side > 0.0;
        }
    }
    false
}
