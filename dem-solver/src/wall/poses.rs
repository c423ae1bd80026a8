//! Where moving walls are at one instant.

use super::motion::Pose;
use super::{Shape, Walls};
use crate::vector::{Vector, embed};

/// The poses of the walls at one instant; a wall without one is where it was at t = 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Poses<const D: usize>(Vec<Option<Pose<D>>>);

impl<const D: usize> Poses<D> {
    /// The pose of a wall, if it moves.
    #[inline]
    pub fn of(&self, wall: u32) -> Option<&Pose<D>> {
        self.0.get(wall as usize)?.as_ref()
    }
}

impl<const D: usize> Walls<D> {
    /// Where the walls are at a time \[s\].
    pub fn poses(&self, time: f64) -> Poses<D> {
        if self.motions.iter().all(Option::is_none) {
            return Poses(vec![]);
        }
        Poses(self.motions.iter().map(|motion| motion.map(|motion| motion.pose(time))).collect())
    }

    /// Whether a surface is a plane that turns its normal: no grain is ever far from such a plane for long.
    pub(super) fn tilts(&self, surface: usize) -> bool {
        let surface = &self.surfaces[surface];
        let (Shape::Plane(plane), Some(motion)) = (surface.shape, self.motions[surface.wall as usize]) else {
            return false;
        };
        motion.angular_velocity.cross(&embed(&plane.normal)).norm_squared() > 0.0
    }

    /// No wall came nearer to anything by more than this \[m\] between two instants; planes that tilt do not count.
    pub fn largest_approach(&self, before: &Poses<D>, after: &Poses<D>) -> f64 {
        let moved = |wall: u32, start: &Vector<D>| -> Vector<D> {
            match (before.of(wall), after.of(wall)) {
                (Some(before), Some(after)) => after.moved(start) - before.moved(start),
                _ => Vector::zeros(),
            }
        };
        let of_planes = self.surfaces[..self.planes].iter().enumerate().map(|(index, surface)| {
            let Shape::Plane(plane) = surface.shape else { return 0.0 };
            if self.tilts(index) { 0.0 } else { moved(surface.wall, &plane.point).dot(&plane.normal).abs() }
        });
        // The displacement is affine in the place, so that it is largest at a corner of the box.
        let of_facets = self.facets.iter().flat_map(|facets| {
            let (lower, upper) = facets.bins.bounds();
            (0..1usize << D).map(move |corner| {
                let start = Vector::from_fn(
                    |axis, _| if corner >> axis & 1 == 0 { lower[axis] } else { upper[axis] },
                );
                moved(facets.wall, &start).norm()
            })
        });
        of_planes.chain(of_facets).fold(0.0, f64::max)
    }
}
