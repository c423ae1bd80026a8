//! Events: surfaces merge, voids fill, necks break, drops leave and come back.

mod absorption;
mod closing;
mod droplets;
mod landing;
mod separation;
mod voids;

pub use absorption::absorb_drops;
pub use closing::close_gaps;
pub use droplets::release_droplets;
pub use landing::land_on_walls;
pub use separation::break_thin_cells;
pub use voids::fill_small_voids;

/// What happened in a remeshing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Events {
    /// Triangles of void between approaching surfaces that became fluid.
    pub closed: u32,
    /// Voids that were filled.
    pub filled: u32,
    /// Nodes that landed on a wet wall.
    pub landed: u32,
    /// Surfaces crossed.
    pub crossed: bool,
    /// Thin cells broken off.
    pub broken: u32,
    /// Drops that left.
    pub released: u32,
    /// Drops taken up.
    pub absorbed: u32,
}

impl Events {
    /// These and others.
    pub fn and(self, other: Self) -> Self {
        Self {
            closed: self.closed + other.closed,
            filled: self.filled + other.filled,
            landed: self.landed + other.landed,
            crossed: self.crossed || other.crossed,
            broken: self.broken + other.broken,
            released: self.released + other.released,
            absorbed: self.absorbed + other.absorbed,
        }
    }

    /// Whether nothing happened.
    pub fn none(&self) -> bool {
        *self == Self::default()
    }
}
