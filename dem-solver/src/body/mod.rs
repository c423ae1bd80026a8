//! Rigid bodies made of grains: clumps.
//!
//! A [`Clump`] is the shape: where its members lie, and how it resists. A [`Body`] is one clump in motion, a [`Rigid`] one
//! whose members are grains. In two dimensions members lie in the plane z = 0 and spins along z; the equations are the
//! same.

mod archive;
mod bodies;
mod clump;
mod error;
mod mass;
mod mobility;
mod motion;
mod union;

pub use archive::BodyArrays;
pub use bodies::{Bodies, ClumpKind, Rigid};
pub use clump::{Clump, Member};
pub use error::BodyError;
pub use mass::MassProperties;
pub use mobility::Mobility;
pub use motion::{Body, Carried, Load};
