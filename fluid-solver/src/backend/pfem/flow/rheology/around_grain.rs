//! How viscous the fluid is around a grain, which shears it on a scale that the cells do not see.

use super::{Law, Rheology};

/// c in γ̇ = U/(c d), of discs and spheres.
///
/// A sphere in Stokes' law at τ_y/γ̇ then has 3πc τ_y d² in the limit U → 0, which is the 3.50 π d²τ_y that holds it: it stays
/// where τ_y ≥ 0.143 F/(2π(d/2)²) (0.0477 Δρ g d under its own weight). No law of a cylinder has a Stokes limit: with 6.4 the drag
/// of a disc at ρU²/(cτ_y) = 10⁻² is the 11.94 τ_y d per length that holds it, and within a factor of 1.7 of that down to 10⁻⁴.
///
/// Source: Beris, Tsamopoulos, Armstrong and Brown, *J. Fluid Mech.* 158 (1985) 219; Randolph and Houlsby, *Géotechnique* 34
/// (1984) 613.
const REACH: [f64; 2] = [6.4, 1.1655];

impl Rheology {
    /// μ(γ̇) (Pa s) of a fluid sheared at some rate (1/s) that a grain of diameter d (m) slips through at U (m/s):
    /// γ̇² = `shear_rate`² + (U/(c d))².
    pub fn around_grain<const D: usize>(&self, shear_rate: f64, slip: f64, diameter: f64) -> f64 {
        self.viscosity(shear_rate.hypot(slip / (REACH[D - 2] * diameter)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::HerschelBulkley;
    use super::*;
    use std::f64::consts::PI;

    const MUD: Rheology = Rheology::HerschelBulkley(HerschelBulkley {
        consistency: 2.0,
        exponent: 1.0,
        yield_stress: 30.0,
        creep_rate: 1e-6,
    });
    const DIAMETER: f64 = 0.01;

    /// Stokes' drag (N).
    fn drag(shear_rate: f64, slip: f64) -> f64 {
        3.0 * PI * MUD.around_grain::<3>(shear_rate, slip, DIAMETER) * DIAMETER * slip
    }

    #[test]
    fn a_sphere_meets_the_plastic_limit_and_stokes_drag_in_sum() {
        // Beris et al.: 2τ_y π(d/2)²/F = 0.143.
        let held = 2.0 * 30.0 * PI * 0.25 * DIAMETER * DIAMETER / 0.143;
        assert!((drag(0.0, 1e-6) / held - 1.0).abs() < 1e-3, "{}", drag(0.0, 1e-6) / held);
        let stokes = 3.0 * PI * 2.0 * DIAMETER * 0.5;
        assert!((drag(0.0, 0.5) / (held + stokes) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn a_sphere_sinks_through_mud_that_is_sheared_however_light_it_is() {
        let resting = drag(0.0, 1e-5);
        assert!(drag(1.0, 1e-5) < 2e-3 * resting);
    }
}
