//! Determinants with the right sign, however close to zero: with integers where the points have few enough bits between
//! them, which is so unless a coordinate is tiny beside the distances; else with expansions of `f64` (Shewchuk 1997).

mod lattice;
mod wide;

use super::rough_orientation;
use lattice::differences;
use robust::{Coord, Coord3D};
use wide::Wide;

/// Sign of D! times the volume of a simplex.
#[inline(always)]
pub fn orientation<const D: usize, const N: usize>(corners: [&[f64; D]; N]) -> f64 {
    let rounded = rough_orientation(corners);
    if rounded != 0.0 { rounded } else { exact_orientation(corners) }
}

#[inline(never)]
fn exact_orientation<const D: usize, const N: usize>(corners: [&[f64; D]; N]) -> f64 {
    if D == 2 {
        let [a, b, c] = [0, 1, 2].map(|k| planar(corners[k]));
        return robust::orient2d(a, b, c);
    }
    let [a, b, c, d] = [0, 1, 2, 3].map(|k| corners[k]);
    match differences([a, b, c], d) {
        Some([a, b, c]) => -volume([a, b, c].map(spatial)),
        None => {
            let [a, b, c, d] = [a, b, c, d].map(coordinates);
            -robust::orient3d(a, b, c, d)
        }
    }
}

/// Sign of the in-sphere determinant: positive if `point` lies inside the circumsphere of a positive simplex.
pub fn in_sphere<const D: usize, const N: usize>(corners: [&[f64; D]; N], point: &[f64; D]) -> f64 {
    match differences(corners, point) {
        Some(seen) if D == 2 => in_circle([0, 1, 2].map(|k| [seen[k][0], seen[k][1]])),
        Some(seen) => in_ball([0, 1, 2, 3].map(|k| spatial(seen[k]))),
        None if D == 2 => {
            let [a, b, c] = [0, 1, 2].map(|k| planar(corners[k]));
            robust::incircle(a, b, c, planar(point))
        }
        None => {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| coordinates(corners[k]));
            -robust::insphere(a, b, c, d, coordinates(point))
        }
    }
}

/// Whether three points lie on one line: their projections along every axis do.
pub fn collinear<const D: usize>(points: [&[f64; D]; 3]) -> bool {
    let along = |axis: usize| {
        let [a, b, c] = points.map(|p| Coord { x: p[axis], y: p[(axis + 1) % D] });
        robust::orient2d(a, b, c) == 0.0
    };
    (0..D).all(along)
}

/// a × b in the plane of the first two axes.
#[inline(always)]
fn minor<const D: usize>(a: &[i64; D], b: &[i64; D]) -> i128 {
    i128::from(a[0]) * i128::from(b[1]) - i128::from(b[0]) * i128::from(a[1])
}

/// |a|².
#[inline(always)]
fn lift<const D: usize>(a: &[i64; D]) -> u128 {
    a.iter().map(|a| u128::from(a.unsigned_abs()).pow(2)).sum()
}

/// Sign of a · (b × c).
fn volume([a, b, c]: [[i64; 3]; 3]) -> f64 {
    triple::<4>(&a, &b, &c, [minor(&b, &c), minor(&a, &c), minor(&a, &b)]).sign()
}

/// a · (b × c) from the minors of (b, c), (a, c) and (a, b).
#[inline(always)]
fn triple<const L: usize>(a: &[i64; 3], b: &[i64; 3], c: &[i64; 3], [bc, ac, ab]: [i128; 3]) -> Wide<L> {
    let term = |minor: i128, factor: i64| Wide::from(minor).times(factor);
    term(bc, a[2]).minus(term(ac, b[2])).plus(term(ab, c[2]))
}

fn in_circle([a, b, c]: [[i64; 2]; 3]) -> f64 {
    let term = |a, b, c| Wide::<5>::from(minor(b, c)).times_unsigned(lift(a));
    term(&a, &b, &c).plus(term(&b, &c, &a)).plus(term(&c, &a, &b)).sign()
}

fn in_ball([a, b, c, d]: [[i64; 3]; 4]) -> f64 {
    let [ab, ac, ad] = [&b, &c, &d].map(|other| minor(&a, other));
    let [bc, bd, cd] = [(&b, &c), (&b, &d), (&c, &d)].map(|(a, b)| minor(a, b));
    let abc = triple::<6>(&a, &b, &c, [bc, ac, ab]).times_unsigned(lift(&d));
    let abd = triple::<6>(&a, &b, &d, [bd, ad, ab]).times_unsigned(lift(&c));
    let acd = triple::<6>(&a, &c, &d, [cd, ad, ac]).times_unsigned(lift(&b));
    let bcd = triple::<6>(&b, &c, &d, [cd, bd, bc]).times_unsigned(lift(&a));
    bcd.minus(acd).plus(abd).minus(abc).sign()
}

fn spatial<const D: usize>(a: [i64; D]) -> [i64; 3] {
    [a[0], a[1], a[2]]
}

fn planar<const D: usize>(point: &[f64; D]) -> Coord<f64> {
    Coord { x: point[0], y: point[1] }
}

fn coordinates<const D: usize>(point: &[f64; D]) -> Coord3D<f64> {
    Coord3D { x: point[0], y: point[1], z: point[2] }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of `bits` random bits times 2^-40.
    fn number(state: &mut u64, bits: u32) -> f64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((*state >> 11) as i64 >> (53 - bits)) as f64 * f64::powi(2.0, -40)
    }

    #[test]
    fn integers_and_expansions_agree_near_and_on_spheres() {
        let mut state = 1;
        let (mut compared, mut zero) = (0, [0; 2]);
        for round in 0..20_000 {
            let bits = [3, 4, 20, 40, 53][round % 5];
            let mut points: [[f64; 3]; 5] =
                std::array::from_fn(|_| std::array::from_fn(|_| number(&mut state, bits)));
            if round % 2 == 0 {
                // Nearly a rectangle.
                points[3] = [points[0][0], points[2][1], points[0][2]];
                points[4] = [points[2][0], points[0][1].next_up(), points[0][2]];
                points[2][2] = points[0][2];
            }
            let [a, b, c, d, e] = points.each_ref();
            let Some(ball) = differences([a, b, c, d], e).map(in_ball) else { continue };
            let Some(corner) = differences([a, b, c], d).map(volume) else { continue };
            let [fa, fb, fc, fd, fe] = [a, b, c, d, e].map(coordinates);
            assert_eq!(ball, -sign(robust::insphere(fa, fb, fc, fd, fe)));
            assert_eq!(corner, sign(robust::orient3d(fa, fb, fc, fd)));
            let flat = points.map(|p| [p[0], p[1]]);
            let [a, _, c, d, e] = flat.each_ref();
            let Some(circle) = differences([a, c, d], e).map(in_circle) else { continue };
            let [a, c, d, e] = [a, c, d, e].map(planar);
            assert_eq!(circle, sign(robust::incircle(a, c, d, e)));
            compared += 1;
            zero = [zero[0] + usize::from(ball == 0.0), zero[1] + usize::from(circle == 0.0)];
        }
        assert!(compared > 15_000 && zero.iter().all(|zero| *zero > 100), "{compared} {zero:?}");
    }

    fn sign(x: f64) -> f64 {
        if x == 0.0 { 0.0 } else { x.signum() }
    }
}
