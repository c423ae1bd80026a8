//! `eulerian`: stabilised finite elements on a fixed mesh.

mod assembly;
mod backend;
mod balance;
mod case;
mod cell_fields;
mod checkpoint;
mod compensated;
mod fault;
mod flow;
mod incidence;
mod krylov;
mod ledger;
mod matrices;
mod outlet;
mod output;
mod preconditioner;
mod schur;
mod state;
mod step;
mod time_rule;
mod velocity_multigrid;
mod velocity_sweep;

pub use backend::Eulerian;
pub use case::of;
pub use flow::{Flow, Properties};
pub use state::State;
