//! What the grains must do, as claims about mechanics.

mod conservation;
mod determinism;
mod drag;
mod flight;
mod friction;
mod impact;
mod inserting;
mod liggghts;
mod limits;
mod moving_walls;
mod rest;
mod restitution;
mod scenes;
mod setting_up;
mod walls;
