//! For how long the lists hold.

use crate::lanes::{Row8, RowLanes, Vec3};

/// Grains whose speeds are found at once.
const GROUP: usize = 8;

/// How fast grains may come nearer \[m/s\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// To each other.
    pub between_grains: f64,
    /// To walls at rest.
    pub to_walls: f64,
    /// The middle of all velocities: what speeds are measured against in the next step.
    pub frame: [f64; 3],
}

impl Approach {
    /// Of no grain.
    pub fn none() -> Self {
        Self { between_grains: 0.0, to_walls: 0.0, frame: [0.0; 3] }
    }
}

/// The fastest grains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fastest {
    /// The two largest speeds in a frame, squared.
    first: f64,
    second: f64,
    /// The largest speed at all, squared.
    speed: f64,
    /// Smallest velocity along each axis.
    low: [f64; 3],
    /// Largest velocity along each axis.
    high: [f64; 3],
}

impl Fastest {
    /// Of no grain.
    pub fn none() -> Self {
        Self { first: 0.0, second: 0.0, speed: 0.0, low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] }
    }

    #[inline(always)]
    fn add(&mut self, square: f64, speed: f64) {
        self.second = self.second.max(self.first.min(square));
        self.first = self.first.max(square);
        self.speed = self.speed.max(speed);
    }

    /// Of both.
    pub fn joined(mut self, other: &Self) -> Self {
        self.add(other.first, other.speed);
        self.add(other.second, 0.0);
        self.widen(&other.low, &other.high);
        self
    }

    #[inline(always)]
    fn widen(&mut self, low: &[f64; 3], high: &[f64; 3]) {
        for axis in 0..3 {
            self.low[axis] = self.low[axis].min(low[axis]);
            self.high[axis] = self.high[axis].max(high[axis]);
        }
    }

    /// The largest speed at all \[m/s\].
    pub fn speed(&self) -> f64 {
        self.speed.sqrt()
    }

    /// The middle of all velocities: the frame that speeds are best measured in \[m/s\].
    fn middle(&self) -> [f64; 3] {
        std::array::from_fn(|axis| 0.5 * (self.low[axis] + self.high[axis]))
    }

    /// Of grains that move so, seen from a frame that moves at `frame` \[m/s\].
    #[inline(always)]
    pub fn of<L: RowLanes>(motions: &[Row8], frame: &[f64; 3]) -> Self {
        let at: [u32; GROUP] = std::array::from_fn(|k| k as u32);
        let origin = Vec3::new(L::splat(frame[0]), L::splat(frame[1]), L::splat(frame[2]));
        let (mut first, mut second, mut speed) = (L::splat(0.0), L::splat(0.0), L::splat(0.0));
        let (mut low, mut high) = ([L::splat(f64::INFINITY); 3], [L::splat(f64::NEG_INFINITY); 3]);
        let groups = motions.chunks_exact(GROUP);
        let rest = groups.remainder();
        for group in groups {
            for lane in (0..GROUP).step_by(L::WIDTH) {
                // SAFETY: a group has rows 0 to 7.
                let [velocity, _] = unsafe { L::columns8(group, &at[lane..]) };
                let square = (velocity - origin).norm_squared();
                second = second.max(first.min(square));
                first = first.max(square);
                speed = speed.max(velocity.norm_squared());
                low = [velocity.x.min(low[0]), velocity.y.min(low[1]), velocity.z.min(low[2])];
                high = [velocity.x.max(high[0]), velocity.y.max(high[1]), velocity.z.max(high[2])];
            }
        }
        let mut lanes = [[0.0; GROUP]; 3];
        let [firsts, seconds, speeds] = &mut lanes;
        first.store(firsts);
        second.store(seconds);
        speed.store(speeds);
        let mut fastest = Self::none();
        for lane in 0..GROUP {
            fastest.add(firsts[lane], speeds[lane]);
            fastest.add(seconds[lane], 0.0);
        }
        for axis in 0..3 {
            let (mut lows, mut highs) = ([f64::INFINITY; GROUP], [f64::NEG_INFINITY; GROUP]);
            low[axis].store(&mut lows);
            high[axis].store(&mut highs);
            fastest.low[axis] = lows.into_iter().fold(f64::INFINITY, f64::min);
            fastest.high[axis] = highs.into_iter().fold(f64::NEG_INFINITY, f64::max);
        }
        for motion in rest {
            let v = Vec3::new(motion.0[0], motion.0[1], motion.0[2]);
            let origin = Vec3::new(frame[0], frame[1], frame[2]);
            fastest.add((v - origin).norm_squared(), v.norm_squared());
            fastest.widen(&[v.x, v.y, v.z], &[v.x, v.y, v.z]);
        }
        fastest
    }

    /// How fast grains may come nearer: to each other by the two largest speeds in the frame together, whatever
    /// motion all grains share; to walls at rest by the largest speed.
    pub fn approach(&self) -> Approach {
        let frame = if self.low[0] > self.high[0] { [0.0; 3] } else { self.middle() };
        Approach {
            between_grains: self.first.sqrt() + self.second.sqrt(),
            to_walls: self.speed.sqrt(),
            frame,
        }
    }
}
