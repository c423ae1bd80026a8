//! What a grain does to the fluid, once it has moved through the window.

use interface::frames::{GrainRow, HydroRow, ImpulseRow, ReactionRow, SampleRow};

use super::Shape;
use super::exchange::{
    effective_exchange_coefficient, impulse_taken, kept_share, target_velocity_from_impulse,
};

/// A grain's passage through a window of length Δt.
#[derive(Clone, Copy, Debug)]
pub struct Passage<'a> {
    /// The grain when the window opened.
    pub before: &'a GrainRow,
    /// The same grain at the end of the window.
    pub after: &'a GrainRow,
    /// The fluid that it was given.
    pub sample: &'a SampleRow,
    /// What the fluid was said to do to it.
    pub hydro: &'a HydroRow,
    /// What it received.
    pub impulse: &'a ImpulseRow,
}

/// The reaction F − β_e(u − v*) on the fluid over a window \[s\] of a grain that keeps to its motion.
///
/// The fluid gets −X, X = J + m_A(Du/Dt Δt − Δv), as long as it keeps the velocity that the grain felt, and resists change
/// as the grain does. The reactions to −V∇p and +V∇·τ are in the model A equations of the fluid, so F = 0. What the grain has not felt of the window's end
/// is owed to it.
pub fn reaction(passage: &Passage<'_>, window: f64) -> ReactionRow {
    let Passage { before, after, sample, hydro, impulse } = passage;
    let change = std::array::from_fn(|k| after.velocity[k] - before.velocity[k]);
    let taken = impulse_taken(impulse.drag, hydro.added_mass, sample.acceleration, change, window);
    let (added_mass, exchange_coefficient) = (hydro.added_mass, hydro.exchange_coefficient);
    let coefficient = effective_exchange_coefficient(before.mass, added_mass, exchange_coefficient, window);
    ReactionRow {
        force: [0.0; 3],
        exchange_coefficient: coefficient,
        added_mass: hydro.added_mass,
        target_velocity: target_velocity_from_impulse(hydro.fluid_velocity, taken, coefficient, window),
        ..ReactionRow::default()
    }
}

/// The same of a grain that gives way to the change of the fluid in the step, where no iteration tells it of it: of a force
/// on it the grain keeps a [share](kept_share) and hands on the rest, so R = V(1 − share).
///
/// It felt u of the start and Du/Dt: its added mass is at u + Du/Dt Δt already, and resists what differs from that. So
/// v* = u + m_A/(m_A + βΔt) Du/Dt Δt − X/(β_e Δt).
pub fn compliant_reaction(passage: &Passage<'_>, shape: Shape, window: f64) -> ReactionRow {
    let Passage { before, sample, hydro, .. } = passage;
    let kept = kept_share(before.mass, hydro.added_mass, hydro.exchange_coefficient, window);
    let resisting = hydro.added_mass + hydro.exchange_coefficient * window;
    let ahead = if resisting > 0.0 { hydro.added_mass / resisting * window } else { 0.0 };
    let plain = reaction(passage, window);
    ReactionRow {
        target_velocity: std::array::from_fn(|k| plain.target_velocity[k] + ahead * sample.acceleration[k]),
        relayed_volume: sample.wetted_fraction * shape.volume(before.radius) * (1.0 - kept),
        inverse_mass: 1.0 / before.mass,
        ..plain
    }
}
