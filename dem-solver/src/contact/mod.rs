//! Contact of two bodies: the laws, and the force they give.

mod coefficients;
mod energy;
mod forces;
mod list;
pub mod normal;
mod pairs;
mod restitution;
pub mod tangential;
mod touch;
mod walls;

pub use coefficients::{Coefficients, Growth};
pub use energy::stored_energy;
pub use forces::{Load, forces};
pub use list::{CHUNK, Candidate, Chunk, ContactList, Incoming, Pair, Remembered, WallContact, chunk_count};
pub use normal::NormalLaw;
pub use pairs::COINCIDENT;
pub use restitution::{damping_ratio, restitution};
pub use tangential::Spring;
pub use touch::{Touch, touch_force};
pub use walls::Pressed;
