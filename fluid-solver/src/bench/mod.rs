//! `fluid-solver bench`: error against processor time, over meshes and steps, for every backend that computes the scene.

mod command;
mod error;
mod measure;
mod scene;
mod standing_wave;
mod table;
mod taylor_green;

pub use command::{Arguments, run};
