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
    /// As many points as a set of them has bits.
    pub const MOST: usize = u32::BITS as usize;

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

    /// The [`sign`] of four different points.
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
            self.known[index] = sign(points.map(|point| self.place(point)));
        }
        turn * self.known[index]
    }

    /// Whether an edge passes through the inside of a face from one side to the other.
    pub fn pierces(&mut self, edge: [u8; 2], face: [u8; 3]) -> bool {
        pierces(edge, face, |four| self.of(four))
    }
}

/// 1 if four points make a positive tetrahedron, −1 if it is turned over, 0 if they lie in a plane.
pub fn sign(corners: [&[f64; 3]; 4]) -> i8 {
    let volume = orientation::<3, 4>(corners);
    i8::from(volume > 0.0) - i8::from(volume < 0.0)
}

/// Whether an edge passes through the inside of a face from one side to the other, by the signs of four points.
pub fn pierces<P: Copy + PartialEq>(
    [d, e]: [P; 2],
    [a, b, c]: [P; 3],
    mut sign: impl FnMut([P; 4]) -> i8,
) -> bool {
    let shared = [a, b, c].iter().any(|corner| [d, e].contains(corner));
    !shared && sign([a, b, c, d]) * sign([a, b, c, e]) < 0 && {
        let turn = sign([d, e, a, b]);
        turn != 0 && sign([d, e, b, c]) == turn && sign([d, e, c, a]) == turn
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
