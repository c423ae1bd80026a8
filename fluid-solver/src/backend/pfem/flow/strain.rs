//! How long a cell can be moved: det(I + t∇v) is a polynomial.

use super::cell::regular_volume;
use crate::element::simplex::{Vector, difference, dot, longest_edge, volume_and_areas};

/// How far a cell may be strained in a step. V* is the volume of a regular cell of the same longest edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strain {
    /// Share of the volume that is left, or of that of a thin cell if it is larger.
    pub least: f64,
    /// Share of V* below which a cell is thin.
    pub thin: f64,
    /// Share of V* that may be added.
    pub most: f64,
    /// Share of the longest edge by which corners may move against each other.
    pub shear: f64,
}

/// Share of V* below which a cell is a sliver, of no thickness but with long edges: it may turn over by as much, for the next
/// mesh replaces it. In the plane there are such only where walls or events leave them.
const SLIVER: [f64; 2] = [0.005, 0.02];

impl Default for Strain {
    fn default() -> Self {
        Self { least: 0.1, thin: 0.2, most: 0.6, shear: 1.0 }
    }
}

impl Strain {
    /// First time within `horizon` at which a cell whose corners move with v leaves its bounds.
    pub fn first_breach<const D: usize, const N: usize>(
        &self,
        corners: &[Vector<D>; N],
        v: &[Vector<D>; N],
        horizon: f64,
    ) -> Option<f64> {
        let rate = volume_polynomial(corners, v);
        let volume = rate[0];
        let edge = longest_edge(corners);
        let regular = regular_volume(D) * edge.powi(D as i32);
        let sliver = SLIVER[D - 2] * regular;
        let least = if volume < sliver { -sliver } else { self.least * volume.min(self.thin * regular) };
        let bounds = (least, volume + self.most * regular);
        let value = |t: f64| rate.iter().rev().fold(0.0, |sum, c| sum * t + c);
        let within = |t: f64| (bounds.0..=bounds.1).contains(&value(t));
        // A sliver has no volume to be strained, but its corners may fly apart.
        let sheared = self.shear * edge / longest_edge(v);
        let horizon = horizon.min(sheared);
        let mut start = 0.0;
        for end in turning_points(&rate).filter(|t| *t > 0.0 && *t < horizon).chain([horizon]) {
            if !within(end) {
                return Some(bisect(start, end, within));
            }
            start = end;
        }
        (horizon == sheared).then_some(sheared)
    }
}

/// Coefficients of V(t) = V det(I + t∇v), constant first; finite where V = 0.
fn volume_polynomial<const D: usize, const N: usize>(
    corners: &[Vector<D>; N],
    v: &[Vector<D>; N],
) -> [f64; 4] {
    let (volume, areas) = volume_and_areas(corners);
    let (leading, areas_of_velocity) = volume_and_areas(v);
    let product = |a: &[Vector<D>; N], x: &[Vector<D>; N]| -> f64 {
        (1..N).map(|i| dot(&a[i], &difference(&x[i], &x[0]))).sum()
    };
    let linear = product(&areas, v);
    if D == 2 {
        [volume, linear, leading, 0.0]
    } else {
        [volume, linear, product(&areas_of_velocity, corners), leading]
    }
}

/// Where the slope of a cubic vanishes, ascending.
fn turning_points(c: &[f64; 4]) -> impl Iterator<Item = f64> + use<> {
    let (a, half, constant) = (3.0 * c[3], c[2], c[1]);
    let root = (half * half - a * constant).max(0.0).sqrt();
    // Without cancellation: q and c/q.
    let q = -(half + half.signum() * root);
    let mut points = [q / a, constant / q];
    points.sort_by(f64::total_cmp);
    points.into_iter().filter(|t| t.is_finite())
}

/// The first of the times in (start, end] that is not within: start is, end is not, and the change is one.
fn bisect(mut start: f64, mut end: f64, within: impl Fn(f64) -> bool) -> f64 {
    while end - start > 1e-6 * end {
        let middle = 0.5 * (start + end);
        if within(middle) { start = middle } else { end = middle }
    }
    start
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [[f64; 2]; 3] = [[1.0, 2.0], [2.0, 2.0], [1.0, 3.0]];
    const PURE: Strain = Strain { least: 0.2, thin: 10.0, most: 10.0, shear: 10.0 };

    #[test]
    fn a_corner_that_falls_on_the_opposite_edge_may_go_four_fifths_of_the_way() {
        let v = [[5.0, 0.0], [5.0, 0.0], [5.0, -2.0]];
        let time = PURE.first_breach(&TRIANGLE, &v, 1.0).unwrap();
        assert!((time - 0.4).abs() < 1e-5, "{time}");
        assert_eq!(PURE.first_breach(&TRIANGLE, &v, 0.39), None);
    }

    #[test]
    fn a_cell_that_shrinks_from_all_sides_and_opens_again_is_found() {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let v = corners.map(|x| x.map(|x| -x));
        // (1 − t)³ = 0.2, though (1 − t)³ is negative at 3 and the square of it in the plane is positive.
        let time = PURE.first_breach(&corners, &v, 3.0).unwrap();
        assert!((time - (1.0 - 0.2f64.cbrt())).abs() < 1e-5, "{time}");
        let v = TRIANGLE.map(|x| [1.0 - x[0], 2.0 - x[1]]);
        let time = PURE.first_breach(&TRIANGLE, &v, 2.0).unwrap();
        assert!((time - (1.0 - 0.2f64.sqrt())).abs() < 1e-5, "{time}");
    }

    #[test]
    fn a_corner_of_a_sliver_may_not_be_flung_past_the_others() {
        let corners = [[0.0; 3], [1e-9, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let v = [[0.0; 3], [0.0; 3], [0.0; 3], [0.0, 0.0, 200.0]];
        let time = Strain::default().first_breach(&corners, &v, 1.0).unwrap();
        assert!((time - 2f64.sqrt() / 200.0).abs() < 1e-15, "{time}");
        assert_eq!(Strain::default().first_breach(&corners, &v, 0.9 * time), None);
    }

    #[test]
    fn a_rotation_and_a_translation_strain_nothing_by_themselves() {
        let v = TRIANGLE.map(|x| [-x[1], x[0]]);
        // det(I + t∇v) = 1 + t².
        assert_eq!(PURE.first_breach(&TRIANGLE, &v, 0.5), None);
        assert_eq!(PURE.first_breach(&TRIANGLE, &[[1e3, 1e3]; 3], 1e60), None);
    }
}
