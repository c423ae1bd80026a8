//! The conditions.

use crate::element::simplex::Vector;
use case_io::document::Profile;
use std::sync::Arc;

/// A velocity (m/s) at a place (m) and time (s).
pub type VelocityField<const D: usize> = Arc<dyn Fn(&Vector<D>, f64) -> Vector<D> + Send + Sync>;

/// What holds on a boundary.
#[derive(Clone)]
pub enum Condition<const D: usize> {
    /// The fluid sticks to a wall at rest.
    NoSlip,
    /// The fluid slides along: u·n = 0, no shear.
    Slip,
    /// The fluid sticks to a wall that moves in itself.
    MovingWall(VelocityField<D>),
    /// The velocity is stated; nodes shared with a wall where the fluid sticks keep the wall's.
    Inlet(Inflow<D>),
    /// −p n + τ·n = −p_o n with p_o (Pa) at the centre of the boundary and hydrostatic along it; fluid that comes
    /// back in brings no momentum (directional do-nothing: Braack and Mucha, *J. Comput. Math.* 32 (2014) 507).
    Outlet {
        /// p_o (Pa).
        pressure: f64,
    },
}

/// Rank of an inlet among the conditions that meet at a node.
pub(super) const INLET_RANK: u8 = 2;

/// How an inlet is stated: by its superficial velocity n_f u.
#[derive(Clone)]
pub enum Inflow<const D: usize> {
    /// The velocity.
    Velocity(VelocityField<D>),
    /// The mean speed along the inward normal: the nodal values are scaled so that the discrete flux is speed × area.
    Speed {
        /// Mean speed (m/s).
        mean: f64,
        /// Shape.
        profile: Profile,
    },
}

impl<const D: usize> Condition<D> {
    /// Which condition a node keeps where several meet: the highest.
    pub(super) fn rank(&self) -> u8 {
        match self {
            Self::Outlet { .. } => 0,
            Self::Slip => 1,
            Self::Inlet(_) => INLET_RANK,
            Self::MovingWall(_) => 3,
            Self::NoSlip => 4,
        }
    }

    /// Whether the fluid sticks.
    pub(super) fn sticks(&self) -> bool {
        matches!(self, Self::NoSlip | Self::MovingWall(_))
    }
}
