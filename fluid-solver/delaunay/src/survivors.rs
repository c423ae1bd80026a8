//! Which points were there before.

use crate::HULL;

/// A mesh is not reused if more than one in so many points is new or gone.
const FEW: usize = 16;

/// Points of two calls that have the same rank.
#[derive(Default)]
pub struct Survivors {
    /// For each point of the last call its index in this one, or [`HULL`].
    pub now: Vec<u32>,
    /// Points that are new.
    pub new: Vec<u32>,
}

impl Survivors {
    /// Compares ranks; whether they rise strictly in both calls and few points are new or gone.
    pub fn find(&mut self, before: &[u32], rank: &[u32]) -> bool {
        let rises = |ranks: &[u32]| ranks.is_sorted_by(|a, b| a < b);
        if !rises(before) || !rises(rank) {
            return false;
        }
        self.now.clear();
        self.new.clear();
        let mut next = 0;
        for old in before {
            while rank.get(next).is_some_and(|rank| rank < old) {
                self.new.push(next as u32);
                next += 1;
            }
            let stays = rank.get(next) == Some(old);
            self.now.push(if stays { next as u32 } else { HULL });
            next += usize::from(stays);
        }
        self.new.extend(next as u32..rank.len() as u32);
        let gone = before.len() + self.new.len() - rank.len();
        FEW * (gone + self.new.len()) <= rank.len()
    }
}
