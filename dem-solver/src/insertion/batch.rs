//! What grains of one insertion share.

use super::sizes::Sizes;
use crate::contact::COINCIDENT;
use crate::domain::Domain;
use crate::engine::{Grid, Periods};
use crate::grains::{Grain, Grains};
use crate::vector::{Spin, Vector};

/// What grains of one insertion share.
#[derive(Clone, Debug, PartialEq)]
pub struct Batch<const D: usize> {
    /// Name in messages.
    pub name: String,
    /// Index of the material.
    pub material: u32,
    /// Radii.
    pub sizes: Sizes,
    /// Velocity \[m/s\].
    pub velocity: Vector<D>,
    /// Whether the grains are fixed in place.
    pub frozen: bool,
}

impl<const D: usize> Batch<D> {
    /// A grain of this batch.
    pub fn grain(&self, centre: Vector<D>, radius: f64) -> Grain<D> {
        Grain {
            centre,
            radius,
            velocity: self.velocity,
            angular_velocity: Spin::zeros(),
            material: self.material,
            frozen: self.frozen,
        }
    }
}

/// Two rows whose centres coincide, if there are any.
pub fn coincident<const D: usize>(grains: &Grains, domain: &Domain<D>) -> Option<(usize, usize)> {
    let periods = Periods::new(domain);
    let largest = grains.largest_radius();
    let grid = Grid::of_all(grains, &periods, 2.0 * largest);
    (0..grains.len()).find_map(|i| {
        let (a, mut found) = (&grains.place[i], None);
        grid.visit_around(a, a.radius + largest, |j| {
            let b = &grains.place[j];
            let sum = a.radius + b.radius;
            if j > i && sum - periods.overlap(a, b) <= COINCIDENT * sum {
                found = Some((i, j));
            }
        });
        found
    })
}
