//! A box.

use super::Space;
use crate::domain::Domain;
use crate::insertion::Random;
use crate::vector::Vector;

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxRegion<const D: usize> {
    /// Corner of smallest coordinates \[m\].
    pub lower: Vector<D>,
    /// Corner of largest coordinates \[m\].
    pub upper: Vector<D>,
}

impl<const D: usize> Space<D> for BoxRegion<D> {
    fn bounds(&self) -> (Vector<D>, Vector<D>) {
        (self.lower, self.upper)
    }

    fn volume(&self) -> f64 {
        (self.upper - self.lower).product()
    }

    fn holds(&self, point: &Vector<D>) -> bool {
        (0..D).all(|axis| point[axis] >= self.lower[axis] && point[axis] <= self.upper[axis])
    }

    /// Where the box spans a periodic axis, the grain may reach across its ends.
    fn place(&self, domain: &Domain<D>, radius: f64, random: &mut Random) -> Option<Vector<D>> {
        let Self { lower, upper } = self;
        let mut centre = Vector::zeros();
        for axis in 0..D {
            let spans = domain.periodic[axis]
                && lower[axis] <= domain.lower[axis]
                && upper[axis] >= domain.upper[axis];
            let margin = if spans { 0.0 } else { radius };
            let (low, high) = (lower[axis] + margin, upper[axis] - margin);
            if low > high {
                return None;
            }
            centre[axis] = random.between(low, high);
        }
        Some(centre)
    }
}
