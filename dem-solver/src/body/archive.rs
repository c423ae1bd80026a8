//! Clumps as arrays, for a checkpoint.

use nalgebra::{Quaternion, UnitQuaternion};

use super::{Bodies, Body, ClumpKind, Rigid};
use crate::vector::Vector;

/// Numbers of the motion of a clump: centre, orientation, velocity, angular momentum.
const NUMBERS: usize = 13;

/// All clumps, to the last bit.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyArrays {
    /// Identities of the first members.
    pub firsts: Vec<u64>,
    /// Kinds.
    pub kinds: Vec<u32>,
    /// Motions.
    pub motions: Vec<f64>,
}

impl BodyArrays {
    /// Those of these clumps.
    pub fn of(bodies: &Bodies) -> Self {
        let clumps = bodies.as_slice();
        let motion = |clump: &Rigid| {
            let Body { centre, orientation, velocity, angular_momentum } = clump.body;
            let [x, y, z] = centre.into();
            let [i, j, k, w] = orientation.coords.into();
            let [vx, vy, vz] = velocity.into();
            let [lx, ly, lz] = angular_momentum.into();
            [x, y, z, i, j, k, w, vx, vy, vz, lx, ly, lz]
        };
        Self {
            firsts: clumps.iter().map(|clump| clump.first).collect(),
            kinds: clumps.iter().map(|clump| clump.kind).collect(),
            motions: clumps.iter().flat_map(motion).collect(),
        }
    }

    /// The clumps, if the arrays fit each other and these kinds.
    pub fn restore(&self, kinds: &[ClumpKind]) -> Option<Bodies> {
        if self.kinds.len() != self.firsts.len() || self.motions.len() != NUMBERS * self.firsts.len() {
            return None;
        }
        let vector = |numbers: &[f64]| Vector::from([numbers[0], numbers[1], numbers[2]]);
        let numbers = self.motions.chunks_exact(NUMBERS);
        let clumps = self.firsts.iter().zip(&self.kinds).zip(numbers).map(|((&first, &kind), m)| {
            let orientation = UnitQuaternion::new_unchecked(Quaternion::new(m[6], m[3], m[4], m[5]));
            let body = Body {
                centre: vector(m),
                orientation,
                velocity: vector(&m[7..]),
                angular_momentum: vector(&m[10..]),
            };
            Some(Rigid { first, kind, shape: kinds.get(kind as usize)?.shape.clone(), body })
        });
        Bodies::new(clumps.collect::<Option<_>>()?)
    }
}
