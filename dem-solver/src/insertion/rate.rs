//! A region that is fed over time.

use super::batch::Batch;
use super::occupancy::{Ball, Occupancy};
use super::random::Random;
use super::region::{Region, Space};
use super::sizes::Distribution;
use crate::scene::Scene;
use crate::world::World;

/// Places tried for one grain before the region counts as full for this window.
const MOST_MISSES: u32 = 200;

/// How fast a region is fed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flow {
    /// Mass per time \[kg/s\].
    Mass(f64),
    /// Grains per time \[1/s\].
    Number(f64),
}

/// A region that is fed over time, only where there is room; what does not fit stays due.
#[derive(Clone, Debug, PartialEq)]
pub struct Feed<const D: usize> {
    /// What the grains share.
    pub batch: Batch<D>,
    /// Where.
    pub region: Region<D>,
    /// How fast.
    pub flow: Flow,
    /// From this time \[s\].
    pub start: f64,
    /// Until this time \[s\].
    pub stop: f64,
    /// Its random numbers.
    pub random: Random,
    /// Mass fed so far \[kg\], or number of grains: what `flow` counts.
    pub fed: f64,
    /// Grains fed so far.
    pub count: u64,
    /// How often a grain was due and found no room.
    pub refused: u64,
    /// Radius of the grain that is next \[m\], kept while it waits for room.
    pub waiting: Option<f64>,
}

impl<const D: usize> Feed<D> {
    /// Adds what is due at the world's time.
    pub fn feed(&mut self, scene: &Scene<D>, world: &mut World<D>) {
        let elapsed = world.time.min(self.stop) - self.start;
        let due = match self.flow {
            Flow::Mass(rate) | Flow::Number(rate) => rate * elapsed,
        };
        if due <= self.fed {
            return;
        }
        let (lower, upper) = self.region.bounds();
        let mut occupancy = Occupancy::new(scene, lower, upper, world, self.batch.sizes.largest());
        loop {
            let radius = self.waiting.take().unwrap_or_else(|| self.batch.sizes.draw(&mut self.random));
            let share = match self.flow {
                Flow::Mass(_) => self.batch.mass(scene, radius),
                Flow::Number(_) => 1.0,
            };
            self.waiting = Some(radius);
            // Half a grain early or late: the mean follows the rate.
            if self.fed + 0.5 * share > due {
                return;
            }
            let place = (0..MOST_MISSES).find_map(|_| {
                let centre = self.region.place(&scene.domain, radius, &mut self.random)?;
                let place = Ball { centre, radius };
                occupancy.take_if_free(place).ok().map(|()| place)
            });
            let Some(place) = place else {
                self.refused += 1;
                return;
            };
            self.waiting = None;
            self.fed += share;
            self.count += 1;
            self.batch.add(scene, world, &place, &mut self.random);
        }
    }
}
