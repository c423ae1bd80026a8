//! Determinants in the plane.

use super::larger;

/// a − b.
#[inline(always)]
pub fn from<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// a × b.
#[inline(always)]
pub fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - b[0] * a[1]
}

/// |a|².
#[inline(always)]
pub fn lift(a: [f64; 2]) -> f64 {
    a[0] * a[0] + a[1] * a[1]
}

/// a × b and the bound of its error (Shewchuk 1997: (3 + 16 ε) ε times the same sum of absolute values).
#[inline(always)]
pub fn area([a, b]: [[f64; 2]; 2]) -> (f64, f64) {
    (cross(a, b), 3.4e-16 * ((a[0] * b[1]).abs() + (b[0] * a[1]).abs()))
}

/// |a|²a × … : the in-circle determinant of the corners a, b, c of a positive triangle, seen from the point, and the bound
/// of its error (Shewchuk 1997: (10 + 96 ε) ε times the same sum of absolute values, here bounded by the largest ones).
#[inline(always)]
pub fn in_circle([a, b, c]: [[f64; 2]; 3]) -> (f64, f64) {
    let value = lift(a) * cross(b, c) + lift(b) * cross(c, a) + lift(c) * cross(a, b);
    let [x, y] = [0, 1].map(|k| larger(larger(a[k].abs(), b[k].abs()), c[k].abs()));
    (value, 1.2e-15 * 6.0 * (x * y) * (x * x + y * y))
}
