//! Rigid bodies made of grains: clumps.
//!
//! A [`Clump`] is the shape: where its members lie, and how it resists. A [`Body`] is one clump in motion. In two
//! dimensions members lie in the plane z = 0 and spins along z; the equations are the same.

mod clump;
mod error;
mod mass;
mod motion;
mod union;

pub use clump::{Clump, Member};
pub use error::BodyError;
pub use mass::MassProperties;
pub use motion::{Body, Carried, Load};
