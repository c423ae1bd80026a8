//! The force of the fluid's viscous stress on a grain that it passes undisturbed.

/// F = +V ∇·τ \[N\]; its reaction is what n_f ∇·τ of the model A fluid equations leaves out (Anderson & Jackson 1967).
pub fn viscous_stress_force(volume: f64, viscous_stress_divergence: [f64; 3]) -> [f64; 3] {
    viscous_stress_divergence.map(|divergence| volume * divergence)
}

#[cfg(test)]
mod tests {
    use super::super::pressure_gradient::pressure_gradient_force;
    use super::*;

    #[test]
    fn in_plane_poiseuille_flow_it_balances_the_pressure_gradient() {
        let (slope, volume) = (-3.5, 1e-9);
        let pressure = pressure_gradient_force(volume, [slope, 0.0, 0.0]);
        let viscous = viscous_stress_force(volume, [slope, 0.0, 0.0]);
        assert_eq!(pressure[0] + viscous[0], 0.0);
    }
}
