//! Volume integrals over spheres that overlap.

use nalgebra::Matrix3;

use super::Member;
use crate::vector::Vector;

/// Columns along the longer side of a clump of spheres, and of one of discs: the inertia is met to 1e-5.
const COLUMNS_OF_SPHERES: f64 = 1024.0;
const COLUMNS_OF_DISCS: f64 = 65536.0;

/// Integrals over a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// ∫ dV \[m³\]; in two dimensions ∫ dA \[m²\], and so on.
    pub volume: f64,
    /// ∫ x dV.
    pub first: Vector<3>,
    /// ∫ x xᵀ dV.
    pub second: Matrix3<f64>,
}

impl Moments {
    /// Over nothing.
    pub fn zero() -> Self {
        Self { volume: 0.0, first: Vector::zeros(), second: Matrix3::zeros() }
    }

    /// Adds a homogeneous body of this volume and centre whose second moment about its centre is `own` times unity.
    pub fn add(&mut self, volume: f64, centre: &Vector<3>, own: f64) {
        self.volume += volume;
        self.first += centre * volume;
        self.second += centre * centre.transpose() * volume + Matrix3::from_diagonal_element(own);
    }
}

/// Integrals over the union of the members, each point counted once: by the midpoint rule over columns along x, exact
/// along each column. Members of a `planar` body are discs in z = 0.
pub fn moments_of_union(members: &[Member], planar: bool) -> Moments {
    let low = |axis: usize| members.iter().map(|m| m.offset[axis] - m.radius).fold(f64::INFINITY, f64::min);
    let high =
        |axis: usize| members.iter().map(|m| m.offset[axis] + m.radius).fold(f64::NEG_INFINITY, f64::max);
    let lower = Vector::from([low(0), low(1), low(2)]);
    let extent = Vector::from([high(0), high(1), high(2)]) - lower;
    let (rows, layers, width) = if planar {
        (COLUMNS_OF_DISCS, 1.0, extent.y / COLUMNS_OF_DISCS)
    } else {
        let width = extent.y.max(extent.z) / COLUMNS_OF_SPHERES;
        ((extent.y / width).ceil(), (extent.z / width).ceil(), width)
    };
    // A symmetrical body meets symmetrical columns.
    let start = |axis: usize, count: f64| lower[axis] + 0.5 * (extent[axis] - (count - 1.0) * width);
    let (first_y, first_z) = (start(1, rows), start(2, layers));
    let cross_section = if planar { width } else { width * width };
    let mut moments = Moments::zero();
    let mut stretches = vec![];
    for layer in 0..layers as usize {
        let z = if planar { 0.0 } else { first_z + layer as f64 * width };
        for row in 0..rows as usize {
            let y = first_y + row as f64 * width;
            find_stretches(members, y, z, &mut stretches);
            for [a, b] in stretches.drain(..) {
                let length = b - a;
                let centre = Vector::from([0.5 * (a + b), y, z]);
                let volume = length * cross_section;
                moments.volume += volume;
                moments.first += centre * volume;
                moments.second += centre * centre.transpose() * volume;
                moments.second[(0, 0)] += volume * length * length / 12.0;
            }
        }
    }
    moments
}

/// Stretches of the column at (y, z) that lie in any member, apart from each other and ascending.
fn find_stretches(members: &[Member], y: f64, z: f64, stretches: &mut Vec<[f64; 2]>) {
    for Member { offset, radius } in members {
        let square = radius * radius - (y - offset.y).powi(2) - (z - offset.z).powi(2);
        if square > 0.0 {
            stretches.push([offset.x - square.sqrt(), offset.x + square.sqrt()]);
        }
    }
    stretches.sort_by(|one, other| one[0].total_cmp(&other[0]));
    stretches.dedup_by(|next, last| {
        let joined = next[0] <= last[1];
        if joined {
            last[1] = last[1].max(next[1]);
        }
        joined
    });
}
