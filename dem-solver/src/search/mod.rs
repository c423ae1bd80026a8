//! Who is near whom: a cell grid, and the neighbour list found with it.

mod cells;
mod neighbours;
mod order;

pub use cells::Cells;
pub use neighbours::{build_list, candidate, complete, incoming, list_expired};
pub use order::{order_expired, put_in_order};
