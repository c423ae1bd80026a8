//! Claims about `pfem`.

mod flow;
mod space;
mod grains;
mod support;
