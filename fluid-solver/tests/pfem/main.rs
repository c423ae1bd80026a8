//! Claims about `pfem`.

mod flow;
mod grains;
mod remesh;
mod space;
mod support;
