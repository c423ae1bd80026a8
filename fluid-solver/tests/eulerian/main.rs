//! Claims about the Eulerian backend.

mod exact_flows;
mod hydrostatics;
mod support;
