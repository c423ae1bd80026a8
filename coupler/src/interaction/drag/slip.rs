//! What a drag law sees of a grain and the fluid around it.

use std::f64::consts::PI;

/// A grain in a slipping fluid.
///
/// | symbol | field | unit |
/// |---|---|---|
/// | \|u − v\| | `speed`, interstitial | m/s |
/// | d | `diameter` | m |
/// | V | `volume`; π d²/6·d of a sphere, π d²/4·depth of a disc | m³ |
/// | n_f | `void_fraction`, in (0, 1] | – |
/// | ρ | `density` of the fluid | kg/m³ |
/// | μ | `viscosity` of the fluid, > 0 | Pa s |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip {
    /// Slip speed |u − v| \[m/s\], interstitial.
    pub speed: f64,
    /// Diameter d \[m\].
    pub diameter: f64,
    /// Volume V \[m³\].
    pub volume: f64,
    /// Void fraction n_f \[-\].
    pub void_fraction: f64,
    /// Fluid density ρ \[kg/m³\].
    pub density: f64,
    /// Fluid viscosity μ \[Pa s\].
    pub viscosity: f64,
}

impl Slip {
    /// Reynolds number of a grain alone, ρ d|u − v|/μ.
    pub fn particle_reynolds(&self) -> f64 {
        self.density * self.diameter * self.speed / self.viscosity
    }

    /// Reynolds number on the superficial velocity, n_f ρ d|u − v|/μ.
    pub fn superficial_reynolds(&self) -> f64 {
        self.void_fraction * self.particle_reynolds()
    }

    /// Exchange coefficient of a sphere alone in creeping flow, 3π μ d \[kg/s\] (Stokes 1851).
    pub fn stokes_coefficient(&self) -> f64 {
        3.0 * PI * self.viscosity * self.diameter
    }

    /// Length of a disc along its axis, V/(π d²/4) \[m\].
    pub fn disc_length(&self) -> f64 {
        self.volume / (0.25 * PI * self.diameter * self.diameter)
    }
}
