//! Claims about `pfem`.

mod backend;
mod flow;
mod grains;
mod support;
