//! `[[bond]]`: grains that are glued together at t = 0.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{Length, Pressure};

/// `[[bond]]`: bonds all pairs of grains that are near enough at t = 0; a pair is bonded by one table only.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Bond {
    /// Law of the bonds.
    pub law: BondLaw,
    /// Names of the insertions whose grains are bonded, with their like and with each other; default all of t = 0.
    pub insertions: Option<Vec<String>>,
    /// Largest gap between the surfaces of two grains that are bonded.
    pub gap: Length,
    /// Young's modulus of the bond.
    pub youngs_modulus: Pressure,
    /// Normal over shear stiffness (`parallel-bond` only).
    pub stiffness_ratio: Option<f64>,
    /// Radius of the bond over that of the smaller grain; default 1 (`parallel-bond` only).
    pub radius_multiplier: Option<f64>,
    /// Poisson's ratio, in (-1, 0.5] (`cohesive` only).
    pub poissons_ratio: Option<f64>,
    /// Area of the bond over that of a circle of the grains' harmonic mean radius; default 1 (`cohesive` only).
    pub area_factor: Option<f64>,
    /// How much compression raises the shear strength; default 0 (`cohesive` only).
    pub internal_friction: Option<f64>,
    /// Tensile stress at which it breaks; default it never does.
    pub tensile_strength: Option<Pressure>,
    /// Shear stress at which it breaks; default it never does.
    pub shear_strength: Option<Pressure>,
    /// Damping as a fraction of the critical one of a lone bonded pair; default 0.
    #[serde(default)]
    pub damping_ratio: f64,
}

/// Law of the bonds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BondLaw {
    /// An elastic beam of cement beside the contact, which bears tension, shear, bending and twist.
    ParallelBond,
    /// Springs in place of the contact, which bear tension and shear.
    Cohesive,
}
