//! The coupler: launches the solvers, orders the staggered iterations, evaluates the interaction laws, keeps the ledger.

pub mod acceleration;
mod clock;
pub mod command;
pub mod convergence;
mod error;
mod exchange;
pub mod interaction;
mod launch;
mod ledger;
mod owed;
mod record;
mod run;
mod session;
mod simulation;
mod verdict;
mod window;

pub use clock::Clock;
pub use error::CouplerError;
pub use session::Session;
pub use simulation::{Simulation, Watcher};
