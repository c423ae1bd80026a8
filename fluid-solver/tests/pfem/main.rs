//! Claims about `pfem`.

mod flow;
mod grains;
mod remesh;
mod support;
