//! What is tried: a case, how long it lasts, what a right answer keeps to.

use super::outcome::Expected;
use super::{fixed, plane, space};

/// How long trials last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Minutes.
    Quick,
    /// As long as it takes.
    Full,
}

/// What computes a trial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `pfem`, in so many dimensions.
    Moving(usize),
    /// `eulerian`, in so many dimensions.
    Fixed(usize),
}

/// A trial.
#[derive(Clone, Debug)]
pub struct Trial {
    /// What computes it.
    pub kind: Kind,
    /// The family.
    pub topic: &'static str,
    /// What is tried of it.
    pub what: String,
    /// Length of a window \[s\].
    pub window: f64,
    /// End \[s\].
    pub end: f64,
    /// What a right answer keeps to.
    pub expected: Expected,
    /// The tables of the case from `[fluid]` on.
    pub scene: String,
}

/// g (m/s²).
pub const GRAVITY: f64 = 9.81;

/// A rest that is exact but for the tolerance of the solver (m/s).
pub const AT_REST: f64 = 1e-8;

/// A speed that says no more than that the answer is bounded (m/s).
pub const MOVING: f64 = 20.0;

impl Trial {
    /// The case.
    pub fn case(&self) -> String {
        let Self { topic, what, window, end, scene, .. } = self;
        let (backend, dimension) = match self.kind {
            Kind::Moving(dimension) => ("pfem", dimension),
            Kind::Fixed(dimension) => ("eulerian", dimension),
        };
        let gravity = match dimension {
            2 => format!("[\"0 m/s^2\", \"-{GRAVITY} m/s^2\"]"),
            _ => format!("[\"0 m/s^2\", \"0 m/s^2\", \"-{GRAVITY} m/s^2\"]"),
        };
        format!(
            "[case]\ntitle = \"{topic}: {what}\"\ndimension = {dimension}\ngravity = {gravity}\n\
             [time]\nend = \"{end} s\"\nwindow = \"{window} s\"\n\
             [fluid]\nbackend = \"{backend}\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"1 mPa s\"\n{scene}"
        )
    }
}

/// All trials, in the order of the map.
pub fn trials(effort: Effort) -> Vec<Trial> {
    [plane::trials(effort), space::trials(effort), fixed::trials()].concat()
}
