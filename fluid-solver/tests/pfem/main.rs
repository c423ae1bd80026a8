//! Claims about `pfem`.

mod flow;
mod grains;
mod space;
mod support;
