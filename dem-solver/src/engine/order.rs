//! Rows in the order of cells, so that neighbours are near in memory.

use super::grid::Grid;
use super::periods::Periods;
use crate::scene::Scene;
use crate::world::World;

/// Outer lists before the order has faded.
pub const LISTS_PER_ORDER: u32 = 20;

/// Whether grains have moved so far that a new order pays.
pub fn order_expired<const D: usize>(world: &World<D>) -> bool {
    world.contacts.built_since_order >= LISTS_PER_ORDER
}

/// Sorts the rows by cell; only between windows, since row i is one grain throughout a window.
pub fn put_in_order<const D: usize>(scene: &Scene<D>, world: &mut World<D>) {
    let grid = Grid::of_all(&world.grains, &Periods::new(&scene.domain), world.grains.mean_diameter());
    world.reorder(&grid.order);
    world.contacts.built_since_order = 0;
}
