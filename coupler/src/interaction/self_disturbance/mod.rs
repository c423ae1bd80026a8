//! A grain's own disturbance: the fluid sampled at a grain has already been dragged along by that grain.
//!
//! Drag laws ask for the slip against the undisturbed fluid, u_und = u_smp + s F. With F = β(u_und − v) this is
//! F = β'(u_smp − v), **β' = β/(1 − sβ)**, at the slip U = |u_smp − v|/(1 − sβ) (three Picard passes). Three more own
//! parts are taken out: from the void fraction, n_f = n_f,smp + χ φ_own; from −V∇p and +V∇·τ, which hold
//! φ_own·(1/3 + 2Ψ₂/3) F of the grain's own force.
//!
//! In a crowd the laws are fitted to the mean, disturbed, flow: everything is faded by χ = exp(−N_o), N_o the number of
//! other grains inside the kernel. The speed in s is U_e = U/4 + ¾|u_smp − v|. The correction is that of steady flow: it
//! overshoots while a grain has moved for less than 5 min(σ²/ν, σ/U). Compare Horwitz & Mani 2016, J. Comput. Phys. 318:85;
//! Ireland & Desjardins 2017, J. Comput. Phys. 338:405.

#[cfg(test)]
mod lattice;
mod oseen;

use std::f64::consts::PI;

use interface::frames::SampleRow;

use super::Shape;
use super::drag::{Drag, Slip};

/// Picard passes on the slip.
const PASSES: usize = 3;

/// Largest s β that is corrected; above, the sample says too little about the undisturbed flow.
pub const LARGEST_DISTURBANCE: f64 = 0.5;

/// The interaction of a grain with the fluid as it would be without that grain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Undisturbed {
    /// β' \[kg/s\]: the drag is β'(u_smp − v).
    pub exchange_coefficient: f64,
    /// Void fraction that the law was evaluated with \[-\].
    pub void_fraction: f64,
    /// Slip speed against the undisturbed fluid \[m/s\].
    pub slip_speed: f64,
    /// χ s β \[-\]: the part of the undisturbed slip that the sample has lost.
    pub disturbance: f64,
    /// Part of the drag that −V∇p already holds \[-\].
    pub own_pressure_part: f64,
    /// Part of the drag that +V∇·τ already holds \[-\].
    pub own_viscous_part: f64,
}

/// The disturbance is too large to be corrected: its χ s β, not a number if an input was not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooLarge(pub f64);

/// β' and what goes with it, for a grain of this shape and diameter \[m\] at a sampled slip speed |u_smp − v| \[m/s\].
///
/// Discs at rest: the disturbance tends to all of the slip as Re → 0 (Stokes' paradox), so that a lone disc below
/// Re of about 1 (kernel width d) or 0.2 (2 d) is refused.
///
/// # Errors
/// [`TooLarge`] where χ s β exceeds [`LARGEST_DISTURBANCE`].
pub fn undisturbed(
    drag: Drag,
    shape: Shape,
    diameter: f64,
    slip_speed: f64,
    sample: &SampleRow,
) -> Result<Undisturbed, TooLarge> {
    let volume = shape.volume(0.5 * diameter);
    let fading = (-others_in_kernel(shape, volume, sample)).exp();
    let own_share = fading * sample.own_share;
    let void_fraction = sample.void_fraction + own_share;
    let kernel_reynolds = |speed: f64| {
        let effective = 0.25 * speed + 0.75 * slip_speed;
        sample.density * effective * sample.kernel_width / sample.viscosity
    };

    // Of a disc at rest β = 0 and s = ∞, with a finite product: the limit is taken at the smallest speed there is.
    let mut speed = slip_speed.max(f64::MIN_POSITIVE);
    let mut coefficient = 0.0;
    let mut disturbance = 0.0;
    for _ in 0..PASSES {
        coefficient = drag.exchange_coefficient(&Slip {
            speed,
            diameter,
            volume,
            void_fraction,
            density: sample.density,
            viscosity: sample.viscosity,
        });
        let mobility = oseen::mobility(shape, kernel_reynolds(speed), sample.kernel_width, sample.viscosity);
        disturbance = fading * mobility * coefficient;
        let corrigible = disturbance <= LARGEST_DISTURBANCE;
        if !corrigible {
            return Err(TooLarge(disturbance));
        }
        speed = slip_speed.max(f64::MIN_POSITIVE) / (1.0 - disturbance);
    }

    let (pressure, viscous) = oseen::own_stress(shape, kernel_reynolds(speed));
    Ok(Undisturbed {
        exchange_coefficient: coefficient / (1.0 - disturbance),
        void_fraction,
        slip_speed: speed,
        disturbance,
        own_pressure_part: own_share * pressure,
        own_viscous_part: own_share * viscous,
    })
}

/// N_o = (1 − n_f,smp − φ_own)(4π)^{D/2} σ^D/V \[-\]: grains inside the kernel, without the one at its centre.
fn others_in_kernel(shape: Shape, volume: f64, sample: &SampleRow) -> f64 {
    let width = sample.kernel_width;
    let kernel_volume = match shape {
        Shape::Sphere => (4.0 * PI).powf(1.5) * width * width * width,
        Shape::Disc { depth } => 4.0 * PI * width * width * depth,
    };
    (1.0 - sample.void_fraction - sample.own_share) * kernel_volume / volume
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Water around a lone grain of diameter 1 mm, kernel a Gaussian: φ_own = V/((4π)^{D/2} σ^D).
    fn alone(shape: Shape, width: f64) -> SampleRow {
        let mut sample = SampleRow {
            density: 1000.0,
            viscosity: 1e-3,
            kernel_width: width,
            void_fraction: 1.0,
            ..SampleRow::default()
        };
        let volume = shape.volume(0.5e-3);
        sample.own_share =
            1.0 / (others_in_kernel(shape, volume, &SampleRow { void_fraction: 0.0, ..sample }));
        sample.void_fraction = 1.0 - sample.own_share;
        sample
    }

    /// The sample that a lone grain leaves: u_smp − v = U − s F at F = β(U)U, s at U_e; β at n_f = 1.
    fn lone_sphere_at(reynolds: f64, width: f64) -> (f64, f64, SampleRow) {
        let sample = alone(Shape::Sphere, width);
        let slip = reynolds * 1e-3 / (1000.0 * 1e-3);
        let force = slip
            * Drag::WenYu.exchange_coefficient(&Slip {
                speed: slip,
                diameter: 1e-3,
                volume: Shape::Sphere.volume(0.5e-3),
                void_fraction: 1.0,
                density: 1000.0,
                viscosity: 1e-3,
            });
        let mut sampled = slip;
        for _ in 0..200 {
            let kernel_reynolds = 1000.0 * (0.25 * slip + 0.75 * sampled) * width / 1e-3;
            sampled = slip - oseen::mobility(Shape::Sphere, kernel_reynolds, width, 1e-3) * force;
        }
        (sampled, force, sample)
    }

    #[test]
    fn a_lone_sphere_gets_the_drag_of_the_undisturbed_stream() {
        let mut worst: f64 = 0.0;
        for reynolds in [1e-6, 0.1, 1.0, 10.0, 150.0] {
            for width in [1e-3, 2e-3, 4.2e-3] {
                let (sampled, force, sample) = lone_sphere_at(reynolds, width);
                let found = undisturbed(Drag::WenYu, Shape::Sphere, 1e-3, sampled, &sample).unwrap();
                assert!((found.void_fraction - 1.0).abs() < 1e-15);
                worst = worst.max((found.exchange_coefficient * sampled / force - 1.0).abs());
            }
        }
        assert!(worst < 1e-6, "three passes leave {worst}");
    }

    #[test]
    fn the_disturbance_at_kernel_width_d_falls_from_27_to_1_4_percent() {
        for (reynolds, percent) in [(0.1, 27.0), (10.0, 5.8), (150.0, 1.4)] {
            let (sampled, _, sample) = lone_sphere_at(reynolds, 1e-3);
            let found = undisturbed(Drag::WenYu, Shape::Sphere, 1e-3, sampled, &sample).unwrap();
            let lost = 100.0 * found.disturbance;
            assert!((lost - percent).abs() < 0.06 * percent, "Re = {reynolds}: {lost} %");
        }
    }

    #[test]
    fn in_a_crowd_the_law_is_left_alone() {
        let own = alone(Shape::Sphere, 1e-3);
        let crowd = SampleRow { void_fraction: 0.6, ..own };
        let slip = Slip {
            speed: 0.01,
            diameter: 1e-3,
            volume: Shape::Sphere.volume(0.5e-3),
            void_fraction: 0.6,
            density: 1000.0,
            viscosity: 1e-3,
        };
        let found = undisturbed(Drag::Gidaspow, Shape::Sphere, 1e-3, 0.01, &crowd).unwrap();
        let mean = Drag::Gidaspow.exchange_coefficient(&slip);
        assert!((found.exchange_coefficient / mean - 1.0).abs() < 1e-9, "{found:?}");
        assert!(found.own_pressure_part < 1e-9);
    }

    #[test]
    fn the_fading_of_a_tenth_of_solids_is_2e_minus_4() {
        let own = alone(Shape::Sphere, 1e-3);
        let sample = SampleRow { void_fraction: 0.9 - own.own_share, ..own };
        let fading = (-others_in_kernel(Shape::Sphere, Shape::Sphere.volume(0.5e-3), &sample)).exp();
        assert!((1.5e-4..2.5e-4).contains(&fading), "{fading}");
    }

    #[test]
    fn a_kernel_narrower_than_the_grain_is_refused() {
        let found = undisturbed(Drag::Stokes, Shape::Sphere, 1e-3, 1e-6, &alone(Shape::Sphere, 0.5e-3));
        assert!(matches!(found, Err(TooLarge(share)) if share > 0.5 && share < 0.6), "{found:?}");
    }

    #[test]
    fn a_disc_is_corrected_at_re_10_and_refused_at_rest_unless_in_a_crowd() {
        let shape = Shape::Disc { depth: 0.3 };
        let lone = alone(shape, 1e-3);
        let found = undisturbed(Drag::DiFeliceCylinder, shape, 1e-3, 1e-2, &lone).unwrap();
        assert!((0.1..0.3).contains(&found.disturbance), "{found:?}");
        let at_rest = undisturbed(Drag::DiFeliceCylinder, shape, 1e-3, 0.0, &lone);
        assert!(matches!(at_rest, Err(TooLarge(share)) if share > 0.9), "{at_rest:?}");
        let packed = SampleRow { void_fraction: 0.2, ..lone };
        let bed = undisturbed(Drag::DiFeliceCylinder, shape, 1e-3, 0.0, &packed).unwrap();
        assert!(bed.disturbance < 0.01 && bed.exchange_coefficient >= 0.0, "{bed:?}");
    }

    #[test]
    fn what_is_not_a_number_is_refused() {
        let sample = SampleRow { viscosity: f64::NAN, ..alone(Shape::Sphere, 1e-3) };
        assert!(undisturbed(Drag::WenYu, Shape::Sphere, 1e-3, 0.1, &sample).is_err());
    }
}
