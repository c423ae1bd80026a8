//! What came of a trial.

/// The worst that was seen in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Worst {
    /// |V + drops − V₀|/V₀.
    pub volume_error: f64,
    /// E/E₀, energies above that of the fluid poured out flat at the lowest place.
    pub energy_growth: f64,
    /// Largest speed at the end \[m/s\].
    pub speed: f64,
    /// Windows that had to be halved.
    pub halved: u32,
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// At its end.
    Ran(Worst),
    /// By an error, at this time \[s\].
    Stopped(f64, String),
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
    /// It runs with fluid that enters or leaves, whose energy is not its own: the largest volume error.
    Open {
        /// |V + drops − V₀|/V₀, of what passed the gates booked.
        volume_error: f64,
    },
    /// It is refused with a message that contains this.
    Refusal(&'static str),
}

/// Energy may exceed its start by this share: the round-off and tolerance of a run.
const GROWTH: f64 = 1e-3;

impl Outcome {
    /// Its worth.
    pub fn verdict(&self, expected: Expected) -> Verdict {
        match (self, expected) {
            (Self::Ran(worst), Expected::Run { volume_error, speed }) => {
                let Worst { volume_error: lost, energy_growth, speed: fast, .. } = *worst;
                // Negated: a number that is not finite is broken.
                if !(energy_growth <= 1.0 + GROWTH && lost.is_finite() && fast.is_finite()) {
                    Verdict::Broken
                } else if lost <= volume_error && fast <= speed {
                    Verdict::Right
                } else {
                    Verdict::Stable
                }
            }
            (Self::Ran(worst), Expected::Open { volume_error }) => {
                if !(worst.volume_error.is_finite() && worst.speed.is_finite()) {
                    Verdict::Broken
                } else if worst.volume_error <= volume_error {
                    Verdict::Right
                } else {
                    Verdict::Stable
                }
            }
            (Self::Stopped(_, message), Expected::Refusal(why)) if message.contains(why) => Verdict::Stopped,
            // Whoever asks for a run may be told that it cannot be had, if he is told why.
            (Self::Stopped(_, message), Expected::Run { .. } | Expected::Open { .. })
                if message.contains("element") =>
            {
                Verdict::Stopped
            }
            _ => Verdict::Broken,
        }
    }

    /// For the table.
    pub fn told(&self) -> String {
        match self {
            Self::Ran(Worst { volume_error, energy_growth, speed, halved }) => format!(
                "volume error {volume_error:.1e}, E/E0 at most {energy_growth:.4}, speed at the end {speed:.1e} m/s, {halved} windows halved"
            ),
            Self::Stopped(time, message) => format!("at {time:.4} s: {message}"),
        }
    }
}
