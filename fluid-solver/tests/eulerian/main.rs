//! Claims about the Eulerian backend.

mod bits;
mod coupling;
mod exact_flows;
mod hydrostatics;
mod inlets;
mod manufactured;
mod resistant_bed;
mod support;
mod taylor_green;
