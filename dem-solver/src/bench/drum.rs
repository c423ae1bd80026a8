//! A drum of triangles, closed at both ends, that turns about the y axis.

use std::f64::consts::TAU;

use crate::vector::Vector;
use crate::wall::Facet;

/// Flat sides around the axis: after a turn by one of them the drum is the same.
pub const SIDES: usize = 60;
/// Turns in a second: 20 in a minute.
pub const RATE: f64 = 20.0 / 60.0;
/// Seconds after which the grains' slope is steady and the drum, 8 sides further, the same as at the start.
pub const STEADY: f64 = 8.0 / (SIDES as f64 * RATE);
/// Rings of triangles from end to end.
const RINGS: usize = 8;

/// A drum as long as its radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drum {
    /// Radius of the circle through its edges, and length \[m\].
    pub radius: f64,
}

impl Drum {
    /// The drum that so many grains of a radius \[m\] fill by half, 60 % of that half solid: ½ π R³ 0.6 = N V.
    pub fn half_full(grains: usize, radius: f64) -> Self {
        let solid = grains as f64 * crate::volume::<3>(radius, 1.0);
        Self { radius: (solid / (0.25 * TAU * 0.6)).cbrt() }
    }

    /// Whether a sphere \[m\] has room in it.
    pub fn holds(&self, centre: &Vector<3>, radius: f64) -> bool {
        let inside = self.radius * (0.5 * TAU / SIDES as f64).cos() - radius;
        centre.x.hypot(centre.z) < inside && (radius..self.radius - radius).contains(&centre.y)
    }

    /// Its surface.
    pub fn facets(&self) -> Vec<Facet<3>> {
        let rim = |side: usize, y: f64| {
            let (sine, cosine) = (TAU * (side % SIDES) as f64 / SIDES as f64).sin_cos();
            Vector::from([self.radius * cosine, y, self.radius * sine])
        };
        let along = |ring: usize| self.radius * ring as f64 / RINGS as f64;
        let sides = (0..SIDES).flat_map(|side| (0..RINGS).map(move |ring| (side, ring)));
        let mantle = sides.flat_map(|(side, ring)| {
            let (near, far) = (along(ring), along(ring + 1));
            let [a, b, c, d] = [rim(side, near), rim(side + 1, near), rim(side + 1, far), rim(side, far)];
            [[a, b, c], [a, c, d]]
        });
        let ends = (0..SIDES).flat_map(|side| {
            let end = |y: f64| [Vector::from([0.0, y, 0.0]), rim(side, y), rim(side + 1, y)];
            [end(along(0)), end(along(RINGS))]
        });
        mantle.chain(ends).map(|vertices| Facet { vertices }).collect()
    }
}
