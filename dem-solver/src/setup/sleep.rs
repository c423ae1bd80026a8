//! When idle grains of a case sleep.

use case_io::document;

use crate::insertion::Distribution;
use crate::scene::Scene;
use crate::sleep::SleepBound;
use crate::world::World;

/// Default speed over √(g d), d the diameter of the smallest grain.
const SPEED: f64 = 1e-4;
/// Default acceleration over g.
const ACCELERATION: f64 = 1e-3;

/// The bound as stated, what is not stated from gravity and the smallest grain of the start and of the feeds.
pub fn bound<const D: usize>(stated: &document::Sleep, scene: &Scene<D>, world: &World<D>) -> SleepBound {
    let gravity = scene.gravity.norm();
    let fed = world.feeds.iter().map(|feed| feed.batch.sizes.smallest());
    let smallest =
        world.grains.place.iter().map(|place| place.radius).chain(fed).fold(f64::INFINITY, f64::min);
    SleepBound {
        speed: stated.speed.map_or(SPEED * (2.0 * gravity * smallest).sqrt(), |speed| speed.si()),
        acceleration: stated.acceleration.map_or(ACCELERATION * gravity, |acceleration| acceleration.si()),
    }
}
