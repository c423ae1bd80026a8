//! What bonds must do, as claims about mechanics.

mod assembly;
mod bad_input;
mod breaking;
mod cantilever;
mod conservation;
mod formulas;
mod in_the_step;
mod rigid_motion;
mod setting_up;
mod stable_step;
mod surroundings;
