//! A sphere alone, one formula up to the critical Reynolds number.

use super::{DragLaw, Fitted, Slip};

/// C_D = (24/Re)(1 + 0.1806 Re^0.6459) + 0.4251/(1 + 6880.95/Re), spheres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HaiderLevenspiel;

impl DragLaw for HaiderLevenspiel {
    const NAME: &'static str = "haider-levenspiel";
    const FORMULA: &'static str =
        "β = 3π μ d·C_D Re/24; C_D Re/24 = 1 + 0.1806 Re^0.6459 + (0.4251/24) Re²/(Re + 6880.95)";
    const VALIDITY: &'static str =
        "a sphere alone, Re < 2.6e5 (4–7 % of measurements); the void fraction does not enter";
    const SOURCE: &'static str = "Haider & Levenspiel 1989, Powder Technol. 58:63, spheres";
    const FITTED: Fitted = Fitted::Spheres;

    fn exchange_coefficient(&self, slip: &Slip) -> f64 {
        let re = slip.particle_reynolds();
        let viscous = 1.0 + 0.1806 * re.powf(0.6459);
        let inertial = 0.4251 / 24.0 * re * (re / (re + 6880.95));
        slip.stokes_coefficient() * (viscous + inertial)
    }
}
