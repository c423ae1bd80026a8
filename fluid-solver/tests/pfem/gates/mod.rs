//! Fluid that enters and leaves.

mod channel;
mod jet;
mod scene;
mod tank;
