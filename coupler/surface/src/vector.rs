//! Vectors of `D` components, and how they meet the three components of spin.

use nalgebra::SVector;

/// A vector in the space of the scene.
pub type Vector<const D: usize> = SVector<f64, D>;

/// Angular velocity and torque have three components in any dimension; in 2D only the last is not zero.
pub type Spin = SVector<f64, 3>;

/// The vector in three dimensions, z = 0 in 2D.
#[inline]
pub fn embed<const D: usize>(vector: &Vector<D>) -> Spin {
    Spin::from_fn(|axis, _| if axis < D { vector[axis] } else { 0.0 })
}

/// The first `D` components.
#[inline]
pub fn restrict<const D: usize>(vector: &Spin) -> Vector<D> {
    Vector::from_fn(|axis, _| vector[axis])
}

/// Velocity ω × r of a point at `arm` from the centre of a body that spins at `angular_velocity`.
#[inline]
pub fn spin_velocity<const D: usize>(angular_velocity: &Spin, arm: &Vector<D>) -> Vector<D> {
    restrict(&angular_velocity.cross(&embed(arm)))
}
