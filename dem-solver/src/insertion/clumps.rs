//! How clumps of one insertion begin.

use std::f64::consts::TAU;

use nalgebra::{Quaternion, UnitQuaternion};

use super::random::Random;
use crate::body::{Body, ClumpKind};
use crate::vector::{Spin, Vector, embed};

/// How clumps are turned at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Orientation {
    /// By this rotation.
    Given(UnitQuaternion<f64>),
    /// At random, uniformly over all rotations; in 2D over those about z.
    Random,
}

/// How clumps of one insertion begin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClumpStart {
    /// Which kind of the scene.
    pub kind: u32,
    /// How they are turned.
    pub orientation: Orientation,
    /// Angular velocity \[rad/s\].
    pub angular_velocity: Spin,
}

impl ClumpStart {
    /// A clump with this centre of mass \[m\] and velocity \[m/s\].
    pub fn body<const D: usize>(
        &self,
        kind: &ClumpKind,
        centre: &Vector<D>,
        velocity: &Vector<D>,
        random: &mut Random,
    ) -> Body {
        let rotation = match self.orientation {
            Orientation::Given(rotation) => rotation,
            Orientation::Random => random_rotation::<D>(random),
        };
        let body = kind.shape.body(Spin::zeros(), rotation, embed(velocity), self.angular_velocity);
        Body { centre: embed(centre), ..body }
    }
}

/// Source: Shoemake, Uniform random rotations, in: Graphics Gems III (1992) 124–132.
fn random_rotation<const D: usize>(random: &mut Random) -> UnitQuaternion<f64> {
    let mut angle = || random.between(0.0, TAU);
    if D == 2 {
        return UnitQuaternion::from_scaled_axis(Spin::new(0.0, 0.0, angle()));
    }
    let (one, other) = (angle(), angle());
    let share = random.between(0.0, 1.0);
    let (a, b) = ((1.0 - share).sqrt(), share.sqrt());
    let (i, j, k, w) = (a * one.sin(), a * one.cos(), b * other.sin(), b * other.cos());
    UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k))
}
