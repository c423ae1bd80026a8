//! Claims about `pfem`.
#![allow(clippy::print_stdout, reason = "what is measured are figures of the documentation")]

mod backend;
mod flow;
mod gates;
mod grains;
mod remesh;
mod space;
mod support;
