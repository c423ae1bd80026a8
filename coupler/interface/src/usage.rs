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

/// Splits the processor time of a thread into laps.
pub struct ThreadClock(f64);

impl ThreadClock {
    /// Starts now, for the thread that calls.
    pub fn start() -> ThreadClock {
        ThreadClock(thread_seconds())
    }

    /// Seconds of the thread since the start or the last lap.
    pub fn lap(&mut self) -> f64 {
        let now = thread_seconds();
        now - std::mem::replace(&mut self.0, now)
    }
}

/// CPU seconds of this thread.
fn thread_seconds() -> f64 {
    let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: `time` is a valid place for the answer; the clock of the calling thread is always known.
    unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &mut time) };
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}
