//! Gates: where fluid comes in and leaves.
//!
//! Nodes in an inlet stay where they are while the fluid moves on, and nodes that come to an outlet stop at it. So the mesh
//! reaches both at all times, and what passed is the difference of what it holds before and after nodes were put there.

mod amount;
mod case;
mod inlet;
mod outlet;
mod shape;

pub use amount::{Amount, Passed};
pub use case::{Opening, open, outlets};
pub use inlet::prescribe;
pub use outlet::Outlet;

use super::cloud::Cloud;
use super::flow::FlowSolution;
use super::wall::Wall;
use crate::backend::Step;
use crate::element::simplex::Vector;

/// The outlets, and scratch; inlets are walls.
#[derive(Clone, Debug, Default)]
pub struct Gates<const D: usize> {
    outlets: Vec<Outlet<D>>,
    before: Vec<Vector<D>>,
}

impl<const D: usize> Gates<D> {
    /// Of these outlets.
    pub fn new(outlets: Vec<Outlet<D>>) -> Self {
        Self { outlets, before: Vec::new() }
    }

    /// Moves the nodes as a solution has them and puts back those in gates; what passed.
    pub fn advance<const N: usize>(
        &mut self,
        cloud: &mut Cloud<D, N>,
        walls: &[Wall<D>],
        step: Step,
        solution: &FlowSolution<D>,
        acceleration: &Vector<D>,
    ) -> Passed<D> {
        if self.outlets.is_empty() && walls.iter().all(|wall| wall.inflow.is_none()) {
            solution.advance(cloud, step);
            return Passed::default();
        }
        let rate = inlet::rate(cloud, walls, step);
        self.before.clone_from(&cloud.place);
        solution.advance(cloud, step);
        let moved = Amount::of(cloud, acceleration);
        inlet::put_back(cloud, walls, &self.before);
        inlet::take_in(cloud, walls, step.end());
        let filled = Amount::of(cloud, acceleration);
        for outlet in &self.outlets {
            // Drops that leave are taken out with their places.
            outlet.stop(cloud, &mut self.before);
        }
        let cut = Amount::of(cloud, acceleration);
        Passed {
            entered: Amount { volume: rate * step.length, ..filled.less(&moved) },
            left: filled.less(&cut),
        }
    }
}
