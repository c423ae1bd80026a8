//! Orientations of few points, each found once.

use crate::predicate::orientation;

/// Signs of the orientation of any four of at most [`Signs::MOST`] points.
#[derive(Clone, Debug, Default)]
pub struct Signs {
    points: Vec<[f64; 3]>,
    /// Of four in rising order.
    known: Vec<i8>,
}

/// A sign that was not asked for yet.
const UNKNOWN: i8 = i8::MIN;

impl Signs {
    /// As many points as the bits of a set of them.
    pub const MOST: usize = 32;

    /// Of these points.
    pub fn read(&mut self, points: impl Iterator<Item = [f64; 3]>) {
        self.points.clear();
        self.points.extend(points);
        self.known.clear();
        self.known.resize(choose(self.points.len(), 4), UNKNOWN);
    }

    /// How many points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Where a point is.
    pub fn place(&self, point: u8) -> &[f64; 3] {
        &self.points[usize::from(point)]
    }

    /// 1 if four points make a positive tetrahedron, −1 if it is turned over, 0 if they lie in a plane.
    pub fn of(&mut self, mut points: [u8; 4]) -> i8 {
        let mut turn = 1;
        for (low, high) in [(0, 1), (2, 3), (0, 2), (1, 3), (1, 2)] {
            if points[low] > points[high] {
                points.swap(low, high);
                turn = -turn;
            }
        }
        let index: usize = (0..4).map(|k| choose(usize::from(points[k]), k + 1)).sum();
        if self.known[index] == UNKNOWN {
            let volume = orientation::<3, 4>(points.map(|point| &self.points[usize::from(point)]));
            self.known[index] = i8::from(volume > 0.0) - i8::from(volume < 0.0);
        }
        turn * self.known[index]
    }

    /// Whether an edge passes through the inside of a face from one side to the other.
    pub fn pierces(&mut self, [d, e]: [u8; 2], [a, b, c]: [u8; 3]) -> bool {
        let shared = [a, b, c].iter().any(|corner| [d, e].contains(corner));
        !shared && self.of([a, b, c, d]) * self.of([a, b, c, e]) < 0 && {
            let turn = self.of([d, e, a, b]);
            turn != 0 && self.of([d, e, b, c]) == turn && self.of([d, e, c, a]) == turn
        }
    }
}

/// How many sets of k there are of n.
const fn choose(n: usize, k: usize) -> usize {
    match k {
        1 => n,
        2 => n * n.saturating_sub(1) / 2,
        3 => n * n.saturating_sub(1) * n.saturating_sub(2) / 6,
        _ => n * n.saturating_sub(1) * n.saturating_sub(2) * n.saturating_sub(3) / 24,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sign_turns_with_two_points_and_is_that_of_the_tetrahedron() {
        let mut signs = Signs::default();
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.5, 0.0]];
        signs.read(corners.into_iter());
        assert_eq!([[0, 1, 2, 3], [1, 0, 2, 3], [3, 0, 1, 2]].map(|four| signs.of(four)), [1, -1, -1]);
        assert_eq!([[0, 1, 2, 4], [4, 2, 0, 1]].map(|four| signs.of(four)), [0, 0]);
    }

    #[test]
    fn an_edge_pierces_the_face_that_it_passes_through() {
        let mut signs = Signs::default();
        let face = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let (below, above, aside) = ([0.2, 0.2, -1.0], [0.3, 0.3, 1.0], [2.0, 2.0, 1.0]);
        signs.read(face.into_iter().chain([below, above, aside]));
        assert!(signs.pierces([3, 4], [0, 1, 2]) && signs.pierces([4, 3], [2, 1, 0]));
        assert!(!signs.pierces([3, 5], [0, 1, 2]) && !signs.pierces([4, 5], [0, 1, 2]));
        assert!(!signs.pierces([0, 4], [0, 1, 2]));
    }
}
