//! `[grains]`: the side of the grains; present, a dem-solver runs.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::{Length, Velocity, Viscosity};
use super::sleep::Sleep;
use super::vector::{Axis, Bounds};

/// `[grains]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Grains {
    /// Law of the normal contact force.
    pub normal_law: NormalLaw,
    /// Velocity from which the stiffness of a linear law is found (`hooke` and `liggghts-hooke` only).
    pub characteristic_velocity: Option<Velocity>,
    /// Law of the tangential contact force (`hooke`, `hertz` and `onate` only); default `coulomb`.
    pub tangential_law: Option<TangentialLaw>,
    /// Effective area of a contact over that of a circle of the grains' geometric mean radius; default 1 (`onate` only).
    pub area_factor: Option<f64>,
    /// Law of the torque that resists rolling; default: nothing does.
    pub rolling_law: Option<RollingLaw>,
    /// Law of the torque that resists twisting, spin about the normal; default: nothing does (3D).
    pub twisting_law: Option<TwistingLaw>,
    /// Liquid that is squeezed out from between bodies; default: there is none (3D).
    pub lubrication: Option<Lubrication>,
    /// Law of the attraction of bodies that touch or have touched; default: they do not cohere.
    pub cohesion_law: Option<CohesionLaw>,
    /// Where grains may be; default: the box around the fluid mesh, the walls and the insertions.
    pub domain: Option<Bounds>,
    /// What happens when a grain leaves the domain.
    #[serde(default)]
    pub escape: Escape,
    /// Axes of the domain that wrap.
    #[serde(default)]
    pub periodic: Vec<Axis>,
    /// Deepest overlap at the start, of grains and with walls, as a fraction of the diameter.
    #[serde(default = "default_start_overlap")]
    pub start_overlap: f64,
    /// When idle grains sleep; default: none does.
    pub sleep: Option<Sleep>,
}

fn default_start_overlap() -> f64 {
    0.01
}

/// Law of the normal contact force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum NormalLaw {
    /// Linear spring and dashpot.
    Hooke,
    /// Hertz's force with a dashpot that gives the stated restitution.
    Hertz,
    /// Linear contact as stiff as a bar between the centres, of Oñate and co-workers, with a dashpot that gives the stated
    /// restitution.
    Onate,
    /// LIGGGHTS 3.8.0, `model hooke tangential history` (3D).
    LiggghtsHooke,
    /// LIGGGHTS 3.8.0, `model hertz tangential history` (3D).
    LiggghtsHertz,
    /// No contact at all.
    None,
}

/// Law of the tangential contact force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TangentialLaw {
    /// Spring and dashpot up to Coulomb's limit: the whole contact sticks or slips.
    Coulomb,
    /// Mindlin & Deresiewicz's contact, which slips from its edge inwards (with `hertz`, 3D).
    PartialSlip,
}

/// Law of the torque that resists rolling, as LIGGGHTS 3.8.0 has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RollingLaw {
    /// Constant torque against the relative spin.
    Cdt,
    /// Elastic–plastic spring and dashpot.
    Epsd,
    /// Elastic–plastic spring as stiff as the tangential one.
    Epsd2,
}

/// Law of the torque that resists twisting.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TwistingLaw {
    /// The tangential spring, dashpot and limit spread over the area of contact (Marshall 2009).
    Marshall,
}

/// `[grains.lubrication]`: a force 6 π μ R*² v_n/h against coming nearer and parting, at gaps h below the cut-off.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Lubrication {
    /// Dynamic viscosity μ of the liquid.
    pub viscosity: Viscosity,
    /// Gap below which the force grows no more: the height of the roughness of the grains.
    pub roughness: Length,
    /// Gap from which on there is no force.
    pub cut_off: Length,
}

/// Law of the attraction of bodies that touch or have touched (3D).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CohesionLaw {
    /// LIGGGHTS 3.8.0: energy density times the area where the bodies cut each other.
    Sjkr,
    /// LIGGGHTS 3.8.0: energy density times an area that grows with the overlap.
    Sjkr2,
    /// Derjaguin, Muller & Toporov: 2 π w R* as long as they touch; small, hard grains.
    Dmt,
    /// Johnson, Kendall & Roberts: a neck that is drawn out beyond touch and tears; large, soft grains (with `"hertz"` and
    /// `"liggghts-hertz"` only).
    Jkr,
    /// A bridge of liquid that forms at touch and lasts until it ruptures (Willett et al. 2000).
    Capillary,
}

/// What happens when a grain leaves the domain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Escape {
    /// The run stops.
    #[default]
    Stop,
    /// The grain is removed and counted in the ledger.
    Remove,
}
