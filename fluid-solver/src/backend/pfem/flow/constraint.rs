//! What walls prescribe of the velocity of a node.

use crate::element::simplex::{Vector, dot};

/// e_k·v = c_k for orthonormal e_1 … e_r, r ≤ D.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint<const D: usize> {
    directions: [Vector<D>; D],
    rank: usize,
    /// Σ c_k e_k.
    given: Vector<D>,
}

/// A normal with less than this outside the span of others is one of them.
const PARALLEL: f64 = 1e-6;

impl<const D: usize> Constraint<D> {
    /// Nothing prescribed.
    pub const FREE: Self = Self { directions: [[0.0; D]; D], rank: 0, given: [0.0; D] };

    /// All of the velocity prescribed.
    pub fn whole(velocity: &Vector<D>) -> Self {
        let mut constraint = Self::FREE;
        constraint.complete(velocity);
        constraint
    }

    /// Adds n·v = c for a unit normal n; the earlier ones hold where they contradict.
    pub fn add(&mut self, normal: &Vector<D>, value: f64) {
        let rest = self.free(normal);
        let length = dot(&rest, &rest).sqrt();
        if self.rank == D || length < PARALLEL {
            return;
        }
        let direction = rest.map(|component| component / length);
        let value = (value - dot(normal, &self.given)) / length;
        for k in 0..D {
            self.given[k] += value * direction[k];
        }
        self.directions[self.rank] = direction;
        self.rank += 1;
    }

    /// Prescribes the rest of the velocity too.
    pub fn complete(&mut self, velocity: &Vector<D>) {
        let rest = self.free(velocity);
        self.given = std::array::from_fn(|k| self.given[k] + rest[k]);
        self.rank = D;
        for (k, direction) in self.directions.iter_mut().enumerate() {
            *direction = std::array::from_fn(|l| if l == k { 1.0 } else { 0.0 });
        }
    }

    /// Whether nothing is left free.
    pub fn is_full(&self) -> bool {
        self.rank == D
    }

    /// The part of a vector in the free directions.
    #[inline]
    pub fn free(&self, v: &Vector<D>) -> Vector<D> {
        if self.rank == D {
            return [0.0; D];
        }
        let mut free = *v;
        for direction in &self.directions[..self.rank] {
            let along = dot(direction, &free);
            for k in 0..D {
                free[k] -= along * direction[k];
            }
        }
        free
    }

    /// The vector with the prescribed part put in its place.
    pub fn impose(&self, v: &Vector<D>) -> Vector<D> {
        let free = self.free(v);
        std::array::from_fn(|k| free[k] + self.given[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_oblique_walls_hold_both_of_their_conditions() {
        let (a, b) = ([0.6, 0.8, 0.0], [0.0, 1.0, 0.0]);
        let mut constraint = Constraint::FREE;
        constraint.add(&a, 2.0);
        constraint.add(&b, -1.0);
        constraint.add(&[-0.6, -0.8, 0.0], 7.0);
        let v = constraint.impose(&[5.0, 6.0, 7.0]);
        assert!((dot(&a, &v) - 2.0).abs() < 1e-14 && (dot(&b, &v) + 1.0).abs() < 1e-14 && v[2] == 7.0);
        constraint.complete(&[0.0, 0.0, 3.0]);
        assert!((dot(&a, &constraint.impose(&[9.0; 3])) - 2.0).abs() < 1e-14);
        assert_eq!(constraint.impose(&[9.0; 3])[2], 3.0);
    }
}
