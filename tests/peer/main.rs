//! This program held against others.
//!
//! The live comparisons need LIGGGHTS 3.8.0, YADE 2023.02a and LAMMPS of 22 July 2025. They are marked as ignored, which
//! `cargo test` shows; `.ci/run` installs the programs and runs them, and without the programs they fail.

mod live;
mod refusals;
mod scene;
#[path = "../support/mod.rs"]
mod support;
