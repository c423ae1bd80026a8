//! Circumspheres, made once for every cell and asked often.

use super::{larger, plane, space};

/// Unit roundoff.
const ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// Circumsphere of a simplex, seen from its last corner: twice its centre 2c, and a bound of the error in each component of
/// it; not a number if the simplex is a ghost, next to flat or negative.
///
/// With the other corners a, b, … in rows, 2 c · a = |a|². Solved by Cramer's rule with all |aₖ| ≤ R, the determinant d is
/// wrong by less than 64 u R³ (2D: 16 u R²) and the numerators by less than 320 u R⁴ (2D: 80 u R³), u the unit roundoff.
#[inline(always)]
pub fn circumsphere<const D: usize, const N: usize>(corners: [&[f64; D]; N]) -> [f64; N] {
    let origin = corners[D];
    let mut sphere = [0.0; N];
    let mut reach = 0.0;
    for corner in &corners[..D] {
        for k in 0..D {
            reach = larger(reach, (corner[k] - origin[k]).abs());
        }
    }
    let (determinant, doubt) = if D == 2 {
        let [a, b] = [0, 1].map(|k| plane::from(corners[k], origin));
        let [la, lb] = [a, b].map(plane::lift);
        let determinant = plane::cross(a, b);
        sphere[0] = (la * b[1] - lb * a[1]) / determinant;
        sphere[1] = (lb * a[0] - la * b[0]) / determinant;
        (determinant, 16.0 * ROUNDOFF * (reach * reach))
    } else {
        let [a, b, c] = [0, 1, 2].map(|k| space::from(corners[k], origin));
        let [la, lb, lc] = [a, b, c].map(space::lift);
        let [bc, ca, ab] = [space::cross(b, c), space::cross(c, a), space::cross(a, b)];
        let determinant = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
        let inverse = 1.0 / determinant;
        for k in 0..3 {
            sphere[k] = (la * bc[k] + lb * ca[k] + lc * ab[k]) * inverse;
        }
        (determinant, 64.0 * ROUNDOFF * (reach * reach * reach))
    };
    let mut centre = 0.0;
    for k in 0..D {
        centre = larger(centre, sphere[k].abs());
    }
    // Seen from its last corner, a positive simplex has a negative determinant in space.
    let size = if D == 2 { determinant } else { -determinant };
    sphere[D] = if size > 1e4 * doubt {
        doubt * (5.0 * reach + centre) / size + 4.0 * ROUNDOFF * centre
    } else {
        f64::NAN
    };
    sphere
}

/// Whether a point lies inside (positive) or outside (negative) a circumsphere whose simplex has the last corner `origin`;
/// zero where rounding could have changed the sign.
///
/// Seen from a point of the sphere, e lies inside if e · (2c − e) > 0.
#[inline(always)]
pub fn in_circumsphere<const D: usize, const N: usize>(
    sphere: &[f64; N],
    origin: &[f64; D],
    point: &[f64; D],
) -> f64 {
    let (mut value, mut sum, mut length) = (0.0, 0.0, 0.0);
    for k in 0..D {
        let e = point[k] - origin[k];
        let term = e * (sphere[k] - e);
        value += term;
        sum += term.abs();
        length += e.abs();
    }
    let bound = length * sphere[D] + 12.0 * ROUNDOFF * sum;
    if value > bound || value < -bound { value } else { 0.0 }
}
