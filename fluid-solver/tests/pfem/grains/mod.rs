//! Grains in a cloud.

mod bed;
mod free_grains;
mod mobility;
mod momentum;
mod nodal;
mod plastic;
mod scene;
mod surface;
mod volume;
mod wave;
