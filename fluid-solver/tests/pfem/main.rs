//! Claims about `pfem`.

mod flow;
mod grains;
mod support;
