//! Spheres from alone to packed, one formula.

use super::{DragLaw, Fitted, Slip};

/// Dalla Valle's sphere at the superficial Reynolds number, times n_f^(1 − χ).
///
/// F = (ρ/8)π d² C_D(Re)|u − v|(u − v) n_f^(2−χ) in model A; χ = 3.7 − 0.65 exp(−(1.5 − log10 Re)²/2). In dense beds β
/// dips by up to 0.3 % as Re rises from 0.1 to 1; the force grows everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DiFelice;

/// χ \[-\], Di Felice's exponent; 3.7 at Re = 0 and at Re → ∞.
pub(super) fn voidage_exponent(reynolds: f64) -> f64 {
    let decades = 1.5 - reynolds.log10();
    3.7 - 0.65 * (-0.5 * decades * decades).exp()
}

/// C_D Re/24 \[-\] of Dalla Valle, C_D = (0.63 + 4.8/√Re)²; 0.96 at Re = 0.
fn stokes_multiple(reynolds: f64) -> f64 {
    (0.63 * reynolds.sqrt() + 4.8).powi(2) / 24.0
}

impl DragLaw for DiFelice {
    const NAME: &'static str = "di-felice";
    const FORMULA: &'static str = "β = 3π μ d·(C_D Re/24) n_f^(1−χ), C_D = (0.63 + 4.8/√Re)², \
         χ = 3.7 − 0.65 exp(−(1.5 − log10 Re)²/2), Re = n_f ρ d|u − v|/μ";
    const VALIDITY: &'static str =
        "spheres alone to packed, all Re below 2e5; a sphere alone is 4 % low at Re → 0";
    const SOURCE: &'static str = "Di Felice 1994, Int. J. Multiphase Flow 20:153; model A as in Kafui et al. 2002, Chem. Eng. Sci. 57:2395";
    const FITTED: Fitted = Fitted::Spheres;

    fn exchange_coefficient(&self, slip: &Slip) -> f64 {
        let re = slip.superficial_reynolds();
        slip.stokes_coefficient() * stokes_multiple(re) * slip.void_fraction.powf(1.0 - voidage_exponent(re))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The formula of the source: F = (ρ/8)π d² C_D |w|w n_f^(2−χ).
    #[test]
    fn the_regular_form_is_the_published_force() {
        let slip = Slip {
            speed: 0.37,
            diameter: 2.3e-3,
            volume: 6.4e-9,
            void_fraction: 0.62,
            density: 998.0,
            viscosity: 1.1e-3,
        };
        let re = 0.62 * 998.0 * 2.3e-3 * 0.37 / 1.1e-3_f64;
        let drag_coefficient = (0.63 + 4.8 / re.sqrt()).powi(2);
        let force = 998.0 / 8.0
            * std::f64::consts::PI
            * 2.3e-3
            * 2.3e-3
            * drag_coefficient
            * 0.37
            * 0.37
            * 0.62_f64.powf(2.0 - voidage_exponent(re));
        let ratio = DiFelice.exchange_coefficient(&slip) * slip.speed / force;
        assert!((ratio - 1.0).abs() < 1e-14, "{ratio}");
    }
}
