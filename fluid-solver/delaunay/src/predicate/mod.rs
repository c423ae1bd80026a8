//! Signs of determinants of points: first in floating point with a bound of the error, then exactly.
//!
//! Of points that [`crate::points::scale`] has scaled, no product under- or overflows.

mod exact;
mod perturbed;
mod plane;
pub mod space;
mod sphere;
mod unit_box;

pub use exact::{collinear, orientation};
pub use perturbed::conflict;
use space::FACE;
pub use sphere::{circumsphere, in_circumsphere};

/// Corners of the face opposite to corner `at`, turned so that the simplex between it and `point` has the sense of the one
/// that has `point` in the place of that corner.
#[inline(always)]
pub fn face<const N: usize>(corners: &[u32; N], at: usize, point: u32) -> [u32; N] {
    let mut simplex = [point; N];
    for k in 0..N - 1 {
        simplex[k] = corners[if N == 3 { (at + k + 1) % 3 } else { FACE[at][k] }];
    }
    simplex
}

/// D! times the volume of a simplex whose corner `at` is replaced by `point`, rounded; the sign may be wrong where it is
/// close to zero. Not a number if the simplex is a ghost.
#[inline(always)]
pub fn rough_side<const D: usize, const N: usize>(
    corners: [&[f64; D]; N],
    at: usize,
    point: &[f64; D],
) -> f64 {
    if D == 2 {
        let [a, b] = [1, 2].map(|k| plane::from(corners[(at + k) % 3], point));
        plane::cross(a, b)
    } else {
        let [a, b, c] = FACE[at].map(|k| space::from(corners[k], point));
        space::volume(a, b, c)
    }
}

/// D! times the volume of a simplex; zero where rounding could have changed the sign, and of a ghost.
#[inline(always)]
fn rough_orientation<const D: usize, const N: usize>(corners: [&[f64; D]; N]) -> f64 {
    let (value, bound) = if D == 2 {
        plane::area([1, 2].map(|k| plane::from(corners[k], corners[0])))
    } else {
        space::volume_and_bound([0, 1, 2].map(|k| space::from(corners[k], corners[3])))
    };
    if value > bound || value < -bound { value } else { 0.0 }
}

/// Sign of the in-sphere determinant, positive if `point` lies inside the circumsphere of a positive simplex; zero where
/// rounding could have changed the sign, and of a ghost.
#[inline(always)]
fn rough_in_sphere<const D: usize, const N: usize>(corners: [&[f64; D]; N], point: &[f64; D]) -> f64 {
    let (value, bound) = if D == 2 {
        plane::in_circle([0, 1, 2].map(|k| plane::from(corners[k], point)))
    } else {
        space::in_sphere([0, 1, 2, 3].map(|k| space::from(corners[k], point)))
    };
    if value > bound || value < -bound { value } else { 0.0 }
}

/// The larger of two numbers of which none is "not a number": one instruction.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
