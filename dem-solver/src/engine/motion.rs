//! Motion of the grains of a chunk.

use super::approach::Fastest;
use crate::grains::{Motion, Place};
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
    /// Sum of all numbers that move; not finite if any is not.
    pub sum: f64,
    /// Impulse of the loads on frozen grains \[N s\].
    pub held: [f64; 3],
    /// Smallest coordinates of centres \[m\].
    pub lowest: [f64; 3],
    /// Largest coordinates of centres \[m\].
    pub highest: [f64; 3],
}

impl Moved {
    /// Of no grain.
    pub fn none() -> Self {
        Self {
            fastest: Fastest::none(),
            sum: 0.0,
            held: [0.0; 3],
            lowest: [f64::INFINITY; 3],
            highest: [f64::NEG_INFINITY; 3],
        }
    }

    /// Takes note of a grain, but for its speed.
    pub fn see(&mut self, place: &Place, motion: &Motion) {
        self.sum += place.centre.sum() + motion.velocity.sum() + motion.angular_velocity.sum();
        self.lowest = smaller(self.lowest, place.centre.into());
        self.highest = larger(self.highest, place.centre.into());
    }
}

#[inline(always)]
fn smaller<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|c| if a[c] < b[c] { a[c] } else { b[c] })
}

#[inline(always)]
fn larger<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|c| if a[c] > b[c] { a[c] } else { b[c] })
}

fn first_three<const N: usize>(row: [f64; N]) -> [f64; 3] {
    std::array::from_fn(|c| row[c])
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
        let (mut sum, mut held, mut sum_of_places) = ([0.0; 8], [0.0; 8], [0.0; 4]);
        let (mut lowest, mut highest) = ([f64::INFINITY; 4], [f64::NEG_INFINITY; 4]);
        let stretches =
            places.chunks_mut(STRETCH).zip(motions.chunks_mut(STRETCH)).zip(loads.chunks_mut(STRETCH));
        for ((places, motions), loads) in stretches {
            for ((place, motion), load) in places.iter_mut().zip(motions.iter_mut()).zip(loads) {
                let before = motion.0;
                let (im, ii) = (before[3], before[7]);
                let inverse = [im, im, im, im, ii, ii, ii, ii];
                // A frozen grain gains no velocity: its support takes the load.
                let time = if im > 0.0 { step } else { 0.0 };
                let load = std::mem::take(&mut load.0);
                let after = std::array::from_fn(|c| before[c] + (load[c] * inverse[c] + gravity[c]) * time);
                motion.0 = after;
                place.0 = std::array::from_fn(|c| place.0[c] + after[c] * flight[c]);
                sum = std::array::from_fn(|c| sum[c] + after[c]);
                sum_of_places = std::array::from_fn(|c| sum_of_places[c] + place.0[c]);
                held = std::array::from_fn(|c| held[c] + load[c] * (step - time));
                lowest = smaller(lowest, place.0);
                highest = larger(highest, place.0);
            }
            fastest = fastest.joined(&Fastest::of::<L>(motions, &self.frame));
        }
        Moved {
            fastest,
            sum: sum.iter().chain(&sum_of_places).sum(),
            held: first_three(held),
            lowest: first_three(lowest),
            highest: first_three(highest),
        }
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
