//! `dem-solver bench`: how fast grains are computed, here and by other programs from the same states.

mod command;
mod drum;
mod error;
mod instructions;
mod memory;
mod scenes;
mod settled;
mod speed;
mod table;
mod traffic;

pub use command::{Arguments, run};
