//! Where grains may be: a box, some of whose axes may wrap.

use crate::vector::Vector;

/// A box; grains leave it through its sides unless the axis is periodic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<const D: usize> {
    /// Corner of smallest coordinates \[m\]; may be -∞ where the axis is not periodic.
    pub lower: Vector<D>,
    /// Corner of largest coordinates \[m\].
    pub upper: Vector<D>,
    /// Axes that wrap.
    pub periodic: [bool; D],
}

/// How many periods a neighbour is away along each axis (-1, 0, 1), as the digits of a number in base 3.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Image(pub u32);

impl Image {
    /// The image `periods` away.
    pub fn new<const D: usize>(periods: [i32; D]) -> Self {
        Self(periods.iter().rev().fold(0, |code, &period| 3 * code + (period + 1) as u32))
    }
}

impl<const D: usize> Domain<D> {
    /// All space.
    pub fn unbounded() -> Self {
        Self {
            lower: Vector::from_element(f64::NEG_INFINITY),
            upper: Vector::from_element(f64::INFINITY),
            periodic: [false; D],
        }
    }

    /// A box with no periodic axis.
    pub fn new(lower: [f64; D], upper: [f64; D]) -> Self {
        Self { lower: lower.into(), upper: upper.into(), periodic: [false; D] }
    }

    /// The same box with these axes periodic.
    pub fn periodic(self, periodic: [bool; D]) -> Self {
        Self { periodic, ..self }
    }

    /// Length of an axis \[m\].
    #[inline]
    pub fn period(&self, axis: usize) -> f64 {
        self.upper[axis] - self.lower[axis]
    }

    /// Whether a centre has not left through a side that does not wrap.
    #[inline]
    pub fn holds(&self, centre: &Vector<D>) -> bool {
        (0..D).all(|axis| {
            self.periodic[axis] || (centre[axis] >= self.lower[axis] && centre[axis] <= self.upper[axis])
        })
    }

    /// How far each of the 3^D images is, by code.
    pub fn shifts(&self) -> Vec<Vector<D>> {
        (0..3_usize.pow(D as u32))
            .map(|code| {
                Vector::from_fn(|axis, _| {
                    let period = (code / 3_usize.pow(axis as u32)) % 3;
                    if self.periodic[axis] { (period as f64 - 1.0) * self.period(axis) } else { 0.0 }
                })
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_and_its_reverse_shift_by_opposite_vectors() {
        let domain = Domain::new([0.0, 0.0], [1.0, 3.0]).periodic([true, true]);
        let shifts = domain.shifts();
        let image = Image::new([1, -1]);
        assert_eq!(shifts[image.0 as usize], Vector::from([1.0, -3.0]));
        assert_eq!(shifts[Image::new([-1, 1]).0 as usize], Vector::from([-1.0, 3.0]));
        assert_eq!(shifts[Image::new([0, 0]).0 as usize].norm(), 0.0);
    }
}
