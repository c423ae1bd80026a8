//! This program held against others.
//!
//! The live comparisons need LIGGGHTS 3.8.0 and YADE 2023.02a. They are marked as ignored, which `cargo test` shows;
//! `.ci/run` installs both programs and runs them, and without the programs they fail.

mod live;
mod refusals;
mod scene;
#[path = "../support/mod.rs"]
mod support;
