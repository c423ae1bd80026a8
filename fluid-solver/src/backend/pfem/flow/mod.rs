//! A step on the mesh at t_n: velocity and pressure of its middle, as one system.
//!
//! ρ Dv/Dt = ∇·τ − ∇p + ρg and ∇·v + (1/κ) Dp/Dt = 0 with P1 velocity and pressure on the mesh in the middle of the step,
//! x_m = x_n + ½Δt v_m; traction is zero on the free surface. The mass row of a node is
//!
//! Σ_e [∫N ∇·v + τ∇N·(ρ(v_m − v_n)/(θΔt) + ∇p − ρg)] = 0:
//!
//! the stabilisation holds the whole residual, so that a fluid at rest, in free fall or in an accelerated tank is exact,
//! and no wall and no surface needs a term of its own. Masses are lumped.

mod cell;
mod chunks;
mod constraint;
mod contact;
mod drop;
mod evaluate;
mod fault;
mod finish;
mod krylov;
mod nodal;
mod porous;
mod preconditioner;
mod pressure;
mod projection;
mod rebound;
mod rheology;
mod scheme;
mod setting;
mod solution;
mod solve;
mod strain;
mod suspended;
mod tangent;
mod topology;
mod velocity;
mod wall_function;

pub(super) use cell::viscosity;
pub use fault::FlowFault;
pub use rheology::{HerschelBulkley, Law, Newtonian, Rheology};
pub use scheme::Scheme;
pub use setting::{Control, Fluid, Forces};
pub use solution::{FlowSolution, Residuals};
pub use solve::Flow;
pub use strain::Strain;
pub use wall_function::wall_stress;
