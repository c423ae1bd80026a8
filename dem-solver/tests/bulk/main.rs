//! What many contacts are together, as claims about packings whose forces are known.

mod at_rest;
mod frames;
mod lattices;
