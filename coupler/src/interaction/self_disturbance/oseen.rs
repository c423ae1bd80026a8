//! Oseen flow of a smeared point force: what a grain's own force does to the fluid sampled at the grain.
//!
//! A force −F is spread by a Gaussian of standard deviation σ and the velocity is sampled back with the same Gaussian,
//! in a stream of speed U_e; R = ρ U_e σ/μ. The sampled velocity changes by −s F.
//!
//! The fluid's kernel (1 − r²/11σ²)³₊ has 0.969 (R = 0) to 0.921 (R → ∞) of the Gaussian's mobility; linear elements of size
//! h = σ add about 0.03 at R = 0 and hide this, those of h ≪ σ do not (`cases/settling-sphere-periodic`).

use std::f64::consts::PI;

use crate::interaction::Shape;

/// Mobility s \[m/(N s)\]; the depth is a disc's.
///
/// 3D: Ψ(R)/(6π^{3/2} μ σ). 2D: I(R)/(2π μ·depth), infinite at R = 0 (Stokes' paradox).
pub fn mobility(shape: Shape, reynolds: f64, kernel_width: f64, viscosity: f64) -> f64 {
    match shape {
        Shape::Sphere => sphere_mobility(reynolds) / (6.0 * PI.powf(1.5) * viscosity * kernel_width),
        Shape::Disc { depth } => disc_mobility(reynolds) / (2.0 * PI * viscosity * depth),
    }
}

/// Parts of the grain's own force that come back to it, times its own share of the solid fraction, in −V∇p and in
/// +V∇·τ \[-\]: 1/3 and (2/3)Ψ₂ in 3D, 1/2 and (1/2)Ψ₂ in 2D.
pub fn own_stress(shape: Shape, reynolds: f64) -> (f64, f64) {
    match shape {
        Shape::Sphere => (1.0 / 3.0, 2.0 / 3.0 * sphere_viscous_stress(reynolds)),
        Shape::Disc { .. } => (0.5, 0.5 * disc_viscous_stress(reynolds)),
    }
}

/// Ψ(R) = (3/√π)∫e^−k² \[(1 + k²/R²)(k/R) atan(R/k) − k²/R²\] dk \[-\], fitted to 0.15 %.
fn sphere_mobility(r: f64) -> f64 {
    1.0 / (1.0 + r * (2.0 / 3.0 + 0.376 * r) / (1.0 + r / 2.0))
}

/// Ψ₂(R) = (6/√π)∫k² e^−k² \[(1 + k²/R²)(k/R) atan(R/k) − k²/R²\] dk \[-\], fitted to 4 %.
fn sphere_viscous_stress(r: f64) -> f64 {
    1.0 / (1.0 + 0.376 * r * r / (1.3 + r))
}

/// I(R) = ∫e^−k² (√(1 + R²/k²) − 1) k/R² dk \[-\], fitted to 0.1 %; exact limits ½ ln(2e^{(1−γ)/2}/R) and √π/(2R).
fn disc_mobility(r: f64) -> f64 {
    0.5 * ((2.470_88 + 1.22 * PI.sqrt() * r) / (r * (1.0 + 1.22 * r))).ln_1p()
}

/// Ψ₂(R) = 4∫k³ e^−k² (√(1 + R²/k²) − 1)/R² dk \[-\], fitted to 1 %; exact limits 1 and √π/R.
fn disc_viscous_stress(r: f64) -> f64 {
    1.0 / (1.0 + r * r / (PI.sqrt() * (0.55 + r)))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// ∫₀^∞ f dk by the trapezoidal rule in ln k, which converges exponentially for these integrands.
    fn integral(f: impl Fn(f64) -> f64) -> f64 {
        const STEPS: i32 = 4000;
        const STEP: f64 = 0.01;
        (0..STEPS).map(|i| (1.5 - f64::from(i) * STEP).exp()).map(|k| f(k) * k * STEP).sum()
    }

    /// Mean over directions of sin²θ/(1 + a²cos²θ) on the sphere, a = R/k, and on the circle.
    fn sphere_mean(a: f64) -> f64 {
        if a < 1e-2 {
            2.0 / 3.0 - 2.0 / 15.0 * a * a
        } else {
            (1.0 + 1.0 / (a * a)) * a.atan() / a - 1.0 / (a * a)
        }
    }

    fn circle_mean(a: f64) -> f64 {
        1.0 / ((1.0 + a * a).sqrt() + 1.0)
    }

    /// Ψ(R) by quadrature.
    pub fn exact_sphere_mobility(r: f64) -> f64 {
        3.0 / PI.sqrt() * integral(|k| (-k * k).exp() * sphere_mean(r / k))
    }

    fn largest_misfit(fit: fn(f64) -> f64, exact: impl Fn(f64) -> f64) -> f64 {
        (-30..=40)
            .map(|i| 10.0_f64.powf(f64::from(i) / 10.0))
            .map(|r| (fit(r) / exact(r) - 1.0).abs())
            .fold(0.0, f64::max)
    }

    #[test]
    fn the_integral_has_the_four_known_values() {
        for (r, psi) in [(0.1, 0.93732), (1.0, 0.59028), (10.0, 0.11919), (100.0, 0.01314)] {
            assert!((exact_sphere_mobility(r) - psi).abs() < 6e-6, "{r}: {}", exact_sphere_mobility(r));
        }
    }

    #[test]
    fn fits_follow_their_integrals() {
        let sphere_viscous =
            |r: f64| 6.0 / PI.sqrt() * integral(|k| k * k * (-k * k).exp() * sphere_mean(r / k));
        let disc = |r: f64| integral(|k| (-k * k).exp() * circle_mean(r / k) / k);
        let disc_viscous = |r: f64| 4.0 * integral(|k| k * (-k * k).exp() * circle_mean(r / k));
        for (name, misfit, allowed) in [
            ("Ψ", largest_misfit(sphere_mobility, exact_sphere_mobility), 1.5e-3),
            ("Ψ₂", largest_misfit(sphere_viscous_stress, sphere_viscous), 3.7e-2),
            ("I", largest_misfit(disc_mobility, disc), 1e-3),
            ("disc Ψ₂", largest_misfit(disc_viscous_stress, disc_viscous), 1e-2),
        ] {
            assert!(misfit < allowed, "{name}: {misfit}");
        }
    }

    /// ∇·σ = force density in Stokes flow: all of the grain's smeared force comes back as V∇·σ.
    #[test]
    fn in_creeping_flow_the_whole_own_force_comes_back_as_stress() {
        for shape in [Shape::Sphere, Shape::Disc { depth: 2.0 }] {
            let (pressure, viscous) = own_stress(shape, 0.0);
            assert!((pressure + viscous - 1.0).abs() < 1e-15);
        }
    }

    /// u_s/U = d f Ψ/(2√π σ), f = F/(3π μ d U).
    #[test]
    fn a_sphere_in_creeping_flow_drags_the_sampled_fluid_by_28_percent_at_kernel_width_d() {
        let (diameter, viscosity) = (2e-3, 1e-3);
        let share = mobility(Shape::Sphere, 0.0, diameter, viscosity) * 3.0 * PI * viscosity * diameter;
        assert!((share - 0.5 / PI.sqrt()).abs() < 1e-15, "{share}");
    }
}
