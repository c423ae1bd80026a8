//! How much of a grain is in the fluid.

use crate::element::simplex::{Vector, cross, difference, dot, in_space};
use std::f64::consts::PI;

/// A centre nearer to the plane of a facet than this share of the radius is on the side that it is said to be on.
const IN_PLANE: f64 = 1e-6;

/// Volume of a ball (2D: area of a disc) of a radius (m).
pub fn ball_volume<const D: usize>(radius: f64) -> f64 {
    match D {
        2 => PI * radius.powi(2),
        _ => 4.0 / 3.0 * PI * radius.powi(3),
    }
}

/// What a facet of the surface takes off a ball (m³; m² in 2D) whose centre is in the fluid or not: the sector of the ball that is
/// seen through the facet, less what of that lies before it. Corners turn left seen from outside.
///
/// All facets that cut the ball leave V − Σ of it in the fluid if the centre is, else −Σ: exactly, if they are one surface.
/// At a distance d the ball cuts a disc of radius √(r² − d²) out of the plane of the facet. Of the part A of the facet in it, seen
/// under the angle Ω, the facet takes ±(r^D Ω − |d| A)/D.
pub fn cut_off<const D: usize>(x: &Vector<D>, radius: f64, corners: &[Vector<D>; D], inside: bool) -> f64 {
    let [a, b] = [0, 1].map(|i| in_space(&difference(&corners[i], x)));
    let edge = difference(&b, &a);
    let last = if D == 2 { [a[0], a[1], 1.0] } else { in_space(&difference(&corners[D - 1], x)) };
    let normal = unit(&cross(&edge, &difference(&last, &a)));
    let distance = dot(&normal, &a);
    let away = distance.abs();
    if away >= radius || normal.iter().any(|component| component.is_nan()) {
        return 0.0;
    }
    let outwards = if away <= IN_PLANE * radius { inside } else { distance > 0.0 };
    let along = unit(&edge);
    let reach = (radius * radius - away * away).sqrt();
    let (area, angle) = if D == 2 {
        let [from, to] = [&a, &b].map(|end| dot(&along, end).clamp(-reach, reach));
        (to - from, to.atan2(away) - from.atan2(away))
    } else {
        let across = cross(&normal, &along);
        let flat = [a, b, last].map(|corner| [dot(&along, &corner), dot(&across, &corner)]);
        let sides = [0, 1, 2].map(|i| seen_over_side(flat[i], flat[(i + 1) % 3], reach, away));
        sides.into_iter().fold((0.0, 0.0), |sum, side| (sum.0 + side.0, sum.1 + side.1))
    };
    let taken = (radius.powi(D as i32) * angle - away * area) / D as f64;
    if outwards { taken } else { -taken }
}

/// Area between the origin and a side of a polygon as far as it lies in a disc around the origin, and the solid angle under which
/// it is seen from this far `away` over the origin.
///
/// Where the side is in the disc, at a distance e of its line, Ω = Δφ − Δasin(z sin φ/√(z² + e²)); where it is not, the arc counts:
/// Ω = Δφ(1 − z/√(z² + R²)).
fn seen_over_side(p: [f64; 2], q: [f64; 2], reach: f64, away: f64) -> (f64, f64) {
    let length = (q[0] - p[0]).hypot(q[1] - p[1]);
    let off = (p[0] * q[1] - p[1] * q[0]) / length;
    if length == 0.0 || off == 0.0 {
        return (0.0, 0.0);
    }
    let along = |x: [f64; 2]| (x[0] * (q[0] - p[0]) + x[1] * (q[1] - p[1])) / length;
    let line = off.abs();
    let angle = |along: f64| along.atan2(line);
    let half = (reach * reach - line * line).max(0.0).sqrt();
    let [from, to] = [along(p), along(q)];
    let [enters, leaves] = [from, to].map(|end| end.clamp(-half, half));
    let within = angle(leaves) - angle(enters);
    let beyond = angle(to) - angle(from) - within;
    let lower = |along: f64| (away * angle(along).sin() / away.hypot(line)).asin();
    let area = 0.5 * (line * (leaves - enters) + reach * reach * beyond);
    let solid = within - (lower(leaves) - lower(enters)) + beyond * (1.0 - away / away.hypot(reach));
    (off.signum() * area, off.signum() * solid)
}

fn unit(a: &[f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    a.map(|component| component / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of the ball of radius 1 below the plane z = h (2D: y = h), by facets that turn about the axis.
    fn share_below<const D: usize>(height: f64, turned: f64) -> f64 {
        let inside = height > 0.0;
        let taken: f64 = if D == 2 {
            let corners: [Vector<D>; D] = std::array::from_fn(|i| {
                std::array::from_fn(|k| if k == 1 { height } else { [3.0, -2.0][i] })
            });
            cut_off(&[0.0; D], 1.0, &corners, inside)
        } else {
            let around = |i: usize| {
                let angle = turned + i as f64 * PI / 2.5;
                [5.0 * angle.cos() + 0.3, 5.0 * angle.sin() - 0.2, height]
            };
            let facets = (0..5).map(|i| [[0.3, -0.2, height], around(i), around(i + 1)]);
            facets
                .map(|facet| {
                    let corners: [Vector<D>; D] =
                        std::array::from_fn(|i| std::array::from_fn(|k| facet[i][k]));
                    cut_off(&[0.0; D], 1.0, &corners, inside)
                })
                .sum()
        };
        (if inside { 1.0 } else { 0.0 }) - taken / ball_volume::<D>(1.0)
    }

    #[test]
    fn a_plane_cuts_off_a_cap() {
        for height in [-0.9, -0.5, -1e-3, 0.2, 0.7] {
            let x: f64 = height;
            let segment = 0.5 + (x.asin() + x * (1.0 - x * x).sqrt()) / PI;
            assert!((share_below::<2>(height, 0.0) - segment).abs() < 1e-14, "{height}");
            let cap = 0.25 * (2.0 + x * (3.0 - x * x));
            for turned in [0.0, 0.4, 1.9] {
                let share = share_below::<3>(height, turned);
                assert!((share - cap).abs() < 1e-14, "{height}: {share} {cap}");
            }
        }
    }

    #[test]
    fn a_ball_keeps_what_a_cell_holds_of_it() {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let faces = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]].map(|face| face.map(|i: usize| corners[i]));
        for (x, radius) in [([0.2, 0.2, 0.2], 0.3), ([0.4, 0.1, -0.1], 0.4), ([0.1, 0.15, 0.2], 5.0)] {
            let inside = x.iter().all(|&c| c > 0.0);
            let taken: f64 = faces.iter().map(|face| cut_off(&x, radius, face, inside)).sum();
            let kept = if inside { ball_volume::<3>(radius) } else { 0.0 } - taken;
            const POINTS: i32 = 100;
            let place = |i: i32| (f64::from(i) + 0.5) / f64::from(POINTS);
            let mut count = 0;
            for i in 0..POINTS {
                for j in 0..POINTS - i {
                    for k in 0..POINTS - i - j {
                        let point = [place(i), place(j), place(k)];
                        let off = difference(&point, &x);
                        let is_held = point.iter().sum::<f64>() < 1.0 && dot(&off, &off) < radius * radius;
                        count += i32::from(is_held);
                    }
                }
            }
            let counted = f64::from(count) / f64::from(POINTS).powi(3);
            assert!((kept - counted).abs() < 2e-3 * counted + 1e-4, "{x:?}: {kept} {counted}");
        }
    }
}
