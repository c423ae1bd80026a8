//! The second-order backward difference with variable step.

/// D_t φ = a₀ (φⁿ⁺¹ − φⁿ) + a₂ (φⁿ⁻¹ − φⁿ) and the extrapolation φ* = φⁿ + ω (φⁿ − φⁿ⁻¹), with ω = Δt_n/Δt_{n−1}:
/// a₀ = (1 + 2ω)/((1 + ω)Δt), a₂ = ω²/((1 + ω)Δt).
///
/// The first step has no φⁿ⁻¹: backward Euler, ω = 0. Written with differences, so that a constant has no rate at all.
///
/// Source: Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, 2nd ed. 1993, §III.5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimeRule {
    /// a₀ (1/s).
    pub new: f64,
    /// a₂ (1/s).
    pub older: f64,
    /// ω (-).
    pub extrapolation: f64,
}

impl TimeRule {
    /// The rule for a step Δt (s) that follows one of length `previous`.
    pub fn new(step: f64, previous: Option<f64>) -> Self {
        let ratio = previous.map_or(0.0, |previous| step / previous);
        Self {
            new: (1.0 + 2.0 * ratio) / ((1.0 + ratio) * step),
            older: ratio * ratio / ((1.0 + ratio) * step),
            extrapolation: ratio,
        }
    }

    /// a₁ = −a₀ − a₂, the coefficient of φⁿ (1/s).
    pub fn old(&self) -> f64 {
        -self.new - self.older
    }

    /// D_t φ.
    pub fn rate(&self, new: f64, old: f64, older: f64) -> f64 {
        self.new * (new - old) + self.older * (older - old)
    }

    /// φ*.
    pub fn extrapolate(&self, old: f64, older: f64) -> f64 {
        old + self.extrapolation * (old - older)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parabolas_have_their_exact_rate_for_any_ratio_of_steps() {
        let parabola = |t: f64| 3.0 - 2.0 * t + 5.0 * t * t;
        for (step, previous) in [(0.1, 0.1), (0.2, 0.05), (0.01, 0.3)] {
            let rule = TimeRule::new(step, Some(previous));
            let rate = rule.rate(parabola(step), parabola(0.0), parabola(-previous));
            assert!((rate - (-2.0 + 10.0 * step)).abs() < 1e-12);
            let line = |t: f64| 3.0 - 2.0 * t;
            assert!((rule.extrapolate(line(0.0), line(-previous)) - line(step)).abs() < 1e-14);
        }
        assert_eq!(TimeRule::new(0.1, None).rate(5.0, 3.0, f64::MAX), 20.0);
    }
}
