//! Which lanes a kernel runs on.

use super::RowLanes;
use super::avx2::Avx2;
use super::avx512::Avx512;
use super::plain::Plain;

/// Work written once for all lanes.
///
/// `run` must be `#[inline(always)]`, so that it is compiled for the instructions of each backend.
pub trait Kernel {
    /// What it finds.
    type Output;
    /// The work.
    fn run<L: RowLanes>(self) -> Self::Output;
}

/// A set of instructions this CPU has: made only by [`Backend::best`] and [`Backend::available`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Backend(Instructions);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Instructions {
    Plain,
    Avx2,
    Avx512,
}

impl Backend {
    /// The widest lanes of this CPU.
    pub fn best() -> Self {
        Self::available().pop().unwrap_or(Self(Instructions::Plain))
    }

    /// All lanes of this CPU, the widest last.
    pub fn available() -> Vec<Self> {
        let mut all = vec![Self(Instructions::Plain)];
        if is_x86_feature_detected!("avx2") {
            all.push(Self(Instructions::Avx2));
        }
        if is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512vl")
            && is_x86_feature_detected!("avx512dq")
        {
            all.push(Self(Instructions::Avx512));
        }
        all
    }

    /// Name in reports.
    pub fn name(self) -> &'static str {
        match self.0 {
            Instructions::Plain => "plain",
            Instructions::Avx2 => "AVX2",
            Instructions::Avx512 => "AVX-512",
        }
    }

    /// Runs the work on these lanes.
    #[inline]
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self.0 {
            Instructions::Plain => kernel.run::<Plain>(),
            // SAFETY: a backend exists only where its instructions were detected.
            Instructions::Avx2 => unsafe { run_avx2(kernel) },
            // SAFETY: as above.
            Instructions::Avx512 => unsafe { run_avx512(kernel) },
        }
    }
}

#[target_feature(enable = "avx2")]
fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Avx2>()
}

#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2")]
fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Avx512>()
}
