//! A rigid body in motion.

use nalgebra::{Unit, UnitQuaternion};

use super::Clump;
use crate::vector::Vector;

/// A clump in motion: all that changes.
///
/// Its angular momentum is kept in space, where nothing but torque changes it: between kicks it is conserved to the
/// last bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Centre of mass \[m\].
    pub centre: Vector<3>,
    /// Rotation from the principal frame into space.
    pub orientation: UnitQuaternion<f64>,
    /// Velocity of the centre of mass \[m/s\].
    pub velocity: Vector<3>,
    /// Angular momentum L about the centre of mass \[kg m²/s\].
    pub angular_momentum: Vector<3>,
}

/// A member as the body carries it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried {
    /// Its centre \[m\].
    pub centre: Vector<3>,
    /// Velocity of its centre \[m/s\].
    pub velocity: Vector<3>,
    /// Its angular velocity, that of the body \[rad/s\].
    pub angular_velocity: Vector<3>,
}

/// What acts on a body, or on a member, at its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Force \[N\].
    pub force: Vector<3>,
    /// Torque \[N m\].
    pub torque: Vector<3>,
}

impl Body {
    /// Angular velocity ω \[rad/s\].
    pub fn angular_velocity(&self, clump: &Clump) -> Vector<3> {
        let momentum = self.orientation.inverse_transform_vector(&self.angular_momentum);
        self.orientation * momentum.component_div(&Vector::from(clump.moments()))
    }

    /// Where its members are and how they move, in their order.
    pub fn members<'a>(&self, clump: &'a Clump) -> impl Iterator<Item = Carried> + use<'a> {
        let body = *self;
        let angular_velocity = body.angular_velocity(clump);
        clump.members().iter().map(move |member| {
            let arm = body.orientation * member.offset;
            Carried {
                centre: body.centre + arm,
                velocity: body.velocity + angular_velocity.cross(&arm),
                angular_velocity,
            }
        })
    }

    /// The loads on its members, one each and in their order, as one at its centre of mass: F = Σ F_k,
    /// T = Σ T_k + r_k × F_k.
    pub fn gather(&self, clump: &Clump, loads: impl IntoIterator<Item = Load>) -> Load {
        let mut total = Load { force: Vector::zeros(), torque: Vector::zeros() };
        for (member, load) in clump.members().iter().zip(loads) {
            total.force += load.force;
            total.torque += load.torque + (self.orientation * member.offset).cross(&load.force);
        }
        total
    }

    /// Gives the body the momentum of a load in a time \[s\].
    pub fn kick(&mut self, clump: &Clump, load: &Load, time: f64) {
        self.velocity += load.force * (time / clump.mass());
        self.angular_momentum += load.torque * time;
    }

    /// Flies the body, free, for a time \[s\].
    ///
    /// With l = Rᵀ L the energy of rotation is |L|²/2I₂ + l₁²/2 (1/I₁ - 1/I₂) + l₃²/2 (1/I₃ - 1/I₂). Each part alone is a
    /// steady rotation: about L, and about the first and the third principal axis. The first commutes with the
    /// others, which follow each other as ½, 1, ½: symplectic, reversible and of second order, and exact where two of the
    /// moments are equal.
    ///
    /// Source: splitting after Dullweber, Leimkuhler & McLachlan, J. Chem. Phys. 107 (1997) 5840–5851; the part about
    /// L as in van Zon, Omelyan & Schofield, J. Chem. Phys. 128 (2008) 136102.
    pub fn drift(&mut self, clump: &Clump, time: f64) {
        self.centre += self.velocity * time;
        let [least, middle, most] = clump.moments();
        let momentum = self.angular_momentum;
        let mut orientation = UnitQuaternion::from_scaled_axis(momentum * (time / middle)) * self.orientation;
        let mut turn = |axis: Unit<Vector<3>>, moment: f64, time: f64| {
            let rate =
                orientation.inverse_transform_vector(&momentum).dot(&axis) * (1.0 / moment - 1.0 / middle);
            orientation *= UnitQuaternion::from_axis_angle(&axis, rate * time);
        };
        turn(Vector::x_axis(), least, 0.5 * time);
        turn(Vector::z_axis(), most, time);
        turn(Vector::x_axis(), least, 0.5 * time);
        orientation.renormalize();
        self.orientation = orientation;
    }

    /// m v²/2 + ω·L/2 \[J\].
    pub fn kinetic_energy(&self, clump: &Clump) -> f64 {
        0.5 * (clump.mass() * self.velocity.norm_squared()
            + self.angular_velocity(clump).dot(&self.angular_momentum))
    }
}
