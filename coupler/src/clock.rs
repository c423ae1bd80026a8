//! The clock: which Δt is offered next, and what falls due when it is over.

/// Times at which something falls due: every multiple of an interval, and the end.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Due {
    interval: Option<f64>,
    /// How often it has been done.
    count: u64,
}

impl Due {
    fn next(self, end: f64) -> f64 {
        self.interval.map_or(end, |interval| ((self.count + 1) as f64 * interval).min(end))
    }

    /// Counts what is due at `time` or within `slack` after it; the last time may fall at the end without being a
    /// multiple.
    fn take(&mut self, time: f64, slack: f64, end: f64) -> bool {
        let is_left = self.interval.is_some_and(|interval| self.count as f64 * interval + slack < end);
        let is_due = is_left && time + slack >= self.next(end);
        if is_due {
            self.count += 1;
        }
        is_due
    }
}

/// What falls due at a commit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outputs {
    /// A row of the series.
    pub series: bool,
    /// A frame of this number.
    pub frame: Option<u64>,
    /// A restart point.
    pub restart: bool,
}

/// Time of the run.
#[derive(Clone, Debug)]
pub struct Clock {
    /// Now \[s\].
    pub time: f64,
    /// Number of the next window.
    pub window: u64,
    end: f64,
    /// Δt of the case \[s\].
    nominal: f64,
    smallest: f64,
    series: Due,
    frames: Due,
    restart: Due,
}

/// Intervals of output \[s\]; none: never.
#[derive(Clone, Copy, Debug)]
pub struct Intervals {
    /// Of the series.
    pub series: f64,
    /// Of the frames; none: one at the end.
    pub frames: Option<f64>,
    /// Of the restart points.
    pub restart: Option<f64>,
}

impl Clock {
    /// A clock at 0.
    pub fn new(end: f64, nominal: f64, smallest: f64, intervals: Intervals) -> Clock {
        let due = |interval| Due { interval, count: 0 };
        Clock {
            time: 0.0,
            window: 0,
            end,
            nominal,
            smallest,
            series: due(Some(intervals.series)),
            frames: due(intervals.frames),
            restart: due(intervals.restart),
        }
    }

    /// Goes on after a window that a restart point closed.
    pub fn resume(&mut self, time: f64, window: u64) {
        (self.time, self.window) = (time, window + 1);
        let (slack, end) = (self.slack(), self.end);
        for due in [&mut self.series, &mut self.frames, &mut self.restart] {
            while due.take(time, slack, end) {}
        }
    }

    /// The run is over.
    pub fn is_over(&self) -> bool {
        self.time >= self.end
    }

    /// Part of the run that is done \[-\].
    pub fn progress(&self) -> f64 {
        self.time / self.end
    }

    /// Δt to offer: at most the case's and the participants' bound, and such that equal windows reach the next
    /// output exactly.
    ///
    /// # Errors
    /// The Δt wanted, if it is below the smallest that the case allows.
    pub fn offer(&self, bound: f64) -> Result<f64, f64> {
        let left = self.next_stop() - self.time;
        let largest = self.nominal.min(bound);
        // Round-off must not add a window for the last part in 1e9 of a step.
        let count = (left / largest - 1e-9).ceil().max(1.0);
        let step = left / count;
        // The remainder before an output may be short; what is refused is a bound that is.
        if largest < self.smallest || step.is_nan() { Err(largest) } else { Ok(step) }
    }

    /// Times this near are the same: multiples of different intervals differ by round-off.
    fn slack(&self) -> f64 {
        1e-6 * self.nominal
    }

    fn next_stop(&self) -> f64 {
        let dues = [self.series, self.frames, self.restart];
        let stop = dues.iter().fold(self.end, |stop, due| stop.min(due.next(self.end)));
        if stop + self.slack() < self.end { stop } else { self.end }
    }

    /// Where a window of this Δt ends: exactly at an output if it is the last before it.
    pub fn after(&self, step: f64) -> f64 {
        let stop = self.next_stop();
        if self.time + 1.5 * step > stop { stop } else { self.time + step }
    }

    /// What falls due at the end of the open window.
    pub fn due_at(&self, time: f64) -> Outputs {
        self.clone().close(time)
    }

    /// The window is history.
    pub fn close(&mut self, time: f64) -> Outputs {
        self.time = time;
        self.window += 1;
        let (slack, end) = (self.slack(), self.end);
        // Without an interval the end is the only frame.
        let frame = self.frames.take(time, slack, end) || self.frames.interval.is_none() && self.is_over();
        Outputs {
            series: self.series.take(time, slack, end),
            frame: frame.then_some(self.frames.count),
            restart: self.restart.take(time, slack, end),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clock() -> Clock {
        let intervals = Intervals { series: 0.1, frames: Some(0.25), restart: None };
        Clock::new(1.0, 0.03, 1e-4, intervals)
    }

    #[test]
    fn windows_meet_every_output_exactly_and_the_end() {
        let mut clock = clock();
        let (mut rows, mut frames) = (Vec::new(), Vec::new());
        while !clock.is_over() {
            let step = clock.offer(f64::INFINITY).unwrap();
            assert!(step <= 0.03 * (1.0 + 1e-9) && step > 0.0);
            let outputs = clock.close(clock.after(step));
            if outputs.series {
                rows.push(clock.time);
            }
            frames.extend(outputs.frame.map(|number| (number, clock.time)));
        }
        assert_eq!(rows.len(), 10);
        assert_eq!(rows[2], 3.0 * 0.1);
        assert_eq!(frames, [(1, 0.25), (2, 0.5), (3, 0.75), (4, 1.0)]);
        assert_eq!(clock.time, 1.0);
    }

    #[test]
    fn without_frames_in_time_the_end_is_the_only_one() {
        let intervals = Intervals { series: 0.1, frames: None, restart: None };
        let mut clock = Clock::new(1.0, 0.03, 1e-4, intervals);
        let mut frames = Vec::new();
        while !clock.is_over() {
            let step = clock.offer(f64::INFINITY).unwrap();
            let outputs = clock.close(clock.after(step));
            frames.extend(outputs.frame.map(|_| clock.time));
        }
        assert_eq!(frames, [1.0]);
    }

    #[test]
    fn outputs_that_fall_together_up_to_round_off_share_a_window() {
        let intervals = Intervals { series: 0.01, frames: Some(0.1), restart: Some(0.3) };
        let mut clock = Clock::new(0.9, 2e-3, 1e-6, intervals);
        while !clock.is_over() {
            let step = clock.offer(f64::INFINITY).unwrap();
            assert!((step - 2e-3).abs() < 1e-9, "{step} at {}", clock.time);
            clock.close(clock.after(step));
        }
        assert_eq!(clock.window, 450);
    }

    #[test]
    fn a_bound_below_the_smallest_window_is_refused() {
        assert_eq!(clock().offer(1e-5), Err(1e-5));
        assert!(clock().offer(0.0).is_err());
    }

    #[test]
    fn a_resumed_clock_goes_on_as_if_it_had_run_through() {
        let mut through = clock();
        let mut resumed = clock();
        let mut other = None;
        while !through.is_over() {
            let step = through.offer(f64::INFINITY).unwrap();
            let window = through.window;
            let outputs = through.close(through.after(step));
            if let Some(resumed) = &mut other {
                let resumed: &mut Clock = resumed;
                assert_eq!(resumed.close(resumed.after(step)), outputs);
            } else if outputs.frame == Some(2) {
                resumed.resume(through.time, window);
                other = Some(resumed.clone());
            }
        }
        assert_eq!(other.unwrap().time, through.time);
    }
}
