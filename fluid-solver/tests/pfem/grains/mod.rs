//! Grains in a cloud.

mod bed;
mod free_grains;
mod momentum;
mod scene;
mod surface;
mod volume;
