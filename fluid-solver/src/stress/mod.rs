//! `fluid-solver stress`: a map of what a backend gets right, what it only survives, and what it refuses clearly.

mod command;
mod fixed;
mod outcome;
mod plane;
mod runner;
mod scene;
mod space;
mod trial;

pub use command::{Arguments, run};
