//! Fluid that comes in through a wall.

use super::{Contacts, Grip, Wall};
use crate::boundary::VelocityField;
use crate::element::simplex::{Vector, difference, dot, volume_and_gradients};
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
    faces: Vec<Face<D>>,
    stated: VelocityField<D>,
}

/// A part of an inlet: a segment (in space: a triangle).
#[derive(Clone, Debug)]
struct Face<const D: usize> {
    corners: [Vector<D>; D],
    /// ∇λ_i of the shares λ_i of the corners in a point of its plane (1/m).
    slopes: [Vector<D>; D],
}

impl<const D: usize> Face<D> {
    /// Between corners, of a plane with this normal.
    fn new<const N: usize>(corners: [Vector<D>; D], normal: &Vector<D>) -> Self {
        let above = std::array::from_fn(|k| corners[0][k] + normal[k]);
        let (_, slopes) =
            volume_and_gradients::<D, N>(&std::array::from_fn(|i| *corners.get(i).unwrap_or(&above)));
        Self { corners, slopes: std::array::from_fn(|i| slopes[i]) }
    }

    /// Whether a point lies in it, and in its plane of this normal.
    fn holds(&self, x: &Vector<D>, normal: &Vector<D>) -> bool {
        let [from, to] = [0, 1].map(|i| difference(x, &self.corners[i]));
        let edge = difference(&from, &to);
        dot(normal, &from).abs() <= ON * dot(&edge, &edge).sqrt()
            && (0..D).all(|i| dot(&self.slopes[i], &difference(x, &self.corners[(i + 1) % D])) >= -ON)
    }
}

/// A point is in a face where its shares in the corners are above minus this, and nearer than this share of an edge.
const ON: f64 = 1e-9;

/// Walls whose normals are closer to that of an inlet than by the angle of this cosine are what it is cut into.
const ACROSS: f64 = 0.7;

impl<const D: usize> Inflow<D> {
    /// Fluid of a stated velocity (m/s) through faces.
    pub fn new<const N: usize>(
        normal: Vector<D>,
        area: f64,
        faces: impl Iterator<Item = [Vector<D>; D]>,
        stated: VelocityField<D>,
    ) -> Self {
        let faces = faces.map(|corners| Face::new::<N>(corners, &normal)).collect();
        Self { normal, area, share: 1.0, faces, stated }
    }

    /// Whether a point lies in it.
    pub fn holds(&self, x: &Vector<D>) -> bool {
        self.faces.iter().any(|face| face.holds(x, &self.normal))
    }

    /// The stated velocity (m/s).
    pub fn stated(&self, x: &Vector<D>, time: f64) -> Vector<D> {
        (self.stated)(x, time)
    }
}

impl<const D: usize> fmt::Debug for Inflow<D> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { normal, area, share, faces, .. } = self;
        let mut out = out.debug_struct("Inflow");
        out.field("normal", normal).field("area", area).field("share", share).field("faces", faces).finish()
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
