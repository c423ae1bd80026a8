//! The shell of a cylinder with ends.

use super::{Nearest, Piece, axial_and_radial, circle_bounds};
use crate::vector::{Spin, Vector};
use surface::motion::Travel;

/// The thin shell of a circular cylinder, open at both ends; it pushes to both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube<const D: usize> {
    /// Centre of one end \[m\].
    pub start: Vector<D>,
    /// Unit vector along the axis, to the other end.
    pub axis: Vector<D>,
    /// Length \[m\].
    pub length: f64,
    /// Radius \[m\].
    pub radius: f64,
}

impl<const D: usize> Tube<D> {
    fn end(&self) -> Vector<D> {
        self.start + self.axis * self.length
    }
}

impl<const D: usize> Piece<D> for Tube<D> {
    /// The foot on the shell, beyond an end the nearest point of its rim.
    #[inline]
    fn nearest(&self, centre: &Vector<D>) -> Nearest<D> {
        let (axial, radial) = axial_and_radial(centre, &self.start, &self.axis);
        let off_axis = radial.norm();
        let (beyond, within) = (axial - axial.clamp(0.0, self.length), self.radius - off_axis);
        let distance = beyond.hypot(within);
        let to_wall = || radial * (within / off_axis) - self.axis * beyond;
        let normal = if off_axis > 0.0 && distance > 0.0 { to_wall() / distance } else { Vector::zeros() };
        Nearest { distance, normal }
    }

    fn bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        let [one, other] =
            [self.start, self.end()].map(|centre| circle_bounds(&centre, &self.axis, self.radius));
        Some((one.0.inf(&other.0), one.1.sup(&other.1)))
    }

    fn encloses(&self) -> bool {
        false
    }

    fn tilts(&self, _: &Spin) -> bool {
        false
    }

    /// The axis is displaced at most as its ends are; a turn of the axis takes the shell along.
    fn approach(&self, travel: &Travel<D>) -> f64 {
        let of_axis = travel.of_point(&self.start).norm().max(travel.of_point(&self.end()).norm());
        of_axis + self.radius * travel.of_direction(&self.axis).norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AXIS: [f64; 3] = [0.6, 0.0, 0.8];

    fn tube() -> Tube<3> {
        Tube { start: Vector::from([0.1, 0.2, 0.3]), axis: Vector::from(AXIS), length: 1.5, radius: 0.4 }
    }

    #[test]
    fn no_sampled_point_of_the_shell_is_nearer() {
        let tube = tube();
        let (one, other) = (Vector::from([0.8, 0.0, -0.6]), Vector::from([0.0, 1.0, 0.0]));
        for k in 0..100 {
            let k = f64::from(k);
            let p = Vector::from([(k * 0.37).sin() * 1.5, (k * 0.73).cos(), (k * 1.1).sin() * 2.0]);
            let nearest = tube.nearest(&p);
            let foot = p + nearest.normal * nearest.distance;
            let (axial, radial) = axial_and_radial(&foot, &tube.start, &tube.axis);
            assert!((radial.norm() - tube.radius).abs() < 1e-12 && (-1e-12..1.5 + 1e-12).contains(&axial));
            for angle in 0..60 {
                let (sine, cosine) = (f64::from(angle) * 0.1048).sin_cos();
                for step in 0..=30 {
                    let q = tube.start
                        + tube.axis * (0.05 * f64::from(step))
                        + (one * cosine + other * sine) * 0.4;
                    assert!(nearest.distance <= (q - p).norm() + 1e-12);
                }
            }
        }
    }

    #[test]
    fn the_box_holds_the_rims() {
        let (low, high) = tube().bounds().unwrap();
        assert!((low - Vector::from([0.1 - 0.4 * 0.8, -0.2, 0.3 - 0.4 * 0.6])).norm() < 1e-12);
        assert!((high - Vector::from([1.0 + 0.4 * 0.8, 0.6, 1.5 + 0.4 * 0.6])).norm() < 1e-12);
    }
}
