//! What counts as idle, and what wakes.

/// Idle grains accelerate by less than this fraction of what wakes them, so that none wakes of what made it fall asleep.
const DROWSY: f64 = 0.25;

/// A quiet time in which the bound on the acceleration would change a velocity by this many times the bound on the speed.
const PATIENCE: f64 = 10.0;

/// The error bound of sleep. Chunks of grains fall asleep whose grains all
///
/// - moved slower than v_s for the time T = 10 v_s/a_s, so that their mean acceleration was below a_s/5, and
/// - at its end have r ω < v_s and a < a_s/4,
///
/// and wake when a > a_s for one of them. a = |F|/m + r |T|/I, with all loads on the grain, is the largest acceleration of
/// its surface. So the sum of forces on a sleeping grain is never above m a_s, and falling asleep takes less than
/// (m + I/r²) v_s²/2 of its energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SleepBound {
    /// Speed v_s \[m/s\].
    pub speed: f64,
    /// Acceleration a_s \[m/s²\].
    pub acceleration: f64,
}

impl SleepBound {
    /// The time T that a chunk must be quiet \[s\].
    pub fn patience(&self) -> f64 {
        PATIENCE * self.speed / self.acceleration
    }

    /// Whether a grain with this acceleration a and speed of its surface r ω may fall asleep.
    pub fn lets_sleep(&self, acceleration: f64, surface_speed: f64) -> bool {
        acceleration < DROWSY * self.acceleration && surface_speed < self.speed
    }

    /// Whether this acceleration wakes a grain; one that is no number does.
    pub fn wakes(&self, acceleration: f64) -> bool {
        acceleration.is_nan() || acceleration > self.acceleration
    }
}
