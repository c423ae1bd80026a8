//! Which node a step failed at.

use super::flow::Flow;
use crate::backend::Step;
use crate::element::simplex::{Vector, in_space};
use crate::error::FluidError;

impl<const D: usize, const N: usize> Flow<D, N> {
    /// Looks for numbers in the fields that are not finite.
    ///
    /// # Errors
    /// The first.
    pub(super) fn check_finite(&self, step: Step) -> Result<(), FluidError> {
        for (quantity, field) in [("velocity", &self.state.velocity), ("body force", &self.acceleration)] {
            let faulty = |u: &Vector<D>| u.iter().copied().find(|component| !component.is_finite());
            if let Some((node, value)) = field.iter().enumerate().find_map(|(i, u)| Some((i, faulty(u)?))) {
                return Err(self.not_finite(quantity, node, value, step));
            }
        }
        match self.state.pressure.iter().position(|p| !p.is_finite()) {
            Some(node) => Err(self.not_finite("pressure", node, self.state.pressure[node], step)),
            None => Ok(()),
        }
    }

    /// Where the system of a step stopped being finite, though the fields are.
    pub(super) fn fault_in_rows(&self, step: Step) -> FluidError {
        let place = self.work.right.iter().position(|value| !value.is_finite()).unwrap_or(0);
        let nodes = self.mesh.node_count();
        let node = if place < D * nodes { place / D } else { place - D * nodes };
        self.not_finite("a force", node, self.work.right[place], step)
    }

    fn not_finite(&self, quantity: &'static str, node: usize, value: f64, step: Step) -> FluidError {
        FluidError::NonFinite {
            quantity,
            node,
            position: in_space(&self.mesh.nodes()[node]),
            value,
            time: step.end(),
        }
    }

    /// A matrix that cannot be used: the node behind it where it is known.
    pub(super) fn fault(&self, fault: linear::Error, step: Step) -> FluidError {
        match fault {
            linear::Error::NonFinite { row, value, .. }
            | linear::Error::DiagonalNotPositive { row, value } => {
                self.not_finite("a matrix coefficient", row, value, step)
            }
            other => FluidError::Linear(other),
        }
    }
}
