//! A circle, a sphere, or a cylinder without ends.

use super::Touch;
use crate::element::simplex::{Vector, difference, dot};

/// The points with |r| = R, r = (x − c) − (a·(x − c)) a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round<const D: usize> {
    /// Centre c, or a point of the axis (m).
    pub centre: Vector<D>,
    /// Unit vector a along the axis; zero for a circle or a sphere.
    pub axis: Vector<D>,
    /// R (m).
    pub radius: f64,
    /// Whether the fluid is in it, not around it.
    pub holds_fluid: bool,
}

impl<const D: usize> Round<D> {
    /// How it stands to a point; on the axis all normals are as good, and it is one of them.
    pub(super) fn touch(&self, x: &Vector<D>) -> Touch<D> {
        let from_centre = difference(x, &self.centre);
        let along = dot(&from_centre, &self.axis);
        let arm: Vector<D> = std::array::from_fn(|k| from_centre[k] - along * self.axis[k]);
        let distance = dot(&arm, &arm).sqrt();
        let outwards = if distance > 0.0 { arm.map(|c| c / distance) } else { self.any_normal() };
        let (gap, sign) =
            if self.holds_fluid { (self.radius - distance, -1.0) } else { (distance - self.radius, 1.0) };
        Touch { gap, normal: outwards.map(|c| sign * c), velocity: [0.0; D] }
    }

    fn any_normal(&self) -> Vector<D> {
        let flattest =
            (1..D).fold(0, |least, k| if self.axis[k].abs() < self.axis[least].abs() { k } else { least });
        let across: Vector<D> =
            std::array::from_fn(|k| f64::from(u8::from(k == flattest)) - self.axis[flattest] * self.axis[k]);
        let length = dot(&across, &across).sqrt();
        across.map(|c| c / length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gap_is_the_distance_to_the_nearest_place_on_the_side_of_the_fluid() {
        let drum = Round { centre: [1.0, 1.0], axis: [0.0; 2], radius: 2.0, holds_fluid: true };
        let touch = drum.touch(&[1.0, 2.5]);
        assert_eq!((touch.gap, touch.normal), (0.5, [0.0, -1.0]));
        let pile = Round { holds_fluid: false, ..drum };
        assert_eq!(pile.touch(&[1.0, 2.5]).gap, -0.5);
        let pipe = Round { centre: [0.0; 3], axis: [0.0, 0.0, 1.0], radius: 1.0, holds_fluid: true };
        let touch = pipe.touch(&[0.25, 0.0, 7.0]);
        assert_eq!((touch.gap, touch.normal), (0.75, [-1.0, 0.0, 0.0]));
    }

    #[test]
    fn on_the_axis_there_is_a_normal_too() {
        let pipe = Round { centre: [0.0; 3], axis: [0.6, 0.0, 0.8], radius: 1.0, holds_fluid: true };
        let touch = pipe.touch(&[0.0; 3]);
        assert_eq!(touch.gap, 1.0);
        assert!((dot(&touch.normal, &touch.normal) - 1.0).abs() < 1e-15);
        assert!(dot(&touch.normal, &pipe.axis).abs() < 1e-15);
    }
}
