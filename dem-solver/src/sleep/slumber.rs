//! How much was slept.

use std::ops::AddAssign;

/// What sleep saved and what it took, since t = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slumber {
    /// How often a grain fell asleep.
    pub fallings: u64,
    /// How often a grain woke.
    pub wakings: u64,
    /// Steps of grains that slept.
    pub grain_steps: u64,
    /// Those of them in which the forces of their chunk were not found either.
    pub grain_steps_without_forces: u64,
    /// Kinetic energy that falling asleep took \[J\].
    pub energy: f64,
}

impl AddAssign for Slumber {
    fn add_assign(&mut self, other: Self) {
        let Self { fallings, wakings, grain_steps, grain_steps_without_forces, energy } = other;
        self.fallings += fallings;
        self.wakings += wakings;
        self.grain_steps += grain_steps;
        self.grain_steps_without_forces += grain_steps_without_forces;
        self.energy += energy;
    }
}
