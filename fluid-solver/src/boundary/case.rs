//! From the case document to conditions.

use super::{Condition, Inflow, VelocityField};
use crate::element::simplex::Vector;
use case_io::document::{Boundary, BoundaryKind, BoundaryVelocity};
use std::sync::Arc;

impl<const D: usize> Condition<D> {
    /// The condition that a checked table states.
    pub fn of(boundary: &Boundary) -> Self {
        match boundary.kind {
            BoundaryKind::NoSlip => Self::NoSlip,
            BoundaryKind::Slip => Self::Slip,
            BoundaryKind::MovingWall => Self::MovingWall(velocity_field(boundary.velocity.as_ref())),
            BoundaryKind::Inlet => Self::Inlet(match boundary.speed {
                Some(speed) => {
                    Inflow::Speed { mean: speed.si(), profile: boundary.profile.unwrap_or_default() }
                }
                None => Inflow::Velocity(velocity_field(boundary.velocity.as_ref())),
            }),
            // Loading has refused what needs a mesh that moves.
            BoundaryKind::FreeSurface | BoundaryKind::WallFunction | BoundaryKind::Outlet => {
                Self::Outlet { pressure: boundary.pressure.map_or(0.0, |pressure| pressure.si()) }
            }
        }
    }
}

/// The field that a velocity states; none is zero.
pub fn velocity_field<const D: usize>(velocity: Option<&BoundaryVelocity>) -> VelocityField<D> {
    match velocity {
        None => Arc::new(|_, _| [0.0; D]),
        Some(BoundaryVelocity::Constant(velocity)) => {
            let velocity: Vector<D> = velocity.to_array();
            Arc::new(move |_, _| velocity)
        }
        Some(BoundaryVelocity::Expression(components)) => {
            let components = components.clone();
            Arc::new(move |x, t| {
                let point = std::array::from_fn(|k| if k < D { x[k] } else { 0.0 });
                std::array::from_fn(|k| {
                    components.get(k).map_or(0.0, |component| component.evaluate(point, t))
                })
            })
        }
    }
}
