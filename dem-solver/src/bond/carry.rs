//! Rotations that carry a bond's forces along.

use super::turn::Turn;
use crate::vector::Vector;

/// How a bond as a whole turned: with the mean of its grains, then the shortest way onto its new direction.
///
/// Where both grains turned with the bond the second part is none: a rigid rotation is carried out exactly, however
/// large it is and about whatever axis.
pub struct Carry {
    mean: Turn,
    turned: Vector<3>,
    direction: Vector<3>,
}

impl Carry {
    /// From one direction of the bond to the next (unit vectors), while its grains turned by these rotation vectors.
    pub fn new(before: &Vector<3>, direction: &Vector<3>, turns: &[Vector<3>; 2]) -> Self {
        let mean = Turn::new((turns[0] + turns[1]) * 0.5);
        Self { mean, turned: mean.apply(before), direction: *direction }
    }

    /// The vector, carried along.
    ///
    /// Shortest rotation from unit vector a to b: v + (2 a·v) b - (a + b)·v/(1 + a·b) (a + b).
    pub fn apply(&self, vector: &Vector<3>) -> Vector<3> {
        let (a, b) = (&self.turned, &self.direction);
        let v = self.mean.apply(vector);
        let sum = a + b;
        v + b * (2.0 * a.dot(&v)) - sum * (sum.dot(&v) / (1.0 + a.dot(b)))
    }
}

/// The part of a vector across this unit vector.
pub fn across(vector: &Vector<3>, direction: &Vector<3>) -> Vector<3> {
    vector - direction * vector.dot(direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shortest_way_keeps_lengths_and_takes_the_old_direction_to_the_new() {
        let (a, b) = (Vector::from([0.6, 0.0, 0.8]), Vector::from([0.0, -0.8, 0.6]));
        let carry = Carry::new(&a, &b, &[Vector::zeros(); 2]);
        assert!((carry.apply(&a) - b).norm() < 1e-15);
        let v = Vector::from([1.0, 2.0, -3.0]);
        assert!((carry.apply(&v).norm() - v.norm()).abs() < 1e-14);
        assert!((carry.apply(&a.cross(&b)) - a.cross(&b)).norm() < 1e-15);
    }
}
