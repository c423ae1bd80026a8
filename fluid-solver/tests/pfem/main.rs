//! Claims about `pfem`.

mod flow;
mod support;
