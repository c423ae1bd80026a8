//! Determinants with the right sign, however close to zero (Shewchuk 1997).

use robust::{Coord, Coord3D};

/// Sign of D! times the volume of a simplex.
pub fn orientation<const D: usize, const N: usize>(corners: [&[f64; D]; N]) -> f64 {
    if D == 2 {
        let [a, b, c] = [0, 1, 2].map(|k| planar(corners[k]));
        robust::orient2d(a, b, c)
    } else {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| spatial(corners[k]));
        -robust::orient3d(a, b, c, d)
    }
}

/// Sign of the in-sphere determinant: positive if `point` lies inside the circumsphere of a positive simplex.
pub fn in_sphere<const D: usize, const N: usize>(corners: [&[f64; D]; N], point: &[f64; D]) -> f64 {
    if D == 2 {
        let [a, b, c] = [0, 1, 2].map(|k| planar(corners[k]));
        robust::incircle(a, b, c, planar(point))
    } else {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| spatial(corners[k]));
        -robust::insphere(a, b, c, d, spatial(point))
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

fn planar<const D: usize>(point: &[f64; D]) -> Coord<f64> {
    Coord { x: point[0], y: point[1] }
}

fn spatial<const D: usize>(point: &[f64; D]) -> Coord3D<f64> {
    Coord3D { x: point[0], y: point[1], z: point[2] }
}
