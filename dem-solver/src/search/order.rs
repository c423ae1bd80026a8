//! Rows in the order of cells, so that neighbours are near in memory.

use super::cells::Cells;
use crate::scene::Scene;
use crate::world::World;

/// Lists built before the order has faded.
const LISTS_PER_ORDER: u32 = 20;

/// Whether grains have moved so far that a new order pays.
pub fn order_expired<const D: usize>(world: &World<D>) -> bool {
    world.contacts.built_since_order >= LISTS_PER_ORDER
}

/// Sorts the rows by cell; only between windows, since row i is one grain throughout a window.
pub fn put_in_order<const D: usize>(scene: &Scene<D>, world: &mut World<D>) {
    let largest = world.grains.place.iter().map(|place| place.radius).fold(0.0, f64::max);
    let cells = Cells::new(&world.grains.place, &scene.domain, 2.0 * largest);
    world.reorder(cells.rows());
    world.contacts.built_since_order = 0;
}
