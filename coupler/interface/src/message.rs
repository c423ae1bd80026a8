//! Commands of the coupler and reports of the participants, encoded with postcard.

use crate::error::InterfaceError;
use crate::ledger::{FluidLedger, GrainLedger};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// What the coupler tells a participant.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Command {
    /// Who speaks, about which case.
    Hello(Hello),
    /// Save the state and prepare a window.
    Open(Window),
    /// Do this side's part of an iteration.
    Advance {
        /// Iteration number, from 1.
        iteration: u32,
    },
    /// Go back to the saved state.
    Restore,
    /// Make the window history.
    Commit(Commit),
    /// Flush what is committed and end.
    Stop {
        /// Why, for the log.
        reason: String,
    },
}

/// The greeting; a participant refuses a difference.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hello {
    /// [`crate::frames::PROTOCOL`].
    pub protocol: u32,
    /// Program version.
    pub version: String,
    /// Hash of the resolved case.
    pub case_hash: String,
    /// Hash of the plan.
    pub plan_hash: String,
    /// The surface of the fluid's mesh, for a DEM whose walls or domain are the fluid's.
    pub surface: Option<Surface>,
}

/// The surface of a mesh: what grains may touch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Smallest coordinates \[m\].
    pub lower: [f64; 3],
    /// Largest coordinates \[m\].
    pub upper: [f64; 3],
    /// Facets by the name of their boundary: the vertices of triangles, in 2D of segments (the third one repeats).
    pub facets: BTreeMap<String, Vec<[[f64; 3]; 3]>>,
}

/// A time window t → t + Δt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Window {
    /// Number, from 0.
    pub number: u64,
    /// Start t \[s\].
    pub time: f64,
    /// Length Δt \[s\].
    pub step: f64,
    /// The grains frame was published anew: births, removals, a new order.
    pub grains_changed: bool,
}

/// What to leave on disk when a window becomes history.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Commit {
    /// Append a row to the series.
    pub series: bool,
    /// Write the frame of this number.
    pub frame: Option<u64>,
    /// Write this side's part of a restart point into the folder.
    pub restart: Option<PathBuf>,
}

/// What a participant answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Report {
    /// To hello.
    Ready(Ready),
    /// To open: the state is saved.
    Opened(Opened),
    /// To open or advance: the window is too long. Nothing has become history, and it may be offered anew, shorter.
    TooLarge(TooLarge),
    /// To advance.
    Solved(Box<Solved>),
    /// To restore.
    Restored,
    /// To commit.
    Committed(Committed),
    /// To stop.
    Ended(Usage),
    /// To anything: the participant cannot go on.
    Failed(Failure),
}

/// A participant at the start of the run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ready {
    /// The surface of the fluid's mesh, if it has one.
    pub surface: Option<Surface>,
    /// Grains (DEM) or nodes (fluid).
    pub size: u64,
    /// Largest Δt this side allows \[s\].
    pub largest_step: f64,
    /// Time that the state belongs to \[s\]: the start, or a restart point.
    pub time: f64,
    /// Findings for `coupler check`: sizes, limits and what binds them.
    pub notes: Vec<String>,
}

/// A participant with an open window.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Opened {
    /// Rows of the grains frame of this window (DEM), else 0.
    pub rows: u64,
    /// The grains frame was published anew (DEM), else false.
    pub grains_changed: bool,
}

/// Why a window is too long.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TooLarge {
    /// The largest Δt that would do \[s\].
    pub bound: f64,
    /// What sets it, and where.
    pub reason: String,
}

/// One side's part of an iteration is done.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solved {
    /// The side's books.
    pub books: Books,
    /// Largest Δt allowed for the next window \[s\].
    pub largest_step: f64,
    /// Substeps (DEM) or linear iterations (fluid) done.
    pub work: u64,
}

/// Books by side.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Books {
    /// The grains'.
    Grains(GrainLedger),
    /// The fluid's, with its norms.
    Fluid {
        /// Ledger row.
        ledger: FluidLedger,
        /// Norms for the convergence test.
        norms: Norms,
    },
}

/// Norms of the fluid iterate (volume-weighted root mean squares).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Norms {
    /// ‖u^k − u^{k−1}‖ \[m/s\].
    pub velocity_change: f64,
    /// ‖u^n‖ \[m/s\], or the floor given by the scales of the flow.
    pub velocity: f64,
    /// ‖p^k − p^{k−1}‖ \[Pa\].
    pub pressure_change: f64,
    /// ‖p^n‖ less its mean \[Pa\].
    pub pressure: f64,
}

/// A window became history.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Committed {
    /// Largest Δt allowed for the next window \[s\].
    pub largest_step: f64,
    /// Grains (DEM) now, else nodes.
    pub size: u64,
}

/// What a participant used.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Usage {
    /// CPU seconds, user and system.
    pub cpu_seconds: f64,
    /// Largest resident memory \[bytes\].
    pub peak_memory: u64,
    /// Wall seconds by part of the step.
    pub parts: Vec<(String, f64)>,
    /// Counters of saved work.
    pub counters: Vec<(String, u64)>,
    /// What that took away, with the unit in brackets.
    pub taken: Vec<(String, f64)>,
    /// What was gained and lost, by what did it, with the unit in brackets.
    pub audits: Vec<(String, f64)>,
}

/// Why a participant cannot go on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Failure {
    /// Exit code of the program.
    pub exit_code: i32,
    /// What is wrong, where, and what to do.
    pub message: String,
}

impl Command {
    /// The word for the command.
    pub fn name(&self) -> &'static str {
        match self {
            Command::Hello(_) => "hello",
            Command::Open(_) => "open",
            Command::Advance { .. } => "advance",
            Command::Restore => "restore",
            Command::Commit(_) => "commit",
            Command::Stop { .. } => "stop",
        }
    }
}

/// Bytes of a message.
pub fn encode<T: Serialize>(message: &T) -> Result<Vec<u8>, InterfaceError> {
    postcard::to_stdvec(message).map_err(|error| InterfaceError::Codec { detail: error.to_string() })
}

/// The message in the bytes.
pub fn decode<'a, T: Deserialize<'a>>(bytes: &'a [u8]) -> Result<T, InterfaceError> {
    postcard::from_bytes(bytes).map_err(|error| InterfaceError::Codec { detail: error.to_string() })
}
