//! A packed bed of spheres.

use super::{DragLaw, Fitted, Slip};

/// The pressure drop of a packed bed, shared among its grains.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ergun;

impl DragLaw for Ergun {
    const NAME: &'static str = "ergun";
    const FORMULA: &'static str = "β = 3π μ d·(150 (1 − n_f) + 1.75 Re)/(18 n_f), Re = n_f ρ d|u − v|/μ";
    const VALIDITY: &'static str =
        "packed beds, n_f < 0.8 (±15 %); it vanishes with the solid fraction at low Re: not for lone grains";
    const SOURCE: &'static str = "Ergun 1952, Chem. Eng. Prog. 48:89; model A as in Gidaspow 1994";
    const FITTED: Fitted = Fitted::Spheres;

    fn exchange_coefficient(&self, slip: &Slip) -> f64 {
        let solid_fraction = 1.0 - slip.void_fraction;
        let multiple =
            (150.0 * solid_fraction + 1.75 * slip.superficial_reynolds()) / (18.0 * slip.void_fraction);
        slip.stokes_coefficient() * multiple
    }
}
