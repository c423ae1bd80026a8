//! What the grains must do, as claims about mechanics.

mod conservation;
mod determinism;
mod drag;
mod flight;
mod friction;
mod impact;
mod inserting;
mod limits;
mod rest;
mod scenes;
mod setting_up;
mod walls;
