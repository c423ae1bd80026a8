//! Points as the predicates want them: scaled, so that no product of five differences can leave the range of `f64`.

use crate::error::{Error, MOST_POINTS};

/// Scaled coordinates below this are read as zero: 10⁻³⁰ of the largest.
const SMALLEST: f64 = f64::from_bits((1023 - 100) << 52);

/// Coordinates of single points may exceed those that set the scale by this factor.
const LARGEST: f64 = (1u64 << 60) as f64;

/// A power of two that coordinates are multiplied by.
///
/// That is exact, so the triangulation is that of the points.
#[derive(Clone, Copy)]
pub struct Scale {
    /// Two factors: 2^1073, which lifts the smallest numbers of all, is itself out of range.
    halves: [f64; 2],
}

impl Default for Scale {
    fn default() -> Self {
        Self { halves: [1.0; 2] }
    }
}

impl Scale {
    /// Brings the largest coordinate into [1/2, 1).
    fn of<const D: usize>(points: &[[f64; D]]) -> Self {
        let largest = points.iter().flatten().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let exponent = if largest < f64::MIN_POSITIVE { -1022 } else { exponent(largest) + 1 };
        Self { halves: [-exponent / 2, -exponent - (-exponent / 2)].map(power_of_two) }
    }

    /// A scaled point.
    fn read<const D: usize>(&self, point: &[f64; D]) -> [f64; D] {
        point.map(|x| {
            let x = x * self.halves[0] * self.halves[1];
            if x.abs() < SMALLEST { 0.0 } else { x }
        })
    }

    /// A point that comes later, scaled; `index` is its number.
    pub fn read_one<const D: usize>(&self, place: [f64; D], index: usize) -> Result<[f64; D], Error> {
        if place.iter().any(|x| !x.is_finite()) {
            return Err(Error::NotFinite { point: index });
        }
        let scaled = self.read(&place);
        if scaled.iter().any(|x| x.abs() > LARGEST) {
            return Err(Error::TooFar { point: index });
        }
        Ok(scaled)
    }
}

/// Copies points to `scaled`, times the power of two that brings the largest coordinate into [1/2, 1).
pub fn scale<const D: usize>(points: &[[f64; D]], scaled: &mut Vec<[f64; D]>) -> Result<Scale, Error> {
    if points.len() > MOST_POINTS {
        return Err(Error::TooMany { points: points.len() });
    }
    if let Some(point) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
        return Err(Error::NotFinite { point });
    }
    let scale = Scale::of(points);
    scaled.clear();
    scaled.extend(points.iter().map(|point| scale.read(point)));
    Ok(scale)
}

/// e of a normal number ±1.… · 2^e.
fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

/// 2^e, |e| < 1023.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

/// Smallest and largest coordinates of some points.
pub fn bounds<const D: usize>(points: impl Iterator<Item = [f64; D]>) -> ([f64; D], [f64; D]) {
    points.fold(([f64::INFINITY; D], [f64::NEG_INFINITY; D]), |(mut low, mut high), point| {
        for k in 0..D {
            low[k] = low[k].min(point[k]);
            high[k] = high[k].max(point[k]);
        }
        (low, high)
    })
}
