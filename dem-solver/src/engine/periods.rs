//! Periodic axes.

use crate::domain::Domain;
use crate::grains::Place;
use crate::lanes::{Lanes, Vec3};
use crate::vector::{Spin, lane, unlane};

/// Lengths of the periodic axes \[m\] and their inverses; both 0 along axes that do not wrap.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Periods {
    lower: [f64; 3],
    length: [f64; 3],
    inverse: [f64; 3],
    wrap: bool,
}

impl Periods {
    /// The periods of a domain.
    pub fn new<const D: usize>(domain: &Domain<D>) -> Self {
        let wraps = |axis: usize| axis < D && domain.periodic[axis];
        let length = std::array::from_fn(|axis| if wraps(axis) { domain.period(axis) } else { 0.0 });
        Self {
            lower: std::array::from_fn(|axis| if wraps(axis) { domain.lower[axis] } else { 0.0 }),
            length,
            inverse: length.map(|length| if length > 0.0 { 1.0 / length } else { 0.0 }),
            wrap: domain.periodic.contains(&true),
        }
    }

    /// Lower end and length of an axis \[m\], if it wraps.
    pub fn axis(&self, axis: usize) -> Option<(f64, f64)> {
        (self.length[axis] > 0.0).then_some((self.lower[axis], self.length[axis]))
    }

    /// The separation of the nearest images: d - L round(d/L).
    #[inline(always)]
    pub fn nearest<L: Lanes>(&self, d: Vec3<L>) -> Vec3<L> {
        if !self.wrap {
            return d;
        }
        let wrapped = |d: L, k: usize| d - (d * L::splat(self.inverse[k])).round() * L::splat(self.length[k]);
        Vec3::new(wrapped(d.x, 0), wrapped(d.y, 1), wrapped(d.z, 2))
    }

    /// How far two grains overlap, by their nearest images \[m\].
    pub fn overlap(&self, a: &Place, b: &Place) -> f64 {
        a.radius + b.radius - unlane(self.nearest(lane(&(b.centre - a.centre)))).norm()
    }

    /// The image of a point that is nearest to another.
    pub fn image_near(&self, point: &Spin, other: &Spin) -> Spin {
        if !self.wrap {
            return *point;
        }
        let apart = point - other;
        Spin::from_fn(|k, _| point[k] - (apart[k] * self.inverse[k]).round() * self.length[k])
    }

    /// Brings a centre back into the domain.
    pub fn wrap(&self, centre: &mut Spin) {
        for axis in 0..3 {
            let (lower, length) = (self.lower[axis], self.length[axis]);
            let upper = lower + length;
            let x = &mut centre[axis];
            if length > 0.0 && !(*x >= lower && *x < upper) {
                let back = *x - length * ((*x - lower) * self.inverse[axis]).floor();
                // A rounding below the lower side comes back as the upper one.
                *x = if back >= upper { lower } else { back.max(lower) };
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrapped_point_is_inside_even_a_rounding_below_the_lower_side() {
        let periods = Periods::new(&Domain::new([0.0], [1.0]).periodic([true]));
        for x in [-1e-300, -0.25, 1.0, 1.75, -7.5, 12.0] {
            let mut centre = Spin::new(x, 0.0, 0.0);
            periods.wrap(&mut centre);
            assert!((0.0..1.0).contains(&centre.x), "{x} wraps to {}", centre.x);
        }
    }
}
