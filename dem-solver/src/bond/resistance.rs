//! What bonds do to the longest stable step.

use std::iter::Sum;
use std::ops::Add;

use super::{Beam, Rigidity};

/// Bounds of the stiffness and the damping that a grain feels.
///
/// The energy of a bond is at most Σ κ (|u|² + I/m |θ|²) over its two ends, with a = s d the arm of an end and
///
/// κ = max(k_n, k_s (1 + m a²/I) + k_b m/I, k_t m/I),
///
/// as (x - y)² ≤ 2 x² + 2 y² for the two ends and by Cauchy's inequality for u and a θ. So ω² ≤ max_i Σ 2 κ/m_i; the
/// same holds of the damping.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Resistance {
    /// A = Σ 2 κ \[N/m\].
    pub stiffness: f64,
    /// B = Σ 2 κ of the dashpots \[N s/m\].
    pub damping: f64,
}

impl Resistance {
    /// That of one bond at its first (0) or second (1) end, of a grain with this m/I \[1/m²\].
    pub fn of(beam: &Beam, side: usize, mass_over_inertia: f64) -> Self {
        let arm = beam.shares[side] * beam.length;
        let leverage = 1.0 + mass_over_inertia * arm * arm;
        let bound = |k: &Rigidity| {
            let across = k.shear * leverage + k.bending * mass_over_inertia;
            2.0 * k.normal.max(across).max(k.twisting * mass_over_inertia)
        };
        Self { stiffness: bound(&beam.stiffness), damping: bound(&beam.damping) }
    }

    /// The longest step that is stable for a grain of this 1/m \[1/kg\] with dashpots that act on the velocities of the
    /// step before: A Δt² + 2 B Δt = 4 m; infinite where nothing resists.
    pub fn critical_step(&self, inverse_mass: f64) -> f64 {
        let (a, b) = (self.stiffness * inverse_mass, self.damping * inverse_mass);
        4.0 / (b + (b * b + 4.0 * a).sqrt())
    }
}

impl Add for Resistance {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { stiffness: self.stiffness + other.stiffness, damping: self.damping + other.damping }
    }
}

impl Sum for Resistance {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), Self::add)
    }
}
