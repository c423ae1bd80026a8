//! Claims about `pfem`.

mod backend;
mod flow;
mod grains;
mod remesh;
mod space;
mod support;
