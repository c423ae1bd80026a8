//! Births, removals and a new order: only between windows.

use crate::error::DemError;
use crate::scene::{Escape, Scene};
use crate::search::{order_expired, put_in_order};
use crate::vector::Vector;
use crate::world::World;

/// Grains that came or went.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossed<const D: usize> {
    /// How many.
    pub count: u64,
    /// Their mass \[kg\].
    pub mass: f64,
    /// Their momentum \[kg m/s\].
    pub momentum: Vector<D>,
}

impl<const D: usize> Crossed<D> {
    fn of(world: &World<D>, rows: impl Iterator<Item = usize>) -> Self {
        let grains = &world.grains;
        rows.fold(Self { count: 0, mass: 0.0, momentum: Vector::zeros() }, |sum, row| Self {
            count: sum.count + 1,
            mass: sum.mass + grains.mass[row],
            momentum: sum.momentum + grains.motion[row].velocity * grains.mass[row],
        })
    }
}

/// What changed between two windows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turnover<const D: usize> {
    /// Grains that were fed.
    pub born: Crossed<D>,
    /// Grains that had left the domain.
    pub removed: Crossed<D>,
    /// Whether row i is another grain than before.
    pub order_changed: bool,
}

/// Removes grains that left the domain, feeds what is due at the world's time, and sorts the rows when that pays.
///
/// # Errors
/// A grain that is neither here nor booked as removed.
pub fn turn_over<const D: usize>(scene: &Scene<D>, world: &mut World<D>) -> Result<Turnover<D>, DemError> {
    let stays = |row: &u32| {
        scene.escape == Escape::Stop || scene.domain.holds(&world.grains.place[*row as usize].centre)
    };
    let (staying, leaving): (Vec<u32>, Vec<u32>) = (0..world.grains.len() as u32).partition(stays);
    let removed = Crossed::of(world, leaving.iter().map(|&row| row as usize));
    if !leaving.is_empty() {
        world.reorder(&staying);
        world.removed += removed.count;
    }
    let before = world.grains.len();
    let mut feeds = std::mem::take(&mut world.feeds);
    for feed in &mut feeds {
        feed.feed(scene, world);
    }
    world.feeds = feeds;
    let born = Crossed::of(world, before..world.grains.len());
    let fading = order_expired(world);
    if fading {
        put_in_order(scene, world);
    }
    if world.grains.len() as u64 + world.removed != world.born {
        return Err(DemError::Lost { found: world.grains.len(), born: world.born, removed: world.removed });
    }
    Ok(Turnover { born, removed, order_changed: fading || born.count + removed.count > 0 })
}
