//! Where grains come from.

mod batch;
mod clumps;
mod file;
mod lattice;
mod occupancy;
mod overlap;
mod random;
mod random_fill;
mod rate;
mod region;
mod sieve;
mod sizes;

pub use batch::{Batch, coincident};
pub use clumps::{ClumpStart, Orientation};
pub use file::{FileGrain, read_grains};
pub use lattice::{Lattice, LatticeKind};
pub use occupancy::{Ball, Obstacle, Occupancy};
pub use overlap::{Overlap, Partner, overlaps};
pub use random::Random;
pub use random_fill::{Amount, RandomFill};
pub use rate::{Feed, Flow};
pub use region::{BoxRegion, CylinderRegion, Region, Space, SphereRegion, SurfaceRegion};
pub use sieve::read_sieve;
pub use sizes::{Class, Classes, Distribution, Lognormal, Normal, Sizes, Uniform};
