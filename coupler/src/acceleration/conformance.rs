//! A linear oscillator in two parts, against its exact amplification factor: held by every acceleration.
//!
//! A mass m on a spring k carries an added mass m_a that the other participant holds: it answers an acceleration a by the
//! force −m_a a. The average-acceleration rule (Newmark 1959, β = 1/4) turns one window of the whole into a rotation of the
//! phase by 2 atan(ωΔt/2), ω² = k/(m + m_a), without loss. One pass amplifies an error of the force by −λ,
//! λ = m_a/(m + kΔt²/4).

use std::f64::consts::PI;

use super::{Acceleration, Aitken, Constant, None};
use crate::convergence::{Change, ForceResidual, Judge, RelativeNorm, Verdict};

const MASS: f64 = 1.0;
const STIFFNESS: f64 = 40.0;
const WINDOW: f64 = 0.05;

struct Oscillator {
    added_mass: f64,
    place: f64,
    velocity: f64,
    acceleration: f64,
    force: f64,
}

impl Oscillator {
    fn released(added_mass: f64) -> Self {
        let acceleration = -STIFFNESS / (MASS + added_mass);
        Self { added_mass, place: 1.0, velocity: 0.0, acceleration, force: -added_mass * acceleration }
    }

    fn amplification(&self) -> f64 {
        self.added_mass / (MASS + 0.25 * STIFFNESS * WINDOW * WINDOW)
    }

    /// Acceleration at the end of the window under the other's force.
    fn answer(&self, force: f64) -> f64 {
        let reached = self.place + WINDOW * self.velocity + 0.25 * WINDOW * WINDOW * self.acceleration;
        (force - STIFFNESS * reached) / (MASS + 0.25 * STIFFNESS * WINDOW * WINDOW)
    }

    fn residual(&self, force: f64) -> f64 {
        -self.added_mass * self.answer(force) - force
    }

    fn commit(&mut self, force: f64) {
        let next = self.answer(force);
        self.place += WINDOW * self.velocity + 0.25 * WINDOW * WINDOW * (self.acceleration + next);
        self.velocity += 0.5 * WINDOW * (self.acceleration + next);
        (self.acceleration, self.force) = (next, force);
    }

    /// One window; the number of passes, or the verdict that ended it.
    fn window(&mut self, acceleration: &mut Acceleration) -> Result<u32, Verdict> {
        let norm = RelativeNorm { tolerance: 1e-3, floor: 1.0 };
        let mut judge = Judge::new(norm, norm, ForceResidual { tolerance: 1e-13, floor: 1.0 });
        let still = Change::default();
        acceleration.open();
        let mut force = [self.force];
        for pass in 1..=400 {
            let residual = [self.residual(force[0])];
            let change = Change { change: residual[0].abs(), reference: STIFFNESS };
            match judge.judge(&still, &still, &change).0 {
                Verdict::Converged => {
                    self.commit(force[0]);
                    return Ok(pass);
                }
                Verdict::Diverged => return Err(Verdict::Diverged),
                Verdict::Continue => acceleration.relax(&mut force, &residual),
            };
        }
        Err(Verdict::Continue)
    }
}

/// Every acceleration, with the largest added mass that it is tried with.
fn members() -> Vec<(Acceleration, f64)> {
    let all = vec![
        (Acceleration::None(None), 0.7),
        (Acceleration::Constant(Constant::new(0.3).unwrap()), 4.0),
        (Acceleration::Aitken(Aitken::new(0.5).unwrap()), 12.0),
    ];
    let named = all.iter().map(|(member, _)| member.explain());
    assert!(named.eq(Acceleration::explanations()), "a member is missing here");
    all
}

#[test]
fn the_two_parts_together_have_the_amplification_factor_of_the_whole() {
    for (mut acceleration, added_mass) in members() {
        let mut oscillator = Oscillator::released(added_mass);
        let frequency = (STIFFNESS / (MASS + added_mass)).sqrt();
        let turn = 2.0 * (0.5 * frequency * WINDOW).atan();
        let windows = (6.0 * PI / turn) as u32;
        for n in 1..=windows {
            oscillator.window(&mut acceleration).unwrap();
            let exact = (f64::from(n) * turn).cos();
            let misfit = (oscillator.place - exact).abs();
            assert!(misfit < 1e-10, "{}, window {n}: {misfit}", acceleration.explain()[0]);
        }
    }
}

#[test]
fn a_pass_amplifies_the_error_by_one_minus_omega_times_one_plus_lambda() {
    for (mut acceleration, factor) in
        [(Acceleration::None(None), 1.0), (Acceleration::Constant(Constant::new(0.3).unwrap()), 0.3)]
    {
        let oscillator = Oscillator::released(4.0);
        let mut force = [oscillator.force + 1.0];
        let before = oscillator.residual(force[0]);
        acceleration.relax(&mut force, &[before]);
        let amplification = oscillator.residual(force[0]) / before;
        let exact = 1.0 - factor * (1.0 + oscillator.amplification());
        assert!((amplification - exact).abs() < 1e-13, "{amplification} {exact}");
    }
}

#[test]
fn unrelaxed_passes_diverge_as_soon_as_the_amplification_exceeds_one() {
    let outcome = |added_mass| Oscillator::released(added_mass).window(&mut Acceleration::None(None));
    assert!(outcome(0.9).is_ok());
    assert_eq!(outcome(1.5), Err(Verdict::Diverged));
}

#[test]
fn aitken_needs_three_passes_for_one_linear_unknown() {
    let mut acceleration = Acceleration::Aitken(Aitken::new(0.5).unwrap());
    let mut oscillator = Oscillator::released(12.0);
    for _ in 0..50 {
        let passes = oscillator.window(&mut acceleration).unwrap();
        assert!(passes <= 3, "{passes}");
    }
}
