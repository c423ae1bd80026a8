//! How quiet a chunk is.

/// For how long all grains of a chunk have been slow, or that they sleep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quiet {
    /// Quiet time \[s\]; infinite asleep.
    quiet: f64,
}

impl Quiet {
    /// Asleep.
    pub const ASLEEP: Self = Self { quiet: f64::INFINITY };

    /// Awake, and quiet for this time \[s\]; nothing if that is no time.
    pub fn of_time(quiet: f64) -> Option<Self> {
        (quiet >= 0.0).then_some(Self { quiet })
    }

    /// Quiet time \[s\]; infinite asleep.
    pub fn time(self) -> f64 {
        self.quiet
    }

    /// Whether the grains sleep.
    pub fn is_asleep(self) -> bool {
        self.quiet.is_infinite()
    }

    /// That of two parts together.
    pub fn joined(self, other: Self) -> Self {
        Self { quiet: self.quiet.min(other.quiet) }
    }

    /// A step \[s\] later, in which all grains were slow or not.
    pub fn after(self, slow: bool, step: f64) -> Self {
        if slow { Self { quiet: self.quiet + step } } else { Self::default() }
    }
}

impl Default for Quiet {
    /// Awake.
    fn default() -> Self {
        Self { quiet: 0.0 }
    }
}
