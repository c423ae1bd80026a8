//! The case document with units and spans, the plan, exit codes, and everything a run leaves on disk.

mod nearest;
mod tree;

pub mod check;
pub mod checkpoint;
pub mod document;
pub mod error;
pub mod exit_code;
pub mod expression;
pub mod output;
pub mod plan;
pub mod summary;
