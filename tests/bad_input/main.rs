//! Bad input: whatever is wrong with a case, its files, the command line, the machine or the run itself, the user gets
//! one line that says what, where, what is allowed and what to do, the documented exit code, and nothing is left.

#[path = "../support/mod.rs"]
mod support;

mod command_line;
mod ending;
mod environment;
mod faults;
mod files;
mod grains;
mod keys;
mod mesh_text;
mod moving_nodes;
mod refusal;
mod restart_point;
mod scene;
mod surfaces;
