//! Grains in a fluid: what every backend does with them, whatever its mesh does.
//!
//! The same weights spread a grain's volume and reaction and sample what it feels, so that volume and momentum cross
//! between grains and fluid without loss.

mod compliance;
mod exchange;
mod on_mesh;
mod placing;
mod recovery;
mod suspension;

pub use compliance::{Compliance, CompliantCell, Given};
pub use exchange::{Exchange, NodalDrag, Reaction};
pub use on_mesh::{GrainsOnMesh, Medium, Taken};
pub use placing::{FREE_SURFACE, FixedMesh, FreeSurface, Placing, Spreading};
pub use recovery::{Felt, Rate, Recovered, Viscosity, gradient_changes, recover};
pub use suspension::Suspension;
