//! Claims about `pfem`.

mod flow;
mod space;
mod support;
