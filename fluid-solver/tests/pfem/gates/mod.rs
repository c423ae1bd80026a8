//! Fluid that enters and leaves.

mod jet;
mod pipe;
mod scene;
mod tank;
