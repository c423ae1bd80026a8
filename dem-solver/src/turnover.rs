//! Births, removals and a new order: only between windows.

use std::collections::HashSet;

use crate::deletion::Taken;
use crate::engine::{Periods, order_expired, put_in_order};
use crate::error::DemError;
use crate::scene::{Escape, Scene};
use crate::vector::{Spin, Vector, restrict};
use crate::world::World;

/// Grains that came or went.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossed<const D: usize> {
    /// How many, each member of a clump one.
    pub count: u64,
    /// Their mass \[kg\].
    pub mass: f64,
    /// Their momentum \[kg m/s\].
    pub momentum: Vector<D>,
}

impl<const D: usize> Crossed<D> {
    /// Of these rows, with the clumps of which a first member is among them.
    fn of(world: &World<D>, rows: impl Iterator<Item = usize>) -> Self {
        let mut sum = Self { count: 0, mass: 0.0, momentum: Vector::zeros() };
        for row in rows {
            sum.count += 1;
            if let Some((mass, velocity)) = counted(world, row) {
                sum.mass += mass;
                sum.momentum += restrict::<D>(&velocity) * mass;
            }
        }
        sum
    }
}

/// Mass \[kg\] and velocity \[m/s\] that a row counts with: those of its clump in the row of the first member, nothing in those
/// of the others.
fn counted<const D: usize>(world: &World<D>, row: usize) -> Option<(f64, Spin)> {
    let World { grains, bodies, .. } = world;
    match bodies.of(grains.id[row]) {
        None => Some((grains.mass[row], grains.motion[row].velocity)),
        Some((clump, 0)) => Some((grains.mass[row], bodies.as_slice()[clump].body.velocity)),
        Some(_) => None,
    }
}

/// What changed between two windows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turnover<const D: usize> {
    /// Grains that were fed.
    pub born: Crossed<D>,
    /// Grains that had left the domain or that a deletion took.
    pub removed: Crossed<D>,
    /// Whether row i is another grain than before.
    pub order_changed: bool,
}

/// Removes grains that left the domain and those in deletions, feeds what is due at the world's time, and sorts the rows
/// when that pays.
///
/// # Errors
/// A grain that is neither here nor booked as removed.
pub fn turn_over<const D: usize>(scene: &Scene<D>, world: &mut World<D>) -> Result<Turnover<D>, DemError> {
    wrap(scene, world);
    let removed = remove(scene, world);
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

/// Brings all centres back into the domain along its periodic axes.
fn wrap<const D: usize>(scene: &Scene<D>, world: &mut World<D>) {
    if !scene.domain.periodic.contains(&true) {
        return;
    }
    let periods = Periods::new(&scene.domain);
    for place in &mut world.grains.place {
        let before = place.centre;
        periods.wrap(&mut place.centre);
        if place.centre != before {
            // Walls are known by the image that is near them.
            world.contacts.spent.walls = f64::INFINITY;
        }
    }
    world.bodies.as_mut_slice().iter_mut().for_each(|clump| periods.wrap(&mut clump.body.centre));
}

/// Removes the grains and clumps that go, and books each with the deletion that took it, or with those that left the
/// domain. A clump goes whole, when its centre of mass goes.
fn remove<const D: usize>(scene: &Scene<D>, world: &mut World<D>) -> Crossed<D> {
    let taker = |centre: &Vector<D>| {
        let escaped = || {
            (scene.escape == Escape::Remove && !scene.domain.holds(centre)).then_some(scene.deletions.len())
        };
        scene.deletions.iter().position(|deletion| deletion.takes(centre)).or_else(escaped)
    };
    let (mut staying, mut leaving) = (Vec::new(), Vec::new());
    for row in 0..world.grains.len() {
        let clump = world.bodies.of(world.grains.id[row]);
        let centre =
            clump.map_or(world.grains.place[row].centre, |(k, _)| world.bodies.as_slice()[k].body.centre);
        match taker(&restrict(&centre)) {
            None => staying.push(row as u32),
            Some(taker) => leaving.push((row, taker)),
        }
    }
    let removed = Crossed::of(world, leaving.iter().map(|&(row, _)| row));
    if leaving.is_empty() {
        return removed;
    }
    world.taken.resize(scene.deletions.len() + 1, Taken::default());
    for &(row, taker) in &leaving {
        if let Some((mass, _)) = counted(world, row) {
            world.taken[taker].count += 1;
            world.taken[taker].mass += mass;
        }
    }
    let gone: HashSet<u64> = leaving.iter().map(|&(row, _)| world.grains.id[row]).collect();
    world.bonds.sweep(|grain| !gone.contains(&grain));
    world.bodies.retain(|clump| !gone.contains(&clump.first));
    world.reorder(&staying);
    world.removed += removed.count;
    removed
}
