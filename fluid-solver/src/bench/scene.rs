//! Flows with an exact solution.

use case_io::document::Backend;
use clap::ValueEnum;

use super::standing_wave::StandingWave;
use super::taylor_green::TaylorGreen;

/// A plane flow with an exact solution.
pub trait Scene: Sync {
    /// Whether a backend computes it.
    fn suits(&self, backend: Backend) -> bool;

    /// End of the run \[s\].
    fn end(&self) -> f64;

    /// Windows in which the fastest fluid crosses about one cell of the coarsest mesh, in all.
    fn windows(&self, cells: usize) -> usize;

    /// `[fluid]` without `backend` and `[case]` without `title`, on a mesh of `cells` along the shorter side.
    fn case(&self, cells: usize) -> String;

    /// u \[m/s\] at a place \[m\] and time \[s\].
    fn velocity(&self, point: [f64; 2], time: f64) -> [f64; 2];

    /// Corners of the box in which errors are taken \[m\]: fluid at all times.
    fn inside(&self) -> ([f64; 2], [f64; 2]);
}

/// The scenes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BenchScene {
    /// Four walls that the fluid slips along hold a vortex, which viscosity stops.
    TaylorGreen,
    /// The first mode of a tank with a free surface, from its flat moment on.
    StandingWave,
}

impl BenchScene {
    /// The word of the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::TaylorGreen => "taylor-green",
            Self::StandingWave => "standing-wave",
        }
    }

    /// The scene.
    pub fn scene(self) -> &'static dyn Scene {
        match self {
            Self::TaylorGreen => &TaylorGreen,
            Self::StandingWave => &StandingWave,
        }
    }
}
