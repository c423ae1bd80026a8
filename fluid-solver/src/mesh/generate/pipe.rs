//! Round pipes, straight and bent.

use super::disc::Disc;
use super::{assemble, at_least, count_points, positive};
use crate::element::simplex::Vector;
use crate::mesh::{Mesh, MeshError};
use std::f64::consts::PI;

/// A straight round pipe along z from the origin; boundaries `inlet` (z = 0), `outlet` and `wall`.
///
/// The section is a polygon of `6 rings` corners on the circle, so its area is `3 rings sin(π/(3 rings)) R²`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pipe {
    /// Radius R (m).
    pub radius: f64,
    /// Length (m).
    pub length: f64,
    /// Rings of cells from the axis to the wall.
    pub rings: usize,
    /// Layers of cells along the axis.
    pub layers: usize,
}

impl Pipe {
    /// Generates the mesh.
    ///
    /// # Errors
    /// A length that is not positive, a count of zero, or too many points.
    pub fn generate(&self) -> Result<Mesh<3, 4>, MeshError> {
        const NAME: &str = "pipe";
        positive(NAME, "length", self.length)?;
        at_least(NAME, "layers", 1, self.layers, "at least 1")?;
        let height = |layer: usize| self.length * layer as f64 / self.layers as f64;
        sweep(NAME, self.radius, self.rings, self.layers, |layer, [u, v]| [u, v, height(layer)])
    }
}

/// A round pipe with an elbow: a straight leg along z from the origin, a bend towards +x, and a straight leg;
/// boundaries `inlet` (z = 0), `outlet` and `wall`.
///
/// The elbow is a chain of straight-sided wedges; its volume is `A R_b n sin(θ/n)` with the section's area A.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentPipe {
    /// Radius of the section (m).
    pub radius: f64,
    /// Rings of cells from the axis to the wall.
    pub rings: usize,
    /// Radius R_b of the bend of the axis (m), larger than the section's.
    pub bend_radius: f64,
    /// Angle θ of the bend (rad), 0 to π.
    pub angle: f64,
    /// Lengths of the legs before and after the bend (m).
    pub legs: [f64; 2],
    /// Layers of cells along the first leg, the bend n, and the second leg.
    pub layers: [usize; 3],
}

impl BentPipe {
    /// Generates the mesh.
    ///
    /// # Errors
    /// A length that is not positive, a count of zero, a bend tighter than the pipe, or too many points.
    pub fn generate(&self) -> Result<Mesh<3, 4>, MeshError> {
        const NAME: &str = "bent pipe";
        positive(NAME, "legs", self.legs[0])?;
        positive(NAME, "legs", self.legs[1])?;
        for layers in self.layers {
            at_least(NAME, "layers", 1, layers, "at least 1 in every part")?;
        }
        let refuse = |key, found: f64, allowed| {
            Err(MeshError::Generator { generator: NAME, key, found: found.to_string(), allowed })
        };
        if !(self.angle > 0.0 && self.angle <= PI) {
            return refuse("angle", self.angle, "above 0, up to π");
        }
        if self.angle / self.layers[1] as f64 > PI / 4.0 {
            return refuse("layers", self.layers[1] as f64, "a layer of the bend for every 45° of it");
        }
        if !(self.bend_radius > self.radius && self.bend_radius.is_finite()) {
            return refuse("bend radius", self.bend_radius, "larger than the pipe's radius");
        }
        let layers = self.layers.iter().sum();
        sweep(NAME, self.radius, self.rings, layers, |layer, section| self.place(layer, section))
    }

    /// Where the point `[u, v]` of the section lies in a layer.
    fn place(&self, layer: usize, [u, v]: Vector<2>) -> Vector<3> {
        let [before, bend, after] = self.layers;
        let part = |done: usize, of: usize| done as f64 / of as f64;
        let along_first = self.legs[0] * part(layer.min(before), before);
        let turned = self.angle * part(layer.saturating_sub(before).min(bend), bend);
        let along_second = self.legs[1] * part(layer.saturating_sub(before + bend), after);
        let (sine, cosine) = turned.sin_cos();
        let from_centre = self.bend_radius - u;
        [
            self.bend_radius - from_centre * cosine + along_second * sine,
            v,
            along_first + from_centre * sine + along_second * cosine,
        ]
    }
}

fn sweep(
    generator: &'static str,
    radius: f64,
    rings: usize,
    layers: usize,
    place: impl Fn(usize, Vector<2>) -> Vector<3>,
) -> Result<Mesh<3, 4>, MeshError> {
    positive(generator, "radius", radius)?;
    at_least(generator, "rings", 1, rings, "at least 1")?;
    let section = Disc::node_count(rings).unwrap_or(usize::MAX);
    count_points(generator, &[section, layers.saturating_add(1)])?;
    let disc = Disc::new(radius, rings);
    let copies = (0..=layers).flat_map(|layer| disc.points.iter().map(move |&point| (layer, point)));
    let points: Vec<Vector<3>> = copies.map(|(layer, point)| place(layer, point)).collect();
    let cells = disc.sweep(&points);
    let groups = ["inlet", "outlet", "wall"].map(String::from).to_vec();
    let (first_of_last, copy) = (layers * section, section);
    assemble(points, cells, groups, Vec::new(), |face| {
        if face.iter().all(|&point| (point as usize) < copy) {
            Some(0)
        } else if face.iter().all(|&point| point as usize >= first_of_last) {
            Some(1)
        } else {
            face.iter().all(|&point| point as usize % copy >= disc.rim).then_some(2)
        }
    })
}
