//! A regular lattice in a box.

use crate::vector::Vector;

/// Which lattice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LatticeKind {
    /// Squares, cubes.
    #[default]
    SimpleCubic,
    /// Triangles; in 3D hexagonal close packing, layers ABAB.
    Hexagonal,
}

/// A lattice of nearest-neighbour distance `spacing`, turned about the last axis (2D: in the plane) around the
/// lower corner, of which the centres inside the box count. The first centre is half a spacing from each side, so
/// that a box of n spacings holds n grains and goes on periodically.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice<const D: usize> {
    /// Corner of smallest coordinates \[m\].
    pub lower: Vector<D>,
    /// Corner of largest coordinates \[m\].
    pub upper: Vector<D>,
    /// Distance of nearest neighbours \[m\].
    pub spacing: f64,
    /// Which lattice.
    pub kind: LatticeKind,
    /// Turn \[rad\].
    pub turn: f64,
}

/// Centres this near to a side, in spacings, lie on it: on the lower one they count, on the upper one not.
const ON_SIDE: f64 = 1e-9;

impl<const D: usize> Lattice<D> {
    /// How many centres there will be, about.
    pub fn estimate(&self) -> f64 {
        (self.upper - self.lower).iter().map(|length| (length / self.spacing).max(1.0)).product()
    }

    /// The centres, the last axis slowest.
    pub fn centres(&self) -> Vec<Vector<D>> {
        let extent = self.upper - self.lower;
        // Indices that reach every corner of the box at any turn.
        let wide = (extent[0].hypot(extent[1]) / (0.8 * self.spacing)).ceil() as i64 + 2;
        let high = if D == 3 { (extent[2] / (0.8 * self.spacing)).ceil() as i64 + 1 } else { 1 };
        let flat = -wide..=wide;
        let mut centres = Vec::new();
        for k in 0..high {
            for j in flat.clone() {
                for i in flat.clone() {
                    let centre = self.turned(self.point(i, j, k));
                    let inside = (0..D).all(|axis| {
                        let (x, margin) = (centre[axis], ON_SIDE * self.spacing);
                        x >= -margin && x < extent[axis] - margin
                    });
                    if inside {
                        centres.push(self.lower + centre);
                    }
                }
            }
        }
        centres
    }

    fn point(&self, i: i64, j: i64, k: i64) -> [f64; 3] {
        let (x, y, z) = (i as f64 + 0.5, j as f64, k as f64);
        let half = |odd: i64| 0.5 * odd.rem_euclid(2) as f64;
        match self.kind {
            LatticeKind::SimpleCubic => [x, y + 0.5, z + 0.5],
            LatticeKind::Hexagonal => {
                let third = half(k) * 2.0 / 3.0;
                [x + half(j + k), 3.0_f64.sqrt() / 2.0 * (y + third) + 0.5, (2.0_f64 / 3.0).sqrt() * z + 0.5]
            }
        }
        .map(|coordinate| coordinate * self.spacing)
    }

    fn turned(&self, [x, y, z]: [f64; 3]) -> Vector<D> {
        let (sin, cos) = self.turn.sin_cos();
        let turned = [cos * x - sin * y, sin * x + cos * y, z];
        Vector::from_fn(|axis, _| turned[axis])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearest(centres: &[Vector<3>]) -> f64 {
        let distances =
            centres.iter().enumerate().flat_map(|(i, a)| centres[..i].iter().map(move |b| (a - b).norm()));
        distances.fold(f64::INFINITY, f64::min)
    }

    fn lattice(kind: LatticeKind, turn: f64, size: f64) -> Lattice<3> {
        Lattice { lower: Vector::zeros(), upper: Vector::from_element(size), spacing: 1.0, kind, turn }
    }

    #[test]
    fn a_cube_of_five_spacings_holds_125_grains_straight_or_turned_into_itself() {
        for turn in [0.0, (0.75_f64).atan()] {
            let centres = lattice(LatticeKind::SimpleCubic, turn, 5.0).centres();
            assert_eq!(centres.len(), 125, "turn {turn}");
            assert!((nearest(&centres) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn hexagonal_close_packing_is_close() {
        let centres = lattice(LatticeKind::Hexagonal, 0.0, 12.0).centres();
        assert!((nearest(&centres) - 1.0).abs() < 1e-12);
        // π/√18 of space is inside spheres of diameter 1; a box of 12 spacings is cut at its sides.
        let fraction = centres.len() as f64 * std::f64::consts::PI / 6.0 / 12.0_f64.powi(3);
        assert!((fraction / (std::f64::consts::PI / 18.0_f64.sqrt()) - 1.0).abs() < 0.06, "{fraction}");
        let middle = centres
            .iter()
            .min_by(|a, b| {
                (*a - Vector::from_element(6.0)).norm().total_cmp(&(*b - Vector::from_element(6.0)).norm())
            })
            .unwrap();
        assert_eq!(centres.iter().filter(|c| ((*c - middle).norm() - 1.0).abs() < 1e-9).count(), 12);
    }
}
