//! One run: its error and what it took.

use std::fs;
use std::path::Path;

use case_io::document::{Backend, Case, Overrides};
use case_io::output::OutputError;
use interface::usage::own_usage;

use super::error::BenchError;
use super::scene::Scene;
use crate::backend::{self, Attempt, FluidBackend, Stages, Step};

/// Points along each side of the box at which errors are taken.
const POINTS: usize = 61;

/// Part of a window below which none is halved again.
const SMALLEST: f64 = 1e-3;

/// What a run gave and took.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Cells along the shorter side.
    pub cells: usize,
    /// Windows, those halved counted as they were done.
    pub windows: usize,
    /// Nodes at the end.
    pub nodes: u64,
    /// Root mean square of the error of u, relative to the exact u of the start.
    pub error: f64,
    /// Processor time of all windows, set-up apart \[s\].
    pub seconds: f64,
    /// Where the thread that leads spent them.
    pub stages: Stages,
    /// Linear iterations.
    pub iterations: u64,
}

impl Measured {
    /// Processor time per node and window \[s\].
    pub fn seconds_per_node_step(&self) -> f64 {
        self.seconds / (self.nodes as f64 * self.windows as f64)
    }
}

/// Runs a scene on a backend, on the present thread pool; its case stays in `folder`.
///
/// # Errors
/// A case that is refused, a step that fails, the disk's.
pub fn measure(
    scene: &dyn Scene,
    backend: (Backend, &str),
    (cells, windows): (usize, usize),
    folder: &Path,
) -> Result<Measured, BenchError> {
    fs::create_dir_all(folder).map_err(OutputError::system("make", folder))?;
    let length = scene.end() / windows as f64;
    let text = scene.case(cells).replacen("[fluid]\n", &format!("[fluid]\nbackend = \"{}\"\n", backend.1), 1);
    let text = format!("{text}[time]\nend = \"{} s\"\nwindow = \"{length} s\"\n", scene.end());
    let path = folder.join("case.toml");
    fs::write(&path, text).map_err(OutputError::system("write", &path))?;
    let case = Case::load_run(folder, &Overrides::default(), None)?;
    let mut fluid = backend::of(&case, true)?;
    let before = own_usage().cpu_seconds;
    let (mut time, mut part, mut done, mut iterations) = (0.0, 1.0, 0, 0);
    while time < scene.end() * (1.0 - 1e-9) {
        let step = Step { time, length: (part * length).min(scene.end() - time) };
        fluid.save();
        match fluid.solve(step, &[])? {
            Attempt::Solved(solution) => {
                iterations += solution.iterations;
                fluid.commit(step)?;
                (time, part, done) = (step.end(), 1.0, done + 1);
            }
            Attempt::TooLarge(_) if part > SMALLEST => {
                fluid.restore();
                part *= 0.5;
            }
            Attempt::TooLarge(refused) => return Err(BenchError::TooLarge { time, reason: refused.reason }),
        }
    }
    let seconds = own_usage().cpu_seconds - before;
    Ok(Measured {
        cells,
        windows: done,
        nodes: fluid.nodes(),
        error: error(scene, fluid.as_ref())?,
        seconds,
        stages: fluid.stages(),
        iterations,
    })
}

/// Root mean square of u_h − u over that of u at t = 0.
fn error(scene: &dyn Scene, fluid: &dyn FluidBackend) -> Result<f64, BenchError> {
    let (lower, upper) = scene.inside();
    let (mut wrong, mut whole) = (0.0, 0.0);
    for place in 0..POINTS * POINTS {
        // Middles of a grid: no point is on the boundary.
        let share = [place % POINTS, place / POINTS].map(|k| (k as f64 + 0.5) / POINTS as f64);
        let point: [f64; 2] = std::array::from_fn(|k| lower[k] + share[k] * (upper[k] - lower[k]));
        let there = fluid.at(scene.end(), [point[0], point[1], 0.0]);
        let value = there.ok_or(BenchError::Dry { point, time: scene.end() })?;
        let (exact, first) = (scene.velocity(point, scene.end()), scene.velocity(point, 0.0));
        for k in 0..2 {
            wrong += (value.velocity[k] - exact[k]).powi(2);
            whole += first[k] * first[k];
        }
    }
    Ok((wrong / whole).sqrt())
}
