//! Weights of grains on nodes, void fraction, sampling and deposition.

mod accuracy;
mod conservation;
mod continuity;
mod determinism;
mod scene;
