//! Claims about clumps in the full step.

mod bits;
mod collision;
mod flight;
mod impact;
mod planar;
mod removal;
mod rest;
mod scenes;
mod seams;
