//! Exact relaxation of a grain to the fluid in one substep.

/// m' dv/dt = F + β (u - v) with constant F, β, u over Δt, m' = m + m_A the inertia with added mass:
///
/// Δv = A Δt φ₁(x)/m',  v̄ = v + A Δt φ₂(x)/m',  A = F + β (u - v),  x = β Δt/m',
///
/// φ₁(x) = (1 - e^(-x))/x,  φ₂(x) = (1 - φ₁(x))/x,
///
/// where v̄ is the mean velocity of the substep. Stable for every x ≥ 0, exact for constant F, β and u.
///
/// Source: the exponential Euler method, Hochbruck & Ostermann, Acta Numerica 19 (2010) 209–286, Eq. 2.4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relaxation {
    /// Inertia m' = m + m_A \[kg\].
    pub inertia: f64,
    /// x = β Δt/m' \[-\].
    pub exponent: f64,
    /// Δt φ₁(x)/m' \[s/kg\].
    pub gain: f64,
    /// Δt φ₂(x)/m' \[s/kg\].
    pub lead: f64,
}

impl Relaxation {
    /// Relaxation over a substep \[s\] of a grain of this inertia \[kg\] at this exchange coefficient β \[kg/s\].
    pub fn new(inertia: f64, exchange_coefficient: f64, step: f64) -> Self {
        let exponent = exchange_coefficient * step / inertia;
        Self {
            inertia,
            exponent,
            gain: step / inertia * phi_1(exponent),
            lead: step / inertia * phi_2(exponent),
        }
    }
}

/// φ₁(x) = (1 - e^(-x))/x.
pub fn phi_1(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { -(-x).exp_m1() / x }
}

/// φ₂(x) = (1 - φ₁(x))/x = Σ (-x)^k/(k + 2)!.
pub fn phi_2(x: f64) -> f64 {
    const TERMS: u32 = 16;
    if x > 1.0 {
        return (1.0 - phi_1(x)) / x;
    }
    // Horner: 1/2 (1 - x/3 (1 - x/4 (1 - …))).
    0.5 * (3..TERMS + 3).rev().fold(1.0, |tail, k| 1.0 - x / f64::from(k) * tail)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phi_2_is_smooth_where_the_series_ends_and_right_at_both_ends() {
        let (below, above) = (phi_2(1.0), phi_2(1.0 + 1e-15));
        assert!((below - above).abs() < 1e-15 && (below - (-1.0_f64).exp()).abs() < 1e-15);
        assert_eq!(phi_2(0.0), 0.5);
        assert!((phi_2(1e-9) - (0.5 - 1e-9 / 6.0)).abs() < 1e-16);
        assert!((phi_2(1e8) * 1e8 - 1.0).abs() < 2e-8);
    }

    #[test]
    fn momentum_is_split_between_drag_and_other_forces_for_any_exponent() {
        // φ₁ = 1 - x φ₂ is Δv m' = J + F Δt in units of A Δt.
        for x in [0.0, 1e-12, 1e-3, 0.5, 0.999, 1.001, 7.0, 300.0] {
            assert!((phi_1(x) - (1.0 - x * phi_2(x))).abs() < 3e-16, "x = {x}");
        }
    }
}
