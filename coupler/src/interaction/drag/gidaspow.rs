//! Packed and dilute spheres, switched.

use super::{DragLaw, Ergun, Fitted, Slip, WenYu};

/// Void fraction from which the suspension counts as dilute.
const DILUTE: f64 = 0.8;

/// Ergun below n_f = 0.8, Wen & Yu from there (β jumps by 20–40 %, and more at high Re).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gidaspow;

impl DragLaw for Gidaspow {
    const NAME: &'static str = "gidaspow";
    const FORMULA: &'static str = "β of ergun for n_f < 0.8, of wen-yu for n_f ≥ 0.8";
    const VALIDITY: &'static str = "beds that fluidise, Re < 1e4; β is discontinuous at n_f = 0.8";
    const SOURCE: &'static str = "Gidaspow 1994, Multiphase Flow and Fluidization, Academic Press";
    const FITTED: Fitted = Fitted::Spheres;

    fn exchange_coefficient(&self, slip: &Slip) -> f64 {
        if slip.void_fraction < DILUTE {
            Ergun.exchange_coefficient(slip)
        } else {
            WenYu.exchange_coefficient(slip)
        }
    }
}
