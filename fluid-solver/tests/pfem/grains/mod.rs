//! Grains in a cloud.

mod bed;
mod momentum;
mod scene;
mod surface;
mod volume;
