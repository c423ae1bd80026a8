//! What grains of one insertion share.

use super::random::Random;
use crate::contact::COINCIDENT;
use crate::domain::Domain;
use crate::grains::{Grain, Place};
use crate::search::Cells;
use crate::vector::{Spin, Vector};

/// Diameters of an insertion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Smallest radius \[m\].
    pub smallest: f64,
    /// Largest radius \[m\].
    pub largest: f64,
}

impl Sizes {
    /// All of one radius \[m\].
    pub fn all(radius: f64) -> Self {
        Self { smallest: radius, largest: radius }
    }

    /// The next radius: uniform between the smallest and the largest.
    pub fn draw(&self, random: &mut Random) -> f64 {
        if self.smallest == self.largest {
            self.smallest
        } else {
            random.between(self.smallest, self.largest)
        }
    }
}

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
pub fn coincident<const D: usize>(places: &[Place<D>], domain: &Domain<D>) -> Option<(usize, usize)> {
    let largest = places.iter().map(|place| place.radius).fold(0.0, f64::max);
    let shifts = domain.shifts();
    let cells = Cells::new(places, domain, 2.0 * largest);
    (0..places.len()).find_map(|i| {
        let (a, mut found) = (&places[i], None);
        cells.visit_around(&a.centre, |j, image| {
            let b = &places[j as usize];
            let distance = (b.centre + shifts[image.0 as usize] - a.centre).norm();
            if j as usize > i && distance <= COINCIDENT * (a.radius + b.radius) {
                found = Some((i, j as usize));
            }
        });
        found
    })
}
