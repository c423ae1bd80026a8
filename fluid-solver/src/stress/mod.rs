//! `fluid-solver stress`: a map of what a backend gets right, what it only survives, and what it refuses clearly.

mod command;
mod outcome;
mod runner;
mod trials;

pub use command::{Arguments, run};
