//! What grains of one insertion share.

use super::clumps::ClumpStart;
use super::occupancy::Ball;
use super::random::Random;
use super::sizes::Sizes;
use crate::contact::COINCIDENT;
use crate::domain::Domain;
use crate::engine::{Grid, Periods};
use crate::grains::{Grain, Grains, volume};
use crate::scene::Scene;
use crate::vector::{Spin, Vector};
use crate::world::World;

/// What grains of one insertion share.
#[derive(Clone, Debug, PartialEq)]
pub struct Batch<const D: usize> {
    /// Name in messages.
    pub name: String,
    /// Index of the material.
    pub material: u32,
    /// Radii; of clumps that of the sphere around each.
    pub sizes: Sizes,
    /// How clumps begin, if such are inserted in place of grains.
    pub clump: Option<ClumpStart>,
    /// Velocity \[m/s\].
    pub velocity: Vector<D>,
    /// Whether the grains are fixed in place.
    pub frozen: bool,
}

impl<const D: usize> Batch<D> {
    /// Adds a grain, or a clump, of this batch to the world.
    pub fn add(&self, scene: &Scene<D>, world: &mut World<D>, place: &Ball<D>, random: &mut Random) {
        match &self.clump {
            None => world.add(scene, &self.grain(place.centre, place.radius)),
            Some(start) => {
                let kind = &scene.clumps[start.kind as usize];
                world.add_clump(scene, start.kind, start.body(kind, &place.centre, &self.velocity, random));
            }
        }
    }

    /// Volume of a grain of this radius \[m\], or of a clump \[m³\].
    pub fn volume(&self, scene: &Scene<D>, radius: f64) -> f64 {
        self.clump.map_or_else(
            || volume::<D>(radius, scene.depth),
            |start| scene.clumps[start.kind as usize].volume,
        )
    }

    /// Mass of a grain of this radius \[m\], or of a clump \[kg\].
    pub fn mass(&self, scene: &Scene<D>, radius: f64) -> f64 {
        let density = scene.materials.get(self.material).density;
        let of_clump = |start: ClumpStart| scene.clumps[start.kind as usize].shape.mass();
        self.clump.map_or_else(|| density * volume::<D>(radius, scene.depth), of_clump)
    }

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
