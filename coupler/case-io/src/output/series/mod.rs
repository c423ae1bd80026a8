//! Time series as CSV: the first row names the columns as `name[unit]`, then one row per output time.
//!
//! The first column is time. Numbers are written with the fewest digits that read back to the same bits.

mod column;
mod reader;
mod writer;

pub use column::{Column, Title};
pub use reader::Series;
pub use writer::{SeriesWriter, cut_after};
