//! Claims about `pfem`.

mod backend;
mod flow;
mod grains;
mod space;
mod support;
