//! Fluid: meshes, stabilised finite elements, void fraction, sampling and deposition; knows no contact.

pub mod backend;
mod bench;
pub mod boundary;
mod command;
mod couple;
pub mod deposit;
pub mod element;
mod error;
mod gauge;
pub mod grains;
pub mod mesh;
mod parallel;
pub mod program;
mod record;
pub mod sample;
mod stress;
pub mod void_fraction;
pub mod weak_form;

pub use couple::FluidParticipant;
pub use error::FluidError;
pub use gauge::Gauge;
pub use record::Record;
