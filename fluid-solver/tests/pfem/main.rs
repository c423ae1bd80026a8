//! Claims about `pfem`.

mod backend;
mod flow;
mod space;
mod grains;
mod support;
