//! Bowyer & Watson's insertion, point by point.

mod cavity;
mod mesh;
mod order;
mod ridges;
mod seed;
mod walk;

pub use cavity::Cavity;
pub use mesh::{GHOST, Mark, Mesh};
pub use order::Order;
