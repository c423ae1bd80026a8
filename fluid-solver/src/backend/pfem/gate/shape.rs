//! Shapes of inlets, and the layer of cells before one.

use crate::backend::pfem::body::Body;
use crate::backend::pfem::wall::Plane;
use crate::element::simplex::{Vector, difference, dot};
use crate::error::FluidError;
use crate::mesh::generate::Disc;
use case_io::document::{self, unit_vector};
use std::f64::consts::PI;

/// A flat shape.
pub struct Shape<const D: usize> {
    /// Its plane, the normal into the fluid.
    pub plane: Plane<D>,
    outline: Outline<D>,
}

enum Outline<const D: usize> {
    /// Corners of a box without thickness.
    Box(Vector<D>, Vector<D>),
    /// Radius of a disc around the point of the plane (m).
    Disc(f64),
}

impl<const D: usize> Shape<D> {
    /// That of a checked table.
    pub fn of(inlet: &document::Inlet) -> Self {
        let normal = unit_vector(&inlet.normal);
        match (&inlet.flat, &inlet.disc) {
            (Some(bounds), _) => {
                let (lower, upper) = (bounds.lower.to_array(), bounds.upper.to_array());
                Self { plane: Plane { point: lower, normal }, outline: Outline::Box(lower, upper) }
            }
            (None, disc) => {
                let (point, radius) =
                    disc.as_ref().map_or(([0.0; D], 0.0), |disc| (disc.centre.to_array(), disc.radius.si()));
                Self { plane: Plane { point, normal }, outline: Outline::Disc(radius) }
            }
        }
    }

    /// Its area (m²; m in 2D).
    pub fn area(&self) -> f64 {
        match &self.outline {
            Outline::Box(lower, upper) => {
                (0..D).map(|k| upper[k] - lower[k]).filter(|&edge| edge > 0.0).product()
            }
            Outline::Disc(radius) => PI * radius * radius,
        }
    }

    /// Its least width (m).
    pub fn width(&self) -> f64 {
        match &self.outline {
            Outline::Box(lower, upper) => {
                let edges = (0..D).map(|k| upper[k] - lower[k]);
                edges.filter(|&edge| edge > 0.0).fold(f64::INFINITY, f64::min)
            }
            Outline::Disc(radius) => 2.0 * radius,
        }
    }

    /// Whether a point is in it, or before it by less than `depth`; `near` is how exactly (m).
    pub fn holds(&self, x: &Vector<D>, depth: f64, near: f64) -> bool {
        let gap = self.plane.touch(x).gap;
        if gap < -near || gap > depth + near {
            return false;
        }
        let foot: Vector<D> = std::array::from_fn(|k| x[k] - gap * self.plane.normal[k]);
        match &self.outline {
            Outline::Box(lower, upper) => {
                (0..D).all(|k| foot[k] >= lower[k] - near && foot[k] <= upper[k] + near)
            }
            Outline::Disc(radius) => {
                let arm = difference(&foot, &self.plane.point);
                dot(&arm, &arm).sqrt() <= radius + near
            }
        }
    }

    /// One layer of cells before it, as thick as cells are large.
    ///
    /// # Errors
    /// More nodes than can be counted.
    pub fn layer<const N: usize>(&self, size: f64) -> Result<Body<D, N>, FluidError> {
        let n = &self.plane.normal;
        match &self.outline {
            Outline::Box(lower, upper) => {
                let lower = std::array::from_fn(|k| lower[k] + (size * n[k]).min(0.0));
                let upper = std::array::from_fn(|k| upper[k] + (size * n[k]).max(0.0));
                Ok(Body::of_box(lower, upper, size)?)
            }
            Outline::Disc(radius) => {
                let rings = (radius / size).ceil().max(1.0) as usize;
                let [first, second] = across(n);
                let place = |height: f64| {
                    let on_it = Disc::new(*radius, rings).points.into_iter();
                    on_it.map(move |[a, b]| -> Vector<D> {
                        let at = |k: usize| self.plane.point[k] + a * first[k] + b * second[k];
                        std::array::from_fn(|k| at(k) + height * n[k])
                    })
                };
                Ok(Body::of_points(place(0.0).chain(place(size)).collect())?)
            }
        }
    }
}

/// Two unit vectors across a normal, and across each other (3D).
fn across<const D: usize>(n: &Vector<D>) -> [Vector<D>; 2] {
    let flattest = (1..D).fold(0, |least, k| if n[k].abs() < n[least].abs() { k } else { least });
    let first: Vector<D> = std::array::from_fn(|k| f64::from(u8::from(k == flattest)) - n[flattest] * n[k]);
    let length = dot(&first, &first).sqrt();
    let first = first.map(|c| c / length);
    let turned = |k: usize| n[(k + 1) % D] * first[(k + 2) % D] - n[(k + 2) % D] * first[(k + 1) % D];
    [first, std::array::from_fn(turned)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::simplex::volume_and_gradients;

    #[test]
    fn the_layer_before_a_disc_is_a_prism_of_its_polygon() {
        let normal = [0.6, 0.0, 0.8];
        let disc = Shape { plane: Plane { point: [1.0, 2.0, 3.0], normal }, outline: Outline::Disc(0.5) };
        let layer: Body<3, 4> = disc.layer(0.1).unwrap();
        let volume: f64 = layer.cells.iter().map(|cell| volume_and_gradients(&layer.vertices(cell)).0).sum();
        // A polygon of 30 sides.
        let polygon = 15.0 * 0.25 * (PI / 15.0).sin();
        assert!((volume - 0.1 * polygon).abs() < 1e-12, "{volume}");
        let on_it = layer.place.iter().filter(|x| disc.holds(x, 0.0, 1e-9)).count();
        assert_eq!(2 * on_it, layer.place.len());
        assert!(layer.place.iter().all(|x| disc.holds(x, 0.1, 1e-9)));
    }
}
