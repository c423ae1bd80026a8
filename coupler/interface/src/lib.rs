//! Frames, messages, participant states, transports and liveness: all that crosses between the three programs.
//!
//! The coupler owns the clock and speaks first; a participant answers. Bulk data cross as [`frames`] over a
//! [`transport`] (shared memory between processes, or channels between threads of one process), commands and
//! reports as [`message`]s. [`participant::serve`] runs the state machine of a solver.

pub mod assignment;
pub mod command_line;
pub mod error;
pub mod frames;
pub mod ledger;
pub mod message;
pub mod participant;
pub mod pulse;
pub mod run;
pub mod solver;
pub mod state;
pub mod transport;
pub mod usage;

pub use error::InterfaceError;
pub use frames::{GrainRow, HydroRow, ImpulseRow, ReactionRow, SampleRow};
