//! The verdict on an iteration, from all measures.

use super::{Change, ForceResidual, Measure, RelativeNorm};

/// What to do after an iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Every residual is within its tolerance: commit.
    Converged,
    /// Some residual is not: iterate.
    Continue,
    /// A residual is not finite, or has grown by [`Judge::GROWTH`] over the window's smallest: halve the window, or stop.
    Diverged,
}

/// Changes in parts of what is tolerated \[-\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residuals {
    /// Of the fluid's velocity.
    pub velocity: f64,
    /// Of the pressure.
    pub pressure: f64,
    /// Of the forces on the grains.
    pub force: f64,
}

impl Residuals {
    /// The largest; not a number if one is not.
    pub fn largest(&self) -> f64 {
        let all = [self.velocity, self.pressure, self.force];
        if all.iter().any(|residual| residual.is_nan()) {
            f64::NAN
        } else {
            all.into_iter().fold(0.0, f64::max)
        }
    }
}

/// The measures of a run, and the best that the open window has reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judge {
    velocity: RelativeNorm,
    pressure: RelativeNorm,
    force: ForceResidual,
    smallest: f64,
}

impl Judge {
    /// Growth over the smallest residual of the window that counts as divergence \[-\]. Accelerated iterations may grow
    /// for a while, by a factor of the order of the amplification that they fight.
    pub const GROWTH: f64 = 1e3;

    /// A judge by these measures.
    pub fn new(velocity: RelativeNorm, pressure: RelativeNorm, force: ForceResidual) -> Self {
        Self { velocity, pressure, force, smallest: f64::INFINITY }
    }

    /// A window opens: forgets the one before.
    pub fn open(&mut self) {
        self.smallest = f64::INFINITY;
    }

    /// The verdict on an iteration of the open window, and the residuals that it rests on.
    pub fn judge(&mut self, velocity: &Change, pressure: &Change, force: &Change) -> (Verdict, Residuals) {
        let residuals = Residuals {
            velocity: self.velocity.residual(velocity),
            pressure: self.pressure.residual(pressure),
            force: self.force.residual(force),
        };
        let largest = residuals.largest();
        self.smallest = self.smallest.min(largest);
        let verdict = if !largest.is_finite() {
            Verdict::Diverged
        } else if largest <= 1.0 {
            Verdict::Converged
        } else if largest > Self::GROWTH * self.smallest {
            Verdict::Diverged
        } else {
            Verdict::Continue
        };
        (verdict, residuals)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STILL: Change = Change { change: 0.0, reference: 0.0 };

    fn judge() -> Judge {
        let norm = RelativeNorm { tolerance: 1e-3, floor: 1e-9 };
        Judge::new(norm, norm, ForceResidual { tolerance: 1e-3, floor: 1e-15 })
    }

    fn moved(change: f64) -> Change {
        Change { change, reference: 1.0 }
    }

    #[test]
    fn one_quantity_that_still_changes_keeps_the_window_open() {
        let mut judge = judge();
        assert_eq!(judge.judge(&STILL, &STILL, &STILL).0, Verdict::Converged);
        for [velocity, pressure, force] in
            [[moved(2e-3), STILL, STILL], [STILL, moved(2e-3), STILL], [STILL, STILL, moved(2e-3)]]
        {
            judge.open();
            assert_eq!(judge.judge(&velocity, &pressure, &force).0, Verdict::Continue);
        }
    }

    #[test]
    fn growth_beyond_the_bound_is_divergence_in_this_window_only() {
        let mut judge = judge();
        assert_eq!(judge.judge(&moved(0.01), &STILL, &STILL).0, Verdict::Continue);
        assert_eq!(judge.judge(&moved(9.0), &STILL, &STILL).0, Verdict::Continue);
        assert_eq!(judge.judge(&moved(11.0), &STILL, &STILL).0, Verdict::Diverged);
        judge.open();
        assert_eq!(judge.judge(&moved(11.0), &STILL, &STILL).0, Verdict::Continue);
    }

    #[test]
    fn what_is_not_finite_is_divergence_at_once() {
        for bad in [f64::NAN, f64::INFINITY] {
            assert_eq!(judge().judge(&STILL, &moved(bad), &STILL).0, Verdict::Diverged);
            assert_eq!(judge().judge(&STILL, &STILL, &moved(bad)).0, Verdict::Diverged);
        }
    }
}
