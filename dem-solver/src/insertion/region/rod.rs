//! A cylinder with ends.

use std::f64::consts::PI;

use super::{Space, in_unit_ball};
use crate::domain::Domain;
use crate::insertion::Random;
use crate::vector::{Spin, Vector, embed, restrict};

/// A circular cylinder with flat ends (3D).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderRegion<const D: usize> {
    /// Centre of one end \[m\].
    pub start: Vector<D>,
    /// Centre of the other end \[m\].
    pub end: Vector<D>,
    /// Radius \[m\].
    pub radius: f64,
}

impl<const D: usize> CylinderRegion<D> {
    /// The unit vector along the axis, and the length.
    fn axis(&self) -> (Vector<D>, f64) {
        let span = self.end - self.start;
        (span.normalize(), span.norm())
    }
}

impl<const D: usize> Space<D> for CylinderRegion<D> {
    fn bounds(&self) -> (Vector<D>, Vector<D>) {
        let half = self.axis().0.map(|a| self.radius * (1.0 - a * a).max(0.0).sqrt());
        (self.start.inf(&self.end) - half, self.start.sup(&self.end) + half)
    }

    fn volume(&self) -> f64 {
        PI * self.radius * self.radius * self.axis().1
    }

    fn holds(&self, point: &Vector<D>) -> bool {
        let ((axis, length), from_start) = (self.axis(), point - self.start);
        let along = from_start.dot(&axis);
        (0.0..=length).contains(&along) && (from_start - axis * along).norm() <= self.radius
    }

    fn place(&self, _: &Domain<D>, radius: f64, random: &mut Random) -> Option<Vector<D>> {
        let (axis, length) = self.axis();
        let room = self.radius - radius;
        if room < 0.0 || length < 2.0 * radius {
            return None;
        }
        let across = embed(&axis).cross(&Spin::ith(embed(&axis).iamin(), 1.0)).normalize();
        let third = embed(&axis).cross(&across);
        let [u, v]: [f64; 2] = (in_unit_ball::<2>(random) * room).into();
        let along = random.between(radius, length - radius);
        Some(self.start + axis * along + restrict::<D>(&(across * u + third * v)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::insertion::region::{Region, SphereRegion};

    #[test]
    fn places_fill_the_region_evenly_and_none_sticks_out() {
        let rod = CylinderRegion {
            start: Vector::<3>::from([0.1, 0.2, 0.3]),
            end: Vector::from([0.1, 1.4, 1.2]),
            radius: 0.5,
        };
        let ball = SphereRegion { centre: Vector::<3>::from([1.0, 2.0, 3.0]), radius: 0.7 };
        let (domain, mut random) = (Domain::unbounded(), Random::new(4));
        for region in [Region::Cylinder(rod), Region::Sphere(ball)] {
            let (lower, upper) = region.bounds();
            let places: Vec<_> =
                (0..20_000).filter_map(|_| region.place(&domain, 0.1, &mut random)).collect();
            assert_eq!(places.len(), 20_000);
            let reach = [Vector::x(), Vector::y(), Vector::z()];
            for place in &places {
                assert!(
                    reach
                        .iter()
                        .all(|e| region.holds(&(place + e * 0.0999)) && region.holds(&(place - e * 0.0999)))
                );
            }
            let mean = places.iter().sum::<Vector<3>>() / 2e4;
            assert!((mean - (lower + upper) / 2.0).norm() < 1e-2, "{mean:?}");
            // Half of the places are where half of the room is.
            let within = |share: f64| match region {
                Region::Sphere(ball) => {
                    places.iter().filter(|p| (*p - ball.centre).norm() < 0.6 * share.cbrt()).count()
                }
                _ => places
                    .iter()
                    .filter(|p| {
                        let (axis, from) = (rod.axis().0, *p - rod.start);
                        (from - axis * from.dot(&axis)).norm() < 0.4 * share.sqrt()
                    })
                    .count(),
            };
            assert!((within(0.5) as f64 / 2e4 - 0.5).abs() < 2e-2, "{}", within(0.5));
            assert!(region.place(&domain, 1.0, &mut random).is_none());
        }
    }
}
