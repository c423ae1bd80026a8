//! Points as integers.

use crate::predicate::larger;

/// Differences stay below this, so that sums of two products of them fit into 128 bits.
const LARGEST: f64 = (1u64 << 62) as f64;

/// Differences of points and an origin in the largest unit that all coordinates are multiples of, or a smaller one; none if
/// they have more than 62 bits.
#[inline(always)]
pub fn differences<const D: usize, const M: usize>(
    points: [&[f64; D]; M],
    origin: &[f64; D],
) -> Option<[[i64; D]; M]> {
    let mut least = 1075;
    for point in points.iter().chain([&origin]) {
        for x in *point {
            let exponent = (x.to_bits() >> 52) & 0x7ff;
            if exponent != 0 && exponent < least {
                least = exponent;
            }
        }
    }
    // 1 over the last bit of the number with the smallest exponent.
    let per_unit = f64::from_bits((2 * 1023 + 52 - least) << 52);
    let mut differences = [[0; D]; M];
    let mut largest = 0.0;
    for (point, difference) in points.iter().zip(&mut differences) {
        for k in 0..D {
            let (rounded, rest) = subtract(point[k], origin[k]);
            let [rounded, rest] = [rounded, rest].map(|x| x * per_unit);
            largest = larger(largest, rounded.abs());
            // Beyond the range of `i64` only where there will be none.
            difference[k] = (rounded as i64).wrapping_add(rest as i64);
        }
    }
    (largest < LARGEST).then_some(differences)
}

/// a − b as a rounded number and what rounding left (Knuth).
#[inline(always)]
fn subtract(a: f64, b: f64) -> (f64, f64) {
    let rounded = a - b;
    let b_seen = a - rounded;
    let a_seen = rounded + b_seen;
    (rounded, (a - a_seen) + (b_seen - b))
}

#[cfg(test)]
mod tests {
    use super::differences;

    #[test]
    fn differences_that_no_integer_holds_are_none() {
        let tiny = f64::from_bits((1023 - 90) << 52);
        assert_eq!(differences([&[0.75, tiny]], &[0.25, 0.0]), None);
        assert_eq!(differences([&[0.75, 0.0]], &[0.25, tiny]), None);
        assert_eq!(differences([&[0.75, 0.5]], &[0.5, 0.75]), Some([[1 << 51, -(1 << 51)]]));
    }
}
