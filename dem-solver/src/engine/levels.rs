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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::grains::Grain;
    use crate::insertion::Random;

    const SIDE: f64 = 0.05;
    const SKIN: f64 = 1e-4;

    /// Grains at random in a box, of these radii \[m\] with a fifth of its volume shared evenly among them.
    fn cloud(radii: &[f64]) -> Grains {
        let (mut random, mut grains) = (Random::new(2), Grains::new());
        for &radius in radii {
            let count = 0.2 / radii.len() as f64 * SIDE.powi(3) / crate::grains::volume::<3>(radius, 1.0);
            for _ in 0..count.ceil() as usize {
                let at = [(); 3].map(|()| random.between(0.0, SIDE));
                grains.push(grains.len() as u64, &Grain::<3>::at(at, radius), 1.0, false);
            }
        }
        grains
    }

    /// Grains that each grain is held against, and how many of them are near.
    fn tested(grains: &Grains, periods: &Periods) -> (f64, Vec<usize>) {
        let levels = Levels::new(grains, periods, SKIN);
        let (mut tested, mut runs, mut near) = (0, vec![], vec![]);
        for place in &grains.place {
            let mut of_place = 0;
            for Level { largest, grid } in levels.iter() {
                grid.around(place, place.radius + largest + SKIN, &mut runs);
                for row in runs.iter().flat_map(|&(begin, end)| &grid.order[begin as usize..end as usize]) {
                    tested += 1;
                    of_place += usize::from(periods.overlap(place, &grains.place[*row as usize]) > -SKIN);
                }
            }
            near.push(of_place);
        }
        (tested as f64 / grains.len() as f64, near)
    }

    #[test]
    fn a_range_of_one_to_twenty_in_size_is_found_whole_and_at_the_cost_of_one_size() {
        let domain = Domain::<3>::new([0.0; 3], [SIDE; 3]).periodic([true, true, false]);
        let periods = Periods::new(&domain);
        let mixed = cloud(&[8e-3, 4e-3, 2e-3, 1e-3, 0.4e-3]);
        let (cost, near) = tested(&mixed, &periods);
        // Each pair of two, by brute force; of the small ones every tenth.
        for k in (0..mixed.len()).filter(|k| mixed.place[*k].radius > 1e-3 || k % 10 == 0) {
            let near_k = |other: &&crate::grains::Place| periods.overlap(&mixed.place[k], other) > -SKIN;
            assert_eq!(mixed.place.iter().filter(near_k).count(), near[k], "grain {k}");
        }
        let (of_one_size, _) = tested(&cloud(&[1e-3]), &periods);
        assert!(cost < 3.0 * of_one_size, "{cost} pairs tested per grain, {of_one_size} of one size");
    }
}
