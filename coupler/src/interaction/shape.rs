//! The two shapes of a grain.

use std::f64::consts::PI;
use std::fmt;

/// Shape of the grains of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Spheres, in three dimensions.
    Sphere,
    /// Discs of a two-dimensional slab.
    Disc {
        /// Depth of the slab = length of every disc \[m\].
        depth: f64,
    },
}

impl Shape {
    /// Volume \[m³\]: 4/3 π r³ of a sphere, π r²·depth of a disc.
    pub fn volume(self, radius: f64) -> f64 {
        match self {
            Shape::Sphere => 4.0 / 3.0 * PI * radius * radius * radius,
            Shape::Disc { depth } => PI * radius * radius * depth,
        }
    }

    /// Moment of inertia about the centre (of a disc: about its axis) \[kg m²\]: 2/5 m r² or 1/2 m r².
    pub fn moment_of_inertia(self, mass: f64, radius: f64) -> f64 {
        let factor = match self {
            Shape::Sphere => 0.4,
            Shape::Disc { .. } => 0.5,
        };
        factor * mass * radius * radius
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Shape::Sphere => "spheres (3D)",
            Shape::Disc { .. } => "discs (2D)",
        })
    }
}
