//! Grains in a cloud.

mod bed;
mod free_grains;
mod momentum;
mod nodal;
mod scene;
mod surface;
mod volume;
