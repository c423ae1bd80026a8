//! What came of a trial.

/// The worst that was seen in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// |V + drops − V₀|/V₀.
    pub volume_error: f64,
    /// E/E₀: kinetic and potential energy, heights as the case has them.
    pub energy_growth: f64,
    /// Largest speed at the end \[m/s\].
    pub speed: f64,
    /// Windows that had to be halved.
    pub halved: u32,
}

/// What ended a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// When \[s\].
    pub time: f64,
    /// What, where and what to do.
    pub message: String,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// At its end.
    Ran(Worst),
    /// By an error, after this.
    Stopped(Worst, Fault),
}

/// What a run is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Within the bounds of a right answer.
    Right,
    /// To the end, bounded, but outside of these.
    Stable,
    /// By an error that tells what, where and what to do.
    Stopped,
    /// Energy out of nothing, a number that is not finite, a refusal that was not due, or none where one was.
    Broken,
}

impl Verdict {
    /// The word of the table.
    pub fn word(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Stable => "stable",
            Self::Stopped => "stopped",
            Self::Broken => "BROKEN",
        }
    }
}

/// What a right answer keeps to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expected {
    /// It runs: the largest volume error, and the largest speed at the end \[m/s\] where the fluid should rest.
    Run {
        /// |V + drops − V₀|/V₀.
        volume_error: f64,
        /// Of the end \[m/s\].
        speed: f64,
    },
    /// It runs with fluid that enters or leaves, or that walls drive, whose energy is not its own: the largest volume error, and the
    /// largest speed at the end \[m/s\].
    Open {
        /// |V + drops − V₀|/V₀, of what passed the gates booked.
        volume_error: f64,
        /// Of the end \[m/s\].
        speed: f64,
    },
    /// It is refused with a message that contains this.
    Refusal(&'static str),
}

/// The energy of a right answer may exceed its start by this share: the tolerance of a run.
const GROWTH: f64 = 1e-4;
/// By more than this it comes out of nothing.
const OUT_OF_NOTHING: f64 = 1e-3;

impl Worst {
    /// Of a run that has not begun.
    pub const NONE: Self = Self { volume_error: 0.0, energy_growth: 1.0, speed: 0.0, halved: 0 };

    fn told(&self) -> String {
        let Self { volume_error, energy_growth, speed, halved } = self;
        format!(
            "volume error {volume_error:.1e}, E/E0 at most {energy_growth:.4}, speed at the end {speed:.1e} m/s, {halved} windows halved"
        )
    }
}

impl Fault {
    fn tells_where(&self) -> bool {
        self.message.contains(" at [")
    }
}

impl Outcome {
    /// Its worth.
    pub fn verdict(&self, expected: Expected) -> Verdict {
        match (self, expected) {
            (Self::Ran(worst), Expected::Run { volume_error, speed }) => {
                let Worst { volume_error: lost, energy_growth, speed: fast, .. } = *worst;
                // Negated: a number that is not finite is broken.
                if !(energy_growth <= 1.0 + OUT_OF_NOTHING && lost.is_finite() && fast.is_finite()) {
                    Verdict::Broken
                } else if energy_growth <= 1.0 + GROWTH && lost <= volume_error && fast <= speed {
                    Verdict::Right
                } else {
                    Verdict::Stable
                }
            }
            (Self::Ran(worst), Expected::Open { volume_error, speed }) => {
                if !(worst.volume_error.is_finite() && worst.speed.is_finite()) {
                    Verdict::Broken
                } else if worst.volume_error <= volume_error && worst.speed <= speed {
                    Verdict::Right
                } else {
                    Verdict::Stable
                }
            }
            (Self::Stopped(_, fault), Expected::Refusal(why)) if fault.message.contains(why) => {
                Verdict::Stopped
            }
            // Whoever asks for a run may be told that it cannot be had, if he is told where and why.
            (Self::Stopped(_, fault), Expected::Open { .. }) if fault.tells_where() => Verdict::Stopped,
            (Self::Stopped(worst, fault), Expected::Run { .. })
                if fault.tells_where() && worst.energy_growth <= 1.0 + OUT_OF_NOTHING =>
            {
                Verdict::Stopped
            }
            _ => Verdict::Broken,
        }
    }

    /// For the table.
    pub fn told(&self) -> String {
        match self {
            Self::Ran(worst) => worst.told(),
            Self::Stopped(worst, Fault { time, message }) if *time > 0.0 => {
                format!("at {time:.4} s: {message}; until then {}", worst.told())
            }
            Self::Stopped(_, Fault { message, .. }) => message.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WORST: Worst = Worst { volume_error: 1e-3, energy_growth: 1.0, speed: 0.5, halved: 2 };
    const RUN: Expected = Expected::Run { volume_error: 2e-3, speed: 1.0 };

    #[test]
    fn a_run_within_its_bounds_is_right_and_outside_of_them_stable() {
        assert_eq!(Outcome::Ran(WORST).verdict(RUN), Verdict::Right);
        assert_eq!(Outcome::Ran(Worst { volume_error: 3e-3, ..WORST }).verdict(RUN), Verdict::Stable);
        assert_eq!(Outcome::Ran(Worst { speed: 2.0, ..WORST }).verdict(RUN), Verdict::Stable);
        assert_eq!(Outcome::Ran(Worst { energy_growth: 1.0007, ..WORST }).verdict(RUN), Verdict::Stable);
    }

    #[test]
    fn energy_out_of_nothing_and_numbers_that_are_none_are_broken() {
        for growth in [1.002, f64::NAN, f64::INFINITY] {
            assert_eq!(Outcome::Ran(Worst { energy_growth: growth, ..WORST }).verdict(RUN), Verdict::Broken);
        }
        let open = Expected::Open { volume_error: 2e-3, speed: 1.0 };
        assert_eq!(Outcome::Ran(Worst { energy_growth: 9.0, ..WORST }).verdict(open), Verdict::Right);
        assert_eq!(Outcome::Ran(Worst { speed: 2.0, ..WORST }).verdict(open), Verdict::Stable);
        assert_eq!(Outcome::Ran(Worst { volume_error: f64::NAN, ..WORST }).verdict(open), Verdict::Broken);
    }

    #[test]
    fn a_run_that_stops_says_where_and_a_refusal_that_is_due_says_why() {
        let after = |worst: Worst, message: &str| {
            Outcome::Stopped(worst, Fault { time: 0.1, message: message.to_string() })
        };
        let stopped = |message: &str| after(WORST, message);
        let fault =
            "cell 3 at [0.1, 0.2] would be turned over, swollen or sheared too far in the step of 1e-9 s";
        assert_eq!(stopped(fault).verdict(RUN), Verdict::Stopped);
        assert_eq!(after(Worst { energy_growth: 1e12, ..WORST }, fault).verdict(RUN), Verdict::Broken);
        assert_eq!(stopped("no").verdict(RUN), Verdict::Broken);
        assert_eq!(stopped("two nodes are at").verdict(Expected::Refusal("two nodes")), Verdict::Stopped);
        assert_eq!(stopped("no").verdict(Expected::Refusal("two nodes")), Verdict::Broken);
        assert_eq!(Outcome::Ran(WORST).verdict(Expected::Refusal("two nodes")), Verdict::Broken);
    }
}
