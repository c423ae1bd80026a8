//! Bowyer & Watson's insertion, point by point, and repair of what was built.

mod cavity;
mod hull;
mod mesh;
mod order;
mod region;
mod repair;
mod ridges;
mod rim;
mod seed;
mod walk;

pub use cavity::Cavity;
pub use mesh::{Cell, Mark, Mesh};
pub use order::Order;
pub use repair::Repair;
