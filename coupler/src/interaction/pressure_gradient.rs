//! The force of the pressure gradient: buoyancy and more.

/// F = −V ∇p \[N\]; its reaction is what n_f ∇p of the model A fluid equations leaves out.
pub fn pressure_gradient_force(volume: f64, pressure_gradient: [f64; 3]) -> [f64; 3] {
    pressure_gradient.map(|slope| -volume * slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn in_still_water_it_is_the_weight_of_the_water_displaced() {
        let (density, gravity, volume) = (998.0, 9.81, 2.5e-9);
        let force = pressure_gradient_force(volume, [0.0, 0.0, -density * gravity]);
        assert_eq!(force, [-0.0, -0.0, volume * (density * gravity)]);
    }
}
