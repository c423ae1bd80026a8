//! Motion of the grains of a chunk.

use super::approach::Fastest;
use crate::lanes::{Kernel, Row4, Row8, RowLanes};

/// Grains whose motions are still near when their speeds are found.
const STRETCH: usize = 128;

/// Where the grains of a chunk are and how they move.
pub struct Rows<'a> {
    /// Their places.
    pub places: &'a mut [Row4],
    /// Their motions.
    pub motions: &'a mut [Row8],
}

/// What the motion of grains tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// The fastest of them.
    pub fastest: Fastest,
    /// Sum of all velocities and spins; not finite if any is not.
    pub sum: f64,
    /// Impulse of the loads on frozen grains \[N s\].
    pub held: [f64; 3],
}

impl Moved {
    /// Of no grain.
    pub fn none() -> Self {
        Self { fastest: Fastest::none(), sum: 0.0, held: [0.0; 3] }
    }
}

/// Gives grains the momentum of a step, then flies them on.
///
/// Loops over rows of eight are plain: each backend compiles them for its own registers.
pub struct Advance<'a> {
    /// The grains.
    pub grains: Rows<'a>,
    /// Loads on them; left empty for the next step.
    pub loads: &'a mut [Row8],
    /// Acceleration of gravity \[m/s²\].
    pub gravity: [f64; 3],
    /// Time of the kick \[s\].
    pub step: f64,
    /// Time of the flight \[s\].
    pub flight: f64,
    /// Velocity that speeds are measured against \[m/s\].
    pub frame: [f64; 3],
}

impl Kernel for Advance<'_> {
    type Output = Moved;

    #[inline(always)]
    fn run<L: RowLanes>(self) -> Moved {
        let Self { grains: Rows { places, motions }, loads, step, flight, .. } = self;
        let [gx, gy, gz] = self.gravity;
        let gravity = [gx, gy, gz, 0.0, 0.0, 0.0, 0.0, 0.0];
        let flight = [flight, flight, flight, 0.0];
        let mut fastest = Fastest::none();
        let (mut sum, mut held) = ([0.0; 8], [0.0; 3]);
        let stretches =
            places.chunks_mut(STRETCH).zip(motions.chunks_mut(STRETCH)).zip(loads.chunks_mut(STRETCH));
        for ((places, motions), loads) in stretches {
            for ((place, motion), load) in places.iter_mut().zip(motions.iter_mut()).zip(loads) {
                let before = motion.0;
                let (im, ii) = (before[3], before[7]);
                let inverse = [im, im, im, im, ii, ii, ii, ii];
                let load = std::mem::take(&mut load.0);
                if im == 0.0 {
                    // A frozen grain gains no velocity: its support takes the load.
                    (0..3).for_each(|c| held[c] += load[c] * step);
                    continue;
                }
                let after = std::array::from_fn(|c| before[c] + (load[c] * inverse[c] + gravity[c]) * step);
                motion.0 = after;
                place.0 = std::array::from_fn(|c| place.0[c] + after[c] * flight[c]);
                sum = std::array::from_fn(|c| sum[c] + after[c]);
            }
            fastest = fastest.joined(&Fastest::of::<L>(motions, &self.frame));
        }
        Moved { fastest, sum: sum.iter().sum(), held }
    }
}

/// Flies grains on at their velocities.
pub struct Fly<'a> {
    /// Their places.
    pub places: &'a mut [Row4],
    /// Their motions.
    pub motions: &'a [Row8],
    /// Time of the flight \[s\].
    pub flight: f64,
    /// Velocity that speeds are measured against \[m/s\].
    pub frame: [f64; 3],
}

impl Kernel for Fly<'_> {
    type Output = Fastest;

    #[inline(always)]
    fn run<L: RowLanes>(self) -> Fastest {
        let Self { places, motions, .. } = self;
        for (place, motion) in places.iter_mut().zip(motions) {
            for axis in 0..3 {
                place.0[axis] += motion.0[axis] * self.flight;
            }
        }
        Fastest::of::<L>(motions, &self.frame)
    }
}

/// How fast grains are.
pub struct Speeds<'a> {
    /// Their motions.
    pub motions: &'a [Row8],
    /// Velocity that speeds are measured against \[m/s\].
    pub frame: [f64; 3],
}

impl Kernel for Speeds<'_> {
    type Output = Fastest;

    #[inline(always)]
    fn run<L: RowLanes>(self) -> Fastest {
        Fastest::of::<L>(self.motions, &self.frame)
    }
}
