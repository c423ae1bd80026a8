//! Impulses that the fluid gave and the grains have not yet received: carried from window to window, grain by grain.

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

    /// To each grain, in row order.
    pub fn impulses(&self) -> &[Vector] {
        &self.impulses
    }

    /// Follows a new order of rows: nothing is owed for the newborn, and what was owed for grains that are gone goes with
    /// them.
    pub fn follow(&mut self, grains: &[GrainRow]) {
        let mut order: Vec<(u64, usize)> = self.ids.iter().enumerate().map(|(row, id)| (*id, row)).collect();
        order.sort_unstable();
        let old_row =
            |id: u64| order.binary_search_by_key(&id, |(known, _)| *known).ok().map(|at| order[at].1);
        let rows: Vec<Option<usize>> = grains.iter().map(|grain| old_row(grain.id)).collect();
        self.impulses = rows.iter().map(|row| row.map_or([0.0; 3], |row| self.impulses[row])).collect();
        self.ids = grains.iter().map(|grain| grain.id).collect();
    }

    /// Owes more.
    pub fn add(&mut self, row: usize, impulse: Vector) {
        for k in 0..3 {
            self.impulses[row][k] += impulse[k];
        }
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
    fn debts_follow_their_grains_and_go_with_the_dead() {
        let mut owed = Owed::default();
        owed.follow(&[grain(0), grain(1), grain(2)]);
        (0..3).for_each(|row| owed.add(row, [row as f64 + 1.0, 0.0, 0.0]));
        assert_eq!(owed.sum(), [6.0, 0.0, 0.0]);
        owed.follow(&[grain(2), grain(7), grain(0)]);
        assert_eq!(owed.impulses(), [[3.0, 0.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0]]);
    }
}
