//! Yield stress and power law, regularised.

use super::Law;

/// μ = K (γ̇² + γ̇₀²)^{(n−1)/2} + τ_y (1 − exp(−γ̇/γ̇₀))/γ̇; n = 1 is a Bingham fluid of plastic viscosity K.
///
/// Below γ̇₀ the fluid creeps at the viscosity τ_y/γ̇₀ instead of standing still: what is arrested moves at rates of the
/// order of γ̇₀ τ/τ_y.
///
/// Source: Papanastasiou, *J. Rheology* 31 (1987) 385.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HerschelBulkley {
    /// K (Pa sⁿ).
    pub consistency: f64,
    /// n (-).
    pub exponent: f64,
    /// τ_y (Pa).
    pub yield_stress: f64,
    /// γ̇₀ (1/s).
    pub creep_rate: f64,
}

impl HerschelBulkley {
    /// K (γ̇² + γ̇₀²)^{(n−1)/2} and τ_y (1 − exp(−γ̇/γ̇₀))/γ̇ (Pa s).
    fn parts(&self, shear_rate: f64) -> (f64, f64) {
        let Self { consistency, exponent, yield_stress, creep_rate } = *self;
        let ratio = shear_rate / creep_rate;
        // (1 − exp(−x))/x → 1.
        let arrest = if ratio > 0.0 { -(-ratio).exp_m1() / ratio } else { 1.0 };
        let power = (shear_rate * shear_rate + creep_rate * creep_rate).powf(0.5 * (exponent - 1.0));
        (consistency * power, yield_stress / creep_rate * arrest)
    }
}

impl Law for HerschelBulkley {
    fn viscosity(&self, shear_rate: f64) -> f64 {
        let (viscous, plastic) = self.parts(shear_rate);
        viscous + plastic
    }

    fn softening(&self, shear_rate: f64) -> f64 {
        let Self { exponent, yield_stress, creep_rate, .. } = *self;
        let (viscous, plastic) = self.parts(shear_rate);
        let square = shear_rate * shear_rate;
        let thinning = (1.0 - exponent) * square / (square + creep_rate * creep_rate);
        viscous * thinning + plastic - yield_stress / creep_rate * (-shear_rate / creep_rate).exp()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MUD: HerschelBulkley =
        HerschelBulkley { consistency: 2.0, exponent: 0.5, yield_stress: 30.0, creep_rate: 1e-4 };

    #[test]
    fn far_above_the_creep_the_stress_is_that_of_the_law() {
        let stress = MUD.viscosity(4.0) * 4.0;
        assert!((stress - (30.0 + 2.0 * 4f64.sqrt())).abs() < 1e-7, "{stress}");
    }

    #[test]
    fn at_rest_the_viscosity_is_the_largest_and_finite() {
        let rest = MUD.viscosity(0.0);
        assert!((rest - (30.0 / 1e-4 + 2.0 / 1e-4f64.sqrt())).abs() < 1e-6 * rest);
        assert!(MUD.viscosity(1e-6) < rest && (MUD.viscosity(1e-12) / rest - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_softening_is_the_slope_of_the_viscosity() {
        for rate in [1e-6, 1e-4, 1e-2, 1.0] {
            let step = 1e-4 * rate;
            let slope = (MUD.viscosity(rate + step) - MUD.viscosity(rate - step)) / (2.0 * step);
            let found = MUD.softening(rate);
            assert!((found + rate * slope).abs() <= 1e-6 * MUD.viscosity(rate), "{rate}: {found}");
        }
    }

    #[test]
    fn with_an_exponent_of_one_it_is_a_bingham_fluid() {
        let bingham = HerschelBulkley { exponent: 1.0, ..MUD };
        assert!((bingham.viscosity(3.0) - (2.0 + 10.0)).abs() < 1e-10);
    }
}
