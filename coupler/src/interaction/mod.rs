//! The interaction laws: what the fluid does to a grain, and the grain to the fluid.
//!
//! In the pressure-split (model A) form of the two-fluid equations a grain feels
//! F = β(u − v) − V∇p + V∇·τ + m_A(Du/Dt − dv/dt), and the fluid −β(u − v) − m_A(Du/Dt − dv/dt): the reactions to the two
//! stress forces are in its n_f∇p and n_f∇·τ (Anderson & Jackson 1967). Laws are pure functions of SI values.

pub mod added_mass;
pub mod drag;
pub mod exchange;
pub mod pressure_gradient;
pub mod self_disturbance;
pub mod torque;
pub mod viscous_stress;

mod error;
mod model;
mod reaction;
mod shape;

#[cfg(test)]
mod tests;

pub use error::InteractionError;
pub use model::{Interaction, Laws};
pub use reaction::{Passage, compliant_reaction, reaction};
pub use shape::Shape;
