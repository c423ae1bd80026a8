//! What the grains must do, as claims about mechanics.

mod adhesion;
mod cohesion;
mod conservation;
mod determinism;
mod drag;
mod flight;
mod friction;
mod impact;
mod inserting;
mod liggghts;
mod liggghts_extras;
mod limits;
mod lubrication;
mod micro;
mod moving_walls;
mod rest;
mod restitution;
mod rolling;
mod round_walls;
mod scenes;
mod seams;
mod servo;
mod setting_up;
mod twisting;
mod walls;
