//! Grains by class of size, each class in a grid of its own.

use super::grid::Grid;
use super::periods::Periods;
use crate::grains::Grains;

/// No more classes than this; the last one holds all that are smaller.
const MOST: usize = 8;

/// Grids of grains that differ by no more than two to one, so that a cell holds few grains, however wide the sizes
/// range.
#[derive(Clone, Debug)]
pub struct Levels(Vec<Level>);

/// One class.
#[derive(Clone, Debug)]
pub struct Level {
    /// Largest radius \[m\].
    pub largest: f64,
    /// Its grains.
    pub grid: Grid,
}

impl Levels {
    /// All grains, in cells as wide as two of a class and the skin \[m\].
    pub fn new(grains: &Grains, periods: &Periods, skin: f64) -> Self {
        let mut classes: [Vec<u32>; MOST] = Default::default();
        let largest = grains.largest_radius();
        for (row, place) in grains.place.iter().enumerate() {
            let halvings = (largest / place.radius).log2() as usize;
            classes[halvings.min(MOST - 1)].push(row as u32);
        }
        let level = |rows: Vec<u32>| {
            let radii = rows.iter().map(|&row| grains.place[row as usize].radius);
            let largest = radii.fold(0.0, f64::max);
            Level { largest, grid: Grid::new(grains, &rows, periods, 2.0 * largest + skin) }
        };
        Self(classes.into_iter().filter(|rows| !rows.is_empty()).map(level).collect())
    }

    /// The classes, the largest grains first.
    pub fn iter(&self) -> impl Iterator<Item = &Level> {
        self.0.iter()
    }
}
