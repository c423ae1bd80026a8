//! The share of a grain below a surface.

use std::f64::consts::PI;

/// Share of the volume of a ball (2D: of the area of a disc) below a plane; ξ is the height of the plane over the centre in
/// radii.
///
/// Ball: (2 + 3ξ − ξ³)/4, disc: 1/2 + (arcsin ξ + ξ √(1 − ξ²))/π, for −1 ≤ ξ ≤ 1.
pub fn share_below<const D: usize>(height: f64) -> f64 {
    let height = height.clamp(-1.0, 1.0);
    match D {
        2 => 0.5 + (height.asin() + height * (1.0 - height * height).sqrt()) / PI,
        _ => 0.25 * (2.0 + height * (3.0 - height * height)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counts points of a fine lattice in the unit ball.
    fn counted<const D: usize>(height: f64) -> f64 {
        const POINTS: i32 = 60;
        let coordinate = |i: i32| (f64::from(i) + 0.5) / f64::from(POINTS);
        let (mut below, mut all) = (0.0, 0.0);
        for i in -POINTS..POINTS {
            for j in -POINTS..POINTS {
                for k in if D == 2 { 0..1 } else { -POINTS..POINTS } {
                    let z = if D == 2 { 0.0 } else { coordinate(k) };
                    if coordinate(i).powi(2) + coordinate(j).powi(2) + z * z <= 1.0 {
                        all += 1.0;
                        below += f64::from(u8::from(coordinate(i) <= height));
                    }
                }
            }
        }
        below / all
    }

    #[test]
    fn the_share_is_what_counting_gives_none_when_dry_and_all_when_deep() {
        for height in [-0.9, -0.5, -0.1, 0.0, 0.3, 0.7] {
            assert!((share_below::<2>(height) - counted::<2>(height)).abs() < 0.01);
            assert!((share_below::<3>(height) - counted::<3>(height)).abs() < 0.01);
        }
        assert_eq!((share_below::<2>(-1.5), share_below::<3>(-1.5)), (0.0, 0.0));
        assert_eq!((share_below::<2>(1.0), share_below::<3>(7.0)), (1.0, 1.0));
    }
}
