//! Where grains come from.

mod batch;
mod file;
mod lattice;
mod occupancy;
mod random;
mod random_box;
mod rate;

pub use batch::{Batch, Sizes, coincident};
pub use file::{FileGrain, read_grains};
pub use lattice::{Lattice, LatticeKind};
pub use occupancy::Occupancy;
pub use random::Random;
pub use random_box::{Amount, RandomBox};
pub use rate::{Feed, Flow};
