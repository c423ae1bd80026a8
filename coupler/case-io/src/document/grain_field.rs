//! Fields of the grains in a frame.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A field of the grains in `frames/grains-N.vtp`, one value for each grain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum GrainField {
    /// Identity.
    Id,
    /// Radius in m.
    Radius,
    /// Mass in kg.
    Mass,
    /// Velocity in m/s.
    Velocity,
    /// Angular velocity in rad/s.
    AngularVelocity,
    /// Index of the material, in the order of their names.
    Material,
    /// Sum of the forces of its contacts in N, as they were at rest: no dashpots, no bonds; 0 for frozen grains.
    ContactForce,
    /// Sum of the torques of these forces about its centre in N m; resistance to rolling is not in it.
    ContactTorque,
    /// Number of its contacts; 0 for frozen grains.
    Coordination,
    /// m v²/2 + I ω²/2 in J; 0 for frozen grains.
    KineticEnergy,
}

impl GrainField {
    /// Those of a frame whose case states none.
    pub const DEFAULT: [Self; 5] =
        [Self::Id, Self::Radius, Self::Velocity, Self::AngularVelocity, Self::Material];

    /// Its name in the frame.
    pub fn name(self) -> &'static str {
        match self {
            Self::Id => "id",
            Self::Radius => "radius",
            Self::Mass => "mass",
            Self::Velocity => "velocity",
            Self::AngularVelocity => "angular_velocity",
            Self::Material => "material",
            Self::ContactForce => "contact_force",
            Self::ContactTorque => "contact_torque",
            Self::Coordination => "coordination",
            Self::KineticEnergy => "kinetic_energy",
        }
    }

    /// Whether it is one of contacts.
    pub fn is_of_contacts(self) -> bool {
        matches!(self, Self::ContactForce | Self::ContactTorque | Self::Coordination)
    }
}
