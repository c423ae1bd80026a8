//! What a drag law is.

use std::fmt;

use super::Slip;
use crate::interaction::Shape;

/// A drag law: the exchange coefficient β of F = β(u − v).
///
/// F is the drag of the **pressure-split (model A)** equations: each grain also feels −V∇p + V∇·τ. u − v is the
/// interstitial slip. Laws are pure: no clamp and no hidden constant; where C_D → ∞ at zero slip, they are written in
/// the regular product C_D·Re, so that the limit is taken in closed form.
pub trait DragLaw {
    /// The user's key.
    const NAME: &'static str;
    /// β in symbols; Re = n_f ρ d|u − v|/μ for laws of suspensions, ρ d|u − v|/μ for laws of a single grain.
    const FORMULA: &'static str;
    /// Where the law was fitted or derived.
    const VALIDITY: &'static str;
    /// Where it is published.
    const SOURCE: &'static str;
    /// The grains that it was fitted to.
    const FITTED: Fitted;

    /// β \[kg/s\] at a slip.
    fn exchange_coefficient(&self, slip: &Slip) -> f64;
}

/// The grains that a law was fitted to; it is refused for others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fitted {
    /// Spheres and discs alike.
    AnyGrain,
    /// Spheres (3D).
    Spheres,
    /// Cylinders across the flow: the discs of a 2D slab.
    Cylinders,
}

impl Fitted {
    /// Whether grains of this shape are covered.
    pub fn covers(self, shape: Shape) -> bool {
        match self {
            Fitted::AnyGrain => true,
            Fitted::Spheres => matches!(shape, Shape::Sphere),
            Fitted::Cylinders => matches!(shape, Shape::Disc { .. }),
        }
    }
}

impl fmt::Display for Fitted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Fitted::AnyGrain => "any grain",
            Fitted::Spheres => "spheres (3D)",
            Fitted::Cylinders => "cylinders across the flow (2D)",
        })
    }
}

/// A law as `coupler explain` prints it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Explanation {
    /// The user's key.
    pub name: &'static str,
    /// The law in symbols.
    pub formula: &'static str,
    /// The grains that it was fitted to.
    pub fitted: Fitted,
    /// Where it holds.
    pub validity: &'static str,
    /// Where it is published.
    pub source: &'static str,
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.name)?;
        writeln!(f, "  formula   {}", self.formula)?;
        writeln!(f, "  fitted to {}", self.fitted)?;
        writeln!(f, "  validity  {}", self.validity)?;
        write!(f, "  source    {}", self.source)
    }
}
