//! The interaction of a grain with the fluid, chosen once for a scene and evaluated grain by grain.

use std::array::from_fn;

use interface::frames::{GrainRow, HydroRow, SampleRow};

use super::added_mass::{added_mass, added_mass_force};
use super::drag::{Drag, Slip};
use super::pressure_gradient::pressure_gradient_force;
use super::self_disturbance::undisturbed;
use super::torque::{rotational_coefficient, viscous_torque};
use super::viscous_stress::viscous_stress_force;
use super::{InteractionError, Shape};

/// What of the fluid acts on the grains, as the case says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laws {
    /// Drag law.
    pub drag: Drag,
    /// Coefficient of added mass C_A \[-\]; 0 for none.
    pub added_mass: f64,
    /// Whether the drag is corrected for the grain's own disturbance; only where the fluid feels the grains.
    pub self_disturbance: bool,
}

/// Laws that fit the shape of the grains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interaction {
    laws: Laws,
    shape: Shape,
}

impl Interaction {
    /// The interaction by these laws with grains of this shape.
    ///
    /// # Errors
    /// A law fitted to another shape, a coefficient of added mass that is negative or not finite.
    pub fn new(laws: Laws, shape: Shape) -> Result<Self, InteractionError> {
        if !laws.drag.fitted().covers(shape) {
            return Err(InteractionError::LawOfOtherShape { law: laws.drag, shape });
        }
        if !(laws.added_mass >= 0.0 && laws.added_mass.is_finite()) {
            return Err(InteractionError::Coefficient {
                key: "coupling.added-mass",
                value: laws.added_mass,
                allowed: "0 or more (sphere 0.5, cylinder 1)",
            });
        }
        Ok(Self { laws, shape })
    }

    /// What the fluid does to a grain during a window of length Δt \[s\]: explicit force, torque, β, u_f, m_A.
    ///
    /// `owed` \[N s\] is what the fluid gave before this window and the grain has not received; it
    /// arrives as part of the explicit force. The slip is that of `grain.velocity`; `grain.angular_velocity` is that at the opening of the window. The parts of
    /// the grain's own force that −V∇p and +V∇·τ hold are taken out of β, where they are implicit and have a reaction.
    /// Of a grain in the free surface all is the wetted fraction. Outside the fluid (ρ = 0) nothing else acts. With the law `none` there is no viscous torque either.
    ///
    /// # Errors
    /// A sample out of range, a result that is not finite, a disturbance that is too large.
    pub fn evaluate(
        &self,
        grain: &GrainRow,
        sample: &SampleRow,
        owed: [f64; 3],
        window: f64,
    ) -> Result<HydroRow, InteractionError> {
        let delivered = owed.map(|impulse| impulse / window);
        if sample.density == 0.0 {
            return Ok(HydroRow { force: delivered, fluid_velocity: grain.velocity, ..HydroRow::default() });
        }
        check(grain, sample)?;
        let volume = self.shape.volume(grain.radius);
        let wetted_volume = sample.wetted_fraction * volume;
        let added_mass = added_mass(self.laws.added_mass, sample.density, wetted_volume);

        let inertial = added_mass_force(added_mass, sample.acceleration);
        let pressure = pressure_gradient_force(wetted_volume, sample.pressure_gradient);
        let viscous = viscous_stress_force(wetted_volume, sample.viscous_stress_divergence);

        let hydro = HydroRow {
            force: from_fn(|k| delivered[k] + inertial[k] + pressure[k] + viscous[k]),
            torque: self.torque(grain, sample, window),
            exchange_coefficient: sample.wetted_fraction
                * self.exchange_coefficient(grain, sample, volume)?,
            fluid_velocity: sample.velocity,
            added_mass,
        };
        finite(grain.id, &hydro)?;
        Ok(hydro)
    }

    fn exchange_coefficient(
        &self,
        grain: &GrainRow,
        sample: &SampleRow,
        volume: f64,
    ) -> Result<f64, InteractionError> {
        let diameter = 2.0 * grain.radius;
        let slip: [f64; 3] = from_fn(|k| sample.velocity[k] - grain.velocity[k]);
        let slip = Slip {
            speed: slip.iter().map(|component| component * component).sum::<f64>().sqrt(),
            diameter,
            volume,
            void_fraction: sample.void_fraction,
            density: sample.density,
            viscosity: sample.viscosity,
        };
        if !self.laws.self_disturbance || self.laws.drag == Drag::None {
            return Ok(self.laws.drag.exchange_coefficient(&slip));
        }
        let corrected =
            undisturbed(self.laws.drag, self.shape, diameter, slip.speed, sample).map_err(|too_large| {
                InteractionError::Disturbance {
                    grain: grain.id,
                    disturbance: too_large.0,
                    width_ratio: sample.kernel_width / diameter,
                    reynolds: slip.particle_reynolds(),
                }
            })?;
        let held_by_stress = corrected.own_pressure_part + corrected.own_viscous_part;
        Ok(corrected.exchange_coefficient * (1.0 - held_by_stress))
    }

    fn torque(&self, grain: &GrainRow, sample: &SampleRow, window: f64) -> [f64; 3] {
        if self.laws.drag == Drag::None {
            return [0.0; 3];
        }
        let whole = rotational_coefficient(self.shape, 2.0 * grain.radius, sample.viscosity);
        let coefficient = sample.wetted_fraction * whole;
        let inertia = self.shape.moment_of_inertia(grain.mass, grain.radius);
        viscous_torque(coefficient, sample.vorticity, grain.angular_velocity, inertia, window)
    }
}

/// Refuses inputs that no law is made for.
fn check(grain: &GrainRow, sample: &SampleRow) -> Result<(), InteractionError> {
    /// The fluid side's sums of weights may pass 1 by round-off.
    const ROUND_OFF: f64 = 1e-12;
    let finite_positive = |value: f64| value > 0.0 && value.is_finite();
    let (n_f, wetted) = (sample.void_fraction, sample.wetted_fraction);
    let inputs = [
        ("radius", grain.radius, finite_positive(grain.radius), "above 0, finite"),
        ("mass", grain.mass, grain.mass > 0.0, "above 0"),
        (
            "fluid density",
            sample.density,
            finite_positive(sample.density),
            "above 0, finite, or 0 outside the fluid",
        ),
        ("fluid viscosity", sample.viscosity, finite_positive(sample.viscosity), "above 0, finite"),
        ("void fraction", n_f, n_f > 0.0 && n_f <= 1.0 + ROUND_OFF, "above 0, at most 1"),
        ("wetted fraction", wetted, (0.0..=1.0).contains(&wetted), "0 to 1"),
        ("kernel width", sample.kernel_width, finite_positive(sample.kernel_width), "above 0, finite"),
        ("own share", sample.own_share, (0.0..1.0).contains(&sample.own_share), "from 0 to below 1"),
    ];
    match inputs.into_iter().find(|(_, _, allowed, _)| !allowed) {
        None => Ok(()),
        Some((quantity, value, _, allowed)) => Err(InteractionError::OutOfRange {
            grain: grain.id,
            quantity,
            value,
            allowed,
            advice: "resume from the last restart point with a shorter window, or refine the mesh",
        }),
    }
}

/// Refuses results that are not finite.
fn finite(grain: u64, hydro: &HydroRow) -> Result<(), InteractionError> {
    let results = [
        ("explicit fluid force", hydro.force.iter().sum()),
        ("fluid torque", hydro.torque.iter().sum()),
        ("exchange coefficient", hydro.exchange_coefficient),
        ("fluid velocity", hydro.fluid_velocity.iter().sum::<f64>()),
    ];
    match results.into_iter().find(|(_, value)| !value.is_finite()) {
        None => Ok(()),
        Some((quantity, value)) => Err(InteractionError::OutOfRange {
            grain,
            quantity,
            value,
            allowed: "finite numbers",
            advice: "resume from the last restart point with a shorter window",
        }),
    }
}
