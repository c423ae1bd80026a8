//! A dilute suspension of spheres.

use super::{DragLaw, Fitted, Slip, schiller_naumann};

/// Schiller & Naumann's sphere at the superficial Reynolds number, times n_f^−2.65.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WenYu;

impl DragLaw for WenYu {
    const NAME: &'static str = "wen-yu";
    const FORMULA: &'static str =
        "β = 3π μ d·(C_D Re/24) n_f^−2.65; C_D of Schiller & Naumann at Re = n_f ρ d|u − v|/μ";
    const VALIDITY: &'static str = "fluidised spheres, n_f > 0.8 (used down to 0.4), Re < 1e4";
    const SOURCE: &'static str =
        "Wen & Yu 1966, Chem. Eng. Prog. Symp. Ser. 62:100; model A as in Gidaspow 1994";
    const FITTED: Fitted = Fitted::Spheres;

    fn exchange_coefficient(&self, slip: &Slip) -> f64 {
        let multiple = schiller_naumann::stokes_multiple(slip.superficial_reynolds());
        slip.stokes_coefficient() * multiple * slip.void_fraction.powf(-2.65)
    }
}
