//! Contact of two bodies: the laws, and the force they give.

mod coefficients;
pub mod cohesion;
mod energy;
mod extras;
mod history;
pub mod lubrication;
pub mod normal;
mod remembered;
mod restitution;
pub mod rolling;
pub mod tangential;
mod touch;
pub mod twisting;
mod walls;

/// Centres nearer than this fraction of the sum of radii have no direction that a force could take.
pub const COINCIDENT: f64 = 1e-9;

/// Where two centres are nearer than this share of the larger radius, one lies inside the other body and the contact has
/// broken down: a contact is as deep as the smaller radius at most, up to round-off.
pub const NEAREST: f64 = 1.0 - 1e-9;

pub use coefficients::{Coefficients, Growth};
pub use energy::stored_energy;
pub use extras::{ExtraConstants, Extras};
pub use history::History;
pub use normal::NormalLaw;
pub use remembered::Remembered;
pub use restitution::{damping_ratio, restitution};
pub use tangential::{Annuli, Spring};
pub use touch::{Response, Touch, touch_force};
pub use walls::{Pressed, pressed_surfaces, surfaces_within, wall_forces};
