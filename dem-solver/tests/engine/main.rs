//! The contact engine: what it computes, and that it computes the same bits everywhere.

mod bits;
mod limits;
mod reference;
mod scenes;
