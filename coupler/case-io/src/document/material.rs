//! `[materials.*]` and `[pairs.*]`: what grains and walls are made of, and how two materials touch.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{Angle, Density, Pressure, SurfaceEnergy};

/// `[materials.NAME]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Material {
    /// Mass density.
    pub density: Density,
    /// Young's modulus E (needed where contacts are possible).
    pub youngs_modulus: Option<Pressure>,
    /// Poisson's ratio ν, in (-1, 0.5] (needed where contacts are possible).
    pub poissons_ratio: Option<f64>,
    /// Whether its grains are micro grains, which do not turn and bear no tangential force: the friction of its pairs
    /// must be 0.
    #[serde(default)]
    pub micro: bool,
}

/// `[pairs.NAME-NAME]`, the names in either order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Pair {
    /// Coefficient of restitution e, in (0, 1].
    pub restitution: f64,
    /// Coefficient of sliding friction μ, not negative.
    pub sliding_friction: f64,
    /// Coefficient of rolling friction μ_r, not negative (needed with `rolling-law`).
    pub rolling_friction: Option<f64>,
    /// Damping of rolling as a fraction of the critical one, not negative (needed with `rolling-law = "epsd"`).
    pub rolling_damping_ratio: Option<f64>,
    /// Cohesive energy per volume, not negative (needed with `cohesion-law = "sjkr"` and `"sjkr2"`).
    pub cohesion_energy_density: Option<Pressure>,
    /// Work of adhesion w, the energy that parting the two surfaces takes per area: twice the surface energy where they are
    /// alike; not negative (needed with `cohesion-law = "dmt"` and `"jkr"`).
    pub work_of_adhesion: Option<SurfaceEnergy>,
    /// Surface tension γ of the liquid, not negative (needed with `cohesion-law = "capillary"`).
    pub surface_tension: Option<SurfaceEnergy>,
    /// Contact angle θ of the liquid on the solids, from 0, less than 50° (needed with `cohesion-law = "capillary"`).
    pub contact_angle: Option<Angle>,
    /// Volume of a bridge of liquid over r³ of the smaller grain, more than 0, at most 0.1 (needed with
    /// `cohesion-law = "capillary"`).
    pub bridge_volume_ratio: Option<f64>,
}
