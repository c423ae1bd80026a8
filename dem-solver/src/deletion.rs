//! Regions where grains are taken out, and what they took.

use crate::insertion::{Region, Space};
use crate::vector::Vector;
use crate::wall::{Piece, Plane};

/// Where grains are taken out.
#[derive(Clone, Debug, PartialEq)]
pub enum Where<const D: usize> {
    /// In a region.
    Within(Region<D>),
    /// Behind a plane.
    Beyond(Plane<D>),
}

/// A region where grains are taken out, between windows.
#[derive(Clone, Debug, PartialEq)]
pub struct Deletion<const D: usize> {
    /// Name in messages and in the series.
    pub name: String,
    /// Where.
    pub place: Where<D>,
}

impl<const D: usize> Deletion<D> {
    /// Whether it takes a grain with this centre.
    pub fn takes(&self, centre: &Vector<D>) -> bool {
        match &self.place {
            Where::Within(region) => region.holds(centre),
            Where::Beyond(plane) => plane.nearest(centre).distance < 0.0,
        }
    }
}

/// What was taken out so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Taken {
    /// How many grains and clumps.
    pub count: u64,
    /// Their mass \[kg\].
    pub mass: f64,
}
