//! Cylinders across the flow from alone to packed: the discs of a 2D slab.

use std::f64::consts::PI;

use super::{DragLaw, Fitted, Slip, di_felice::voidage_exponent};

/// A cylinder across the flow at the superficial Reynolds number, times Di Felice's n_f^(1−χ).
///
/// C_D is on the projected area d × depth. White's C_D = 1 + 10 Re^(−2/3) holds from Re of about 1; towards Re = 0 the
/// drag is Oseen's: C_D Re = 8π(Δ − 0.87Δ³), 1/Δ = ln(8/Re) + 1/2 − γ = 2.002 − ln Re, of which the first term is Lamb's.
/// Lamb's term alone lies 14 % above White's curve at Re = 1, so that a switch there would let the drag fall as the
/// slip grows; with Kaplun's second term the two curves meet, at Re = 0.382, and β is continuous. At Re = 0 there is no
/// Stokes drag of a cylinder (Stokes' paradox): β → 0, as 1/ln(1/Re).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DiFeliceCylinder;

/// Reynolds number where Kaplun's and White's curves meet.
const MEETING: f64 = 0.382_320_643_967_051_5;

/// Euler's constant γ.
const EULER_GAMMA: f64 = 0.577_215_664_901_532_9;

/// C_D Re \[-\] of a cylinder alone; 0 at Re = 0.
fn drag_reynolds(reynolds: f64) -> f64 {
    if reynolds < MEETING {
        let delta = 1.0 / (8.0_f64.ln() - reynolds.ln() + 0.5 - EULER_GAMMA);
        8.0 * PI * (delta - 0.87 * delta.powi(3))
    } else {
        reynolds + 10.0 * reynolds.cbrt()
    }
}

impl DragLaw for DiFeliceCylinder {
    const NAME: &'static str = "di-felice-cylinder";
    const FORMULA: &'static str = "β = (μ·depth/2)·C_D Re·n_f^(1−χ), C_D = 1 + 10 Re^(−2/3) for Re > 0.382, else \
         C_D Re = 8π(Δ − 0.87Δ³), Δ = 1/(2.002 − ln Re); χ of di-felice, Re = n_f ρ d|u − v|/μ";
    const VALIDITY: &'static str =
        "discs of a 2D slab, Re < 2e5 (10–20 %); the voidage factor is the spheres'";
    const SOURCE: &'static str = "White 1991, Viscous Fluid Flow, 2nd ed., §3-11; Lamb 1911, Phil. Mag. 21:112; \
         Kaplun 1957, J. Math. Mech. 6:595; Di Felice 1994, Int. J. Multiphase Flow 20:153";
    const FITTED: Fitted = Fitted::Cylinders;

    fn exchange_coefficient(&self, slip: &Slip) -> f64 {
        let re = slip.superficial_reynolds();
        let voidage = slip.void_fraction.powf(1.0 - voidage_exponent(re));
        0.5 * slip.viscosity * slip.disc_length() * drag_reynolds(re) * voidage
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_curves_meet() {
        let below = drag_reynolds(MEETING.next_down());
        let above = drag_reynolds(MEETING);
        assert!((below / above - 1.0).abs() < 1e-14, "{below} {above}");
    }

    #[test]
    fn lambs_drag_is_the_limit_of_slow_flow() {
        let reynolds = 1e-30_f64;
        let lamb = 8.0 * PI / (2.002 - reynolds.ln());
        assert!((drag_reynolds(reynolds) / lamb - 1.0).abs() < 2e-4);
    }

    /// Balance of (ρ_p − ρ)g π d²/4 with ρ d C_D v²/2: d = 2 mm, ρ_p = 3000 kg/m³ in water, White's C_D.
    #[test]
    fn a_cylinder_of_two_millimetres_falls_at_0_23_metres_per_second() {
        let depth = 0.7;
        let slip = Slip {
            speed: 0.229_727_47,
            diameter: 2e-3,
            volume: PI * 1e-6 * depth,
            void_fraction: 1.0,
            density: 1000.0,
            viscosity: 1e-3,
        };
        let weight = 2000.0 * 9.81 * slip.volume;
        let drag = DiFeliceCylinder.exchange_coefficient(&slip) * slip.speed;
        assert!((drag / weight - 1.0).abs() < 1e-7, "{drag} {weight}");
    }
}
