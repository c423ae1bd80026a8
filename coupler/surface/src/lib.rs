//! Rigid surfaces as a case states them: triangles from files, prescribed motion; what the walls of grains and of fluids
//! share.

pub mod case;
pub mod csv;
mod error;
mod facet;
mod flaw;
pub mod motion;
pub mod triangles;
pub mod vector;

pub use error::InputError;
pub use facet::Facet;
pub use flaw::Flaw;
