//! `pfem`: the particle finite element method. The nodes are particles of the fluid and carry all of its state; the mesh
//! between them is made anew where they moved.
//!
//! One step: [`grains`] are placed where they end, [`flow`] moves the nodes on the mesh at t_n, [`remesh`] finds the mesh at t_{n+1}.

mod backend;
pub mod body;
mod case;
mod checkpoint;
pub mod cloud;
mod first_mesh;
pub mod flow;
pub mod gate;
pub mod grains;
mod output;
mod probe;
pub mod remesh;
mod renewal;
pub mod seats;
mod state;
pub mod wall;

pub use backend::{Pfem, Setting};
pub use body::Body;
pub use case::of;
pub use renewal::Renewal;
pub use state::State;
