//! Where moving walls are at one instant.

use super::Walls;
use super::servo::Slide;
use super::shape::Piece;
use crate::vector::Vector;
use surface::motion::{Pose, Travel};

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
    /// Where the walls are at a time \[s\], those that slide where their slides are.
    pub fn poses(&self, time: f64, slides: &[Slide]) -> Poses<D> {
        self.posed(time, |wall| slides.get(wall).map(|slide| (slide.displacement, slide.velocity)))
    }

    /// Where the walls were when the neighbour list was built, at a time \[s\].
    pub fn listed_poses(&self, time: f64, slides: &[Slide]) -> Poses<D> {
        self.posed(time, |wall| slides.get(wall).map(|slide| (slide.listed, slide.velocity)))
    }

    fn posed(&self, time: f64, slid: impl Fn(usize) -> Option<(f64, f64)>) -> Poses<D> {
        if !(0..self.len()).any(|wall| self.moves(wall)) {
            return Poses(vec![]);
        }
        let pose = |wall: usize| {
            let prescribed = self.motions[wall].as_ref().map(|motion| motion.pose(time));
            let Some(servo) = &self.servos[wall] else { return prescribed };
            let (displacement, velocity) = slid(wall).unwrap_or_default();
            let (displacement, velocity) = (servo.direction * displacement, servo.direction * velocity);
            Some(prescribed.unwrap_or_else(Pose::rest).slid(&displacement, &velocity))
        };
        Poses((0..self.len()).map(pose).collect())
    }

    /// Whether a wall moves, as prescribed or under a force.
    pub fn moves(&self, wall: usize) -> bool {
        self.motions[wall].is_some() || self.servos[wall].is_some()
    }

    /// Whether a surface has no end and its wall turns it: no grain is ever far from such a surface for long.
    pub(super) fn tilts(&self, surface: usize) -> bool {
        let surface = &self.surfaces[surface];
        let motion = self.motions[surface.wall as usize].as_ref();
        motion.is_some_and(|motion| motion.axes().any(|axis| surface.shape.tilts(&axis)))
    }

    /// No wall came nearer to anything by more than this \[m\] between two instants; surfaces that tilt do not count.
    pub fn largest_approach(&self, before: &Poses<D>, after: &Poses<D>) -> f64 {
        let travel = |wall: u32| Some(Travel { before: before.of(wall)?, after: after.of(wall)? });
        let simple = self.surfaces[..self.simple].iter().enumerate().filter_map(|(index, surface)| {
            let travel = travel(surface.wall)?;
            (!self.tilts(index)).then(|| surface.shape.approach(&travel))
        });
        // The displacement is affine in the place, so that it is largest at a corner of the box.
        let of_facets = self.facets.iter().filter_map(|facets| {
            let travel = travel(facets.wall)?;
            let (lower, upper) = facets.bins.bounds();
            let ways = (0..1usize << D).map(|corner| {
                let start = Vector::from_fn(
                    |axis, _| if corner >> axis & 1 == 0 { lower[axis] } else { upper[axis] },
                );
                travel.of_point(&start).norm()
            });
            Some(ways.fold(0.0, f64::max))
        });
        simple.chain(of_facets).fold(0.0, f64::max)
    }
}
