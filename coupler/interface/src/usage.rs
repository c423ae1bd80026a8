//! What this process has used, and a clock for the parts of a step.

use crate::message::Usage;
use std::time::Instant;

/// CPU seconds and peak memory of this process.
pub fn own_usage() -> Usage {
    // SAFETY: `usage` is a valid place for the answer; RUSAGE_SELF is always known.
    let usage = unsafe {
        let mut usage: libc::rusage = std::mem::zeroed();
        libc::getrusage(libc::RUSAGE_SELF, &mut usage);
        usage
    };
    let seconds = |time: libc::timeval| time.tv_sec as f64 + 1e-6 * time.tv_usec as f64;
    Usage {
        cpu_seconds: seconds(usage.ru_utime) + seconds(usage.ru_stime),
        peak_memory: 1024 * usage.ru_maxrss as u64,
        ..Usage::default()
    }
}

/// Splits wall time into laps.
pub struct Stopwatch(Instant);

impl Stopwatch {
    /// Starts now.
    pub fn start() -> Stopwatch {
        Stopwatch(Instant::now())
    }

    /// Seconds since the start or the last lap.
    pub fn lap(&mut self) -> f64 {
        let last = std::mem::replace(&mut self.0, Instant::now());
        self.0.duration_since(last).as_secs_f64()
    }
}
