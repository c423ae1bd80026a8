//! Clumps to try things on.

use dem_solver::Vector;
use dem_solver::body::{Body, Clump, MassProperties, Member};
use nalgebra::{Matrix3, UnitQuaternion};

pub const DENSITY: f64 = 2500.0;

pub fn member(offset: [f64; 3], radius: f64) -> Member {
    Member { offset: Vector::from(offset), radius }
}

/// Five spheres that touch and do not overlap, with three unlike moments.
pub fn jack() -> [Member; 5] {
    let r = 1e-3;
    [
        member([0.0, 0.0, 0.0], r),
        member([2.0 * r, 0.0, 0.0], r),
        member([-2.0 * r, 0.0, 0.0], r),
        member([0.0, 1.7 * r, 0.0], 0.7 * r),
        member([0.0, 0.0, 1.5 * r], 0.5 * r),
    ]
}

/// A body of these principal moments that spins at this angular velocity in its own axes, which are those of space.
pub fn with_moments(moments: [f64; 3], angular_velocity: [f64; 3]) -> (Clump, Body) {
    let inertia = Matrix3::from_diagonal(&Vector::from(moments));
    let properties = MassProperties { mass: 1.0, centre: Vector::zeros(), inertia };
    let clump = Clump::with_mass(&[member([0.0; 3], 1.0)], &properties).unwrap();
    let body = at_rest(&clump);
    (clump.clone(), Body { angular_momentum: inertia * Vector::from(angular_velocity), ..body })
}

pub fn at_rest(clump: &Clump) -> Body {
    clump.body(Vector::zeros(), UnitQuaternion::identity(), Vector::zeros(), Vector::zeros())
}
