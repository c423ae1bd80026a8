//! What a step gives.

use crate::backend::Step;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::Contacts;
use crate::element::simplex::Vector;

/// The solution of a step; one entry per node.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<const D: usize> {
    /// v_m (m/s), of the middle.
    pub velocity: Vec<Vector<D>>,
    /// v_{n+1} (m/s).
    pub end_velocity: Vec<Vector<D>>,
    /// p (Pa), of the middle.
    pub pressure: Vec<f64>,
    /// Walls touched at the end.
    pub contacts: Vec<Contacts>,
    /// Force of the walls (N), mean over the step, with the blow that a new contact is.
    pub reaction: Vec<Vector<D>>,
    /// ρV_i (kg), in the middle; 0 for drops.
    pub mass: Vec<f64>,
    /// What the fluid that goes over between nodes brings to Σ m_i v_i beside Σ m_i (v_{n+1} − v_n)/Δt (N).
    pub exchange: Vector<D>,
    /// Power (W) that the friction of walls turns into heat.
    pub friction: f64,
    /// θ that it was solved with.
    pub implicitness: f64,
    /// Linear iterations.
    pub iterations: u64,
    /// How often the geometry was updated.
    pub passes: u64,
    /// What is left of the equations.
    pub residuals: Residuals,
}

/// Norms of what is left of the equations, relative to the size of their terms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Residuals {
    /// Of momentum.
    pub momentum: f64,
    /// Of volume.
    pub volume: f64,
}

impl<const D: usize> FlowSolution<D> {
    /// Moves the nodes: x_{n+1} = x_n + Δt v_m, and velocity, pressure and contacts are those of the solution.
    pub fn advance<const N: usize>(&self, cloud: &mut Cloud<D, N>, step: Step) {
        for (x, v) in cloud.place.iter_mut().zip(&self.velocity) {
            *x = super::contact::moved(x, step.length, v);
        }
        cloud.velocity.copy_from_slice(&self.end_velocity);
        cloud.pressure.copy_from_slice(&self.pressure);
        cloud.contacts.copy_from_slice(&self.contacts);
    }
}
