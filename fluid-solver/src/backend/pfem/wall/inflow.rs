//! Fluid that comes in through a wall.

use super::{Contacts, Grip, Wall};
use crate::boundary::VelocityField;
use crate::element::simplex::{Vector, dot};
use std::fmt;

/// What a wall lets in. Its nodes have the velocity of the fluid and stay where they are, so that the mesh reaches the wall
/// at all times.
#[derive(Clone)]
pub struct Inflow<const D: usize> {
    /// Unit normal into the fluid.
    pub normal: Vector<D>,
    /// Its area (m²; m in 2D).
    pub area: f64,
    /// Share of the stated velocity that nodes have, so that faces round the rim, where it falls to zero, bring no more
    /// than the stated velocity through the area.
    pub share: f64,
    stated: VelocityField<D>,
}

/// Walls whose normals are closer to that of an inlet than by the angle of this cosine are what it is cut into.
const ACROSS: f64 = 0.7;

impl<const D: usize> Inflow<D> {
    /// Fluid of a stated velocity (m/s).
    pub fn new(normal: Vector<D>, area: f64, stated: VelocityField<D>) -> Self {
        Self { normal, area, share: 1.0, stated }
    }

    /// The stated velocity (m/s).
    pub fn stated(&self, x: &Vector<D>, time: f64) -> Vector<D> {
        (self.stated)(x, time)
    }
}

impl<const D: usize> fmt::Debug for Inflow<D> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { normal, area, share, .. } = self;
        out.debug_struct("Inflow").field("normal", normal).field("area", area).field("share", share).finish()
    }
}

/// The inlet that a node is in, if any.
pub fn inlet_of<const D: usize>(walls: &[Wall<D>], contacts: Contacts) -> Option<(usize, &Inflow<D>)> {
    contacts.iter().find_map(|wall| Some((wall, walls[wall].inflow.as_ref()?)))
}

/// Velocity of a node in an inlet: that of the fluid that comes in, or of a wall beside the inlet where the fluid sticks;
/// none elsewhere.
pub fn inlet_velocity<const D: usize>(
    walls: &[Wall<D>],
    contacts: Contacts,
    x: &Vector<D>,
    time: f64,
) -> Option<Vector<D>> {
    let (_, inflow) = inlet_of(walls, contacts)?;
    let sticking = contacts.iter().filter(|&wall| walls[wall].grip == Grip::NoSlip);
    let held = sticking
        .map(|wall| walls[wall].touch(x, time))
        .find(|touch| dot(&touch.normal, &inflow.normal).abs() < ACROSS);
    Some(match held {
        Some(touch) => touch.velocity,
        None => inflow.stated(x, time).map(|component| inflow.share * component),
    })
}
