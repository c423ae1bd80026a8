//! How viscous the fluid is at a rate of shear.

mod around_grain;
mod herschel_bulkley;
mod newtonian;

pub use herschel_bulkley::HerschelBulkley;
pub use newtonian::Newtonian;

/// A law of viscosity.
pub trait Law {
    /// μ (Pa s) at γ̇ = √(2 ε:ε) (1/s), ε being the symmetric part of ∇v.
    fn viscosity(&self, shear_rate: f64) -> f64;

    /// −γ̇ dμ/dγ̇ (Pa s): μ of what is purely plastic, 0 where one viscosity holds.
    fn softening(&self, shear_rate: f64) -> f64;
}

/// The laws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rheology {
    /// One viscosity.
    Newtonian(Newtonian),
    /// A yield stress, and a power of the rate of shear above it.
    HerschelBulkley(HerschelBulkley),
}

impl Rheology {
    /// Whether the viscosity is the same at every rate of shear.
    pub fn is_newtonian(&self) -> bool {
        matches!(self, Self::Newtonian(_))
    }
}

impl Law for Rheology {
    fn viscosity(&self, shear_rate: f64) -> f64 {
        match self {
            Self::Newtonian(law) => law.viscosity(shear_rate),
            Self::HerschelBulkley(law) => law.viscosity(shear_rate),
        }
    }

    fn softening(&self, shear_rate: f64) -> f64 {
        match self {
            Self::Newtonian(law) => law.softening(shear_rate),
            Self::HerschelBulkley(law) => law.softening(shear_rate),
        }
    }
}
