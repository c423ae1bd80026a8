//! Random places without overlap in a region.

use super::batch::Batch;
use super::occupancy::{Ball, Obstacle, Occupancy};
use super::random::Random;
use super::region::{Region, Space};
use super::sizes::Distribution;
use crate::error::DemError;
use crate::scene::Scene;
use crate::world::World;

/// A region is full when so many places in a row were taken.
const MOST_MISSES: u32 = 100_000;

/// How much a region holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// So many grains.
    Count(usize),
    /// Grains that fill this fraction of the region.
    SolidFraction(f64),
}

/// Random sequential addition: each grain at a uniformly random place that is still free, the largest first (Feder,
/// J. Theor. Biol. 87 (1980) 237–254; equal grains are full at a solid fraction of about 0.38 in 3D and 0.55 in 2D).
#[derive(Clone, Debug, PartialEq)]
pub struct RandomFill<const D: usize> {
    /// Where.
    pub region: Region<D>,
    /// How much.
    pub amount: Amount,
}

/// Why places in a row were not free.
#[derive(Clone, Copy, Debug, Default)]
struct Misses {
    grains: u32,
    walls: u32,
    narrow: bool,
}

impl<const D: usize> RandomFill<D> {
    /// Adds the grains, or clumps, to the world, none overlapping another or a wall.
    ///
    /// # Errors
    /// [`DemError::NoRoom`] with the number that fitted and what was in the way of the next.
    pub fn insert(
        &self,
        scene: &Scene<D>,
        world: &mut World<D>,
        batch: &Batch<D>,
        random: &mut Random,
    ) -> Result<(), DemError> {
        let radii = self.radii(scene, batch, random);
        let (lower, upper) = self.region.bounds();
        let mut occupancy = Occupancy::new(scene, lower, upper, world, batch.sizes.largest());
        let mut filled = 0.0;
        for (fitted, &radius) in radii.iter().enumerate() {
            match self.find(scene, &mut occupancy, radius, random) {
                Ok(place) => batch.add(scene, world, &place, random),
                Err(misses) => {
                    let insertion = batch.name.clone();
                    let why = misses.tell(radius, filled / self.space(scene));
                    return Err(DemError::NoRoom { insertion, fitted, wanted: radii.len(), why });
                }
            }
            filled += batch.volume(scene, radius);
        }
        Ok(())
    }

    fn find(
        &self,
        scene: &Scene<D>,
        occupancy: &mut Occupancy<D>,
        radius: f64,
        random: &mut Random,
    ) -> Result<Ball<D>, Misses> {
        let mut misses = Misses::default();
        for _ in 0..MOST_MISSES {
            let Some(centre) = self.region.place(&scene.domain, radius, random) else {
                return Err(Misses { narrow: true, ..misses });
            };
            let place = Ball { centre, radius };
            match occupancy.take_if_free(place) {
                Ok(()) => return Ok(place),
                Err(Obstacle::Grain) => misses.grains += 1,
                Err(Obstacle::Wall) => misses.walls += 1,
            }
        }
        Err(misses)
    }

    /// Volume of the region \[m³\].
    fn space(&self, scene: &Scene<D>) -> f64 {
        let depth = if D == 2 { scene.depth } else { 1.0 };
        self.region.volume() * depth
    }

    /// The grains' radii, the largest first: small ones still fit between large ones.
    fn radii(&self, scene: &Scene<D>, batch: &Batch<D>, random: &mut Random) -> Vec<f64> {
        let mut radii = match self.amount {
            Amount::Count(count) => (0..count).map(|_| batch.sizes.draw(random)).collect(),
            Amount::SolidFraction(fraction) => {
                let mut left = fraction * self.space(scene);
                let mut radii = Vec::new();
                loop {
                    // The grain that overshoots is taken if that comes nearer to the fraction.
                    let radius = batch.sizes.draw(random);
                    let volume = batch.volume(scene, radius);
                    if left < 0.5 * volume {
                        break;
                    }
                    left -= volume;
                    radii.push(radius);
                }
                radii
            }
        };
        radii.sort_by(|a, b| b.total_cmp(a));
        radii
    }
}

impl Misses {
    fn tell(&self, radius: f64, filled: f64) -> String {
        let next = format!("the next, of diameter {:.4} m", 2.0 * radius);
        if self.narrow {
            return format!("{next}, is wider than the region");
        }
        let full = format!("the region is {filled:.3} full");
        let Self { grains, walls, .. } = self;
        format!(
            "{next}, met a grain at {grains} and a wall at {walls} of {MOST_MISSES} random places, {full}"
        )
    }
}
