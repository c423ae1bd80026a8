//! Added mass: the fluid that a grain has to accelerate with itself.
//!
//! m_A dv/dt goes on the grain's inertia (left side) and m_A Du/Dt is a force. The pressure-gradient and viscous-stress
//! forces already hold ρ V(Du/Dt − g), so the factor here is C_A, not 1 + C_A (Maxey & Riley 1983, eq. 47).

/// m_A = C_A ρ V \[kg\]; C_A = 1/2 for a sphere, 1 for a cylinder across its axis.
pub fn added_mass(coefficient: f64, density: f64, volume: f64) -> f64 {
    coefficient * density * volume
}

/// F = m_A Du/Dt \[N\].
pub fn added_mass_force(added_mass: f64, fluid_acceleration: [f64; 3]) -> [f64; 3] {
    fluid_acceleration.map(|acceleration| added_mass * acceleration)
}

#[cfg(test)]
mod tests {
    use super::super::pressure_gradient::pressure_gradient_force;
    use super::*;

    /// Inviscid fluid, −∇p = ρ Du/Dt: dv/dt = 3/(1 + 2 ρ_p/ρ) Du/Dt.
    #[test]
    fn a_sphere_in_an_accelerated_inviscid_fluid_follows_by_three_over_one_plus_two_rho() {
        let (density, volume, acceleration) = (1000.0, 3e-9, [2.0, -1.0, 0.5]);
        let inertia = added_mass(0.5, density, volume);
        for ratio in [0.01, 1.0, 2.5] {
            let pressure = pressure_gradient_force(volume, acceleration.map(|a| -density * a));
            let force = added_mass_force(inertia, acceleration);
            for k in 0..3 {
                let found = (pressure[k] + force[k]) / (ratio * density * volume + inertia);
                let exact = 3.0 / (1.0 + 2.0 * ratio) * acceleration[k];
                assert!((found / exact - 1.0).abs() < 1e-14, "{found} {exact}");
            }
        }
    }
}
