//! Fluid that enters and leaves.

mod jet;
mod pipe;
pub mod scene;
mod tank;
