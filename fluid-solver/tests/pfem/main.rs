//! Claims about `pfem`.

mod backend;
mod flow;
mod gates;
mod grains;
mod remesh;
mod space;
mod support;
