//! Impulses that the fluid gave and the grain has not yet received: carried from window to window.

use interface::frames::GrainRow;
use interface::ledger::Vector;

/// What is owed to each grain \[N s\].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Owed {
    ids: Vec<u64>,
    impulses: Vec<Vector>,
}

impl Owed {
    /// From a restart point.
    pub fn new(ids: Vec<u64>, impulses: Vec<Vector>) -> Owed {
        Owed { ids, impulses }
    }

    /// Identities in row order.
    pub fn ids(&self) -> &[u64] {
        &self.ids
    }

    /// Impulses in row order.
    pub fn impulses(&self) -> &[Vector] {
        &self.impulses
    }

    /// Follows a new order of rows: nothing is owed for the newborn; what was owed for grains that are gone is
    /// returned, for the books.
    pub fn follow(&mut self, grains: &[GrainRow]) -> Vector {
        let mut order: Vec<(u64, Vector)> = self.ids.iter().copied().zip(self.impulses.iter().copied()).collect();
        order.sort_unstable_by_key(|(id, _)| *id);
        let mut lost = self.sum();
        self.ids = grains.iter().map(|grain| grain.id).collect();
        self.impulses = grains
            .iter()
            .map(|grain| order.binary_search_by_key(&grain.id, |(id, _)| *id).map_or([0.0; 3], |at| order[at].1))
            .collect();
        let kept = self.sum();
        (0..3).for_each(|k| lost[k] -= kept[k]);
        lost
    }

    /// What is owed to the grain of a row.
    pub fn of(&self, row: usize) -> Vector {
        self.impulses[row]
    }

    /// Owes more.
    pub fn add(&mut self, row: usize, impulse: Vector) {
        (0..3).for_each(|k| self.impulses[row][k] += impulse[k]);
    }

    /// Sum over all grains.
    pub fn sum(&self) -> Vector {
        self.impulses.iter().fold([0.0; 3], |sum, impulse| std::array::from_fn(|k| sum[k] + impulse[k]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grain(id: u64) -> GrainRow {
        GrainRow { id, ..Default::default() }
    }

    #[test]
    fn debts_follow_their_grains_and_those_of_the_dead_are_told() {
        let mut owed = Owed::default();
        assert_eq!(owed.follow(&[grain(0), grain(1), grain(2)]), [0.0; 3]);
        (0..3).for_each(|row| owed.add(row, [row as f64 + 1.0, 0.0, 0.0]));
        assert_eq!(owed.follow(&[grain(2), grain(7), grain(0)]), [2.0, 0.0, 0.0]);
        assert_eq!(owed.impulses(), [[3.0, 0.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0]]);
    }
}
