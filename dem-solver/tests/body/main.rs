//! What clumps must do, as claims about mechanics.

mod bad_input;
mod free_rotation;
mod loads;
mod mass;
mod planar;
mod shapes;
