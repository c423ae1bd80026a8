//! Determinants in space.

use super::larger;

/// Corners of the face opposite to each corner, in the order in which a point in the corner's place sees them positive.
pub const FACE: [[usize; 3]; 4] = [[1, 3, 2], [0, 2, 3], [0, 3, 1], [0, 1, 2]];

/// a − b.
#[inline(always)]
pub fn from<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// |a|².
#[inline(always)]
pub fn lift(a: [f64; 3]) -> f64 {
    a[0] * a[0] + a[1] * a[1] + a[2] * a[2]
}

/// a × b.
#[inline(always)]
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// −a · (b × c): six times the volume of the tetrahedron (a, b, c, 0).
#[inline(always)]
pub fn volume(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    a[2] * (c[0] * b[1] - b[0] * c[1])
        + b[2] * (a[0] * c[1] - c[0] * a[1])
        + c[2] * (b[0] * a[1] - a[0] * b[1])
}

/// −a · (b × c) and the bound of its error (Shewchuk 1997: (7 + 56 ε) ε times the same sum of absolute values, here bounded
/// by the largest ones).
#[inline(always)]
pub fn volume_and_bound([a, b, c]: [[f64; 3]; 3]) -> (f64, f64) {
    let [x, y, z] = [0, 1, 2].map(|k| larger(larger(a[k].abs(), b[k].abs()), c[k].abs()));
    (volume(a, b, c), 7.8e-16 * 6.0 * (x * y * z))
}

/// The in-sphere determinant of the corners a, b, c, d of a positive tetrahedron, seen from the point, and the bound of its
/// error (Shewchuk 1997: (16 + 224 ε) ε times the same sum of absolute values, here bounded by the largest ones).
#[inline(always)]
pub fn in_sphere([a, b, c, d]: [[f64; 3]; 4]) -> (f64, f64) {
    let minor = |a: [f64; 3], b: [f64; 3]| a[0] * b[1] - b[0] * a[1];
    let (ab, bc, cd, da, ac, bd) =
        (minor(a, b), minor(b, c), minor(c, d), minor(d, a), minor(a, c), minor(b, d));
    let abc = a[2] * bc - b[2] * ac + c[2] * ab;
    let bcd = b[2] * cd - c[2] * bd + d[2] * bc;
    let cda = c[2] * da + d[2] * ac + a[2] * cd;
    let dab = d[2] * ab + a[2] * bd + b[2] * da;
    let value = (lift(c) * dab - lift(d) * abc) + (lift(a) * bcd - lift(b) * cda);
    let [x, y, z] = [0, 1, 2].map(|k| larger(larger(a[k].abs(), b[k].abs()), larger(c[k].abs(), d[k].abs())));
    (value, 1.8e-15 * 24.0 * (x * y * z) * (x * x + y * y + z * z))
}
