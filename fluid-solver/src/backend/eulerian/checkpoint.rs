//! What a flow needs to go on with the same bits.

use super::flow::Flow;
use super::state::State;
use crate::element::simplex::Vector;
use crate::error::FluidError;
use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use linear::dense;

impl<const D: usize, const N: usize> Flow<D, N> {
    /// Adds the state after a commit, and the coefficient that the preconditioner was made for: it steers the last bits.
    pub fn save_checkpoint<'a>(&'a self, writer: CheckpointWriter<'a>) -> CheckpointWriter<'a> {
        let state = self.state();
        writer
            .array("velocity", state.velocity.as_flattened())
            .array("velocity_older", state.velocity_older.as_flattened())
            .array("pressure", &state.pressure)
            .array("void_fraction", &state.void_fraction)
            .array("void_fraction_older", &state.void_fraction_older)
            .array("acceleration", state.acceleration.as_flattened())
            .array("previous_step", state.previous_step.as_slice())
            .array("mobility", self.work.preconditioning.schur.mobility())
    }

    /// Goes on from a checkpoint.
    ///
    /// # Errors
    /// A damaged checkpoint, or one of another mesh.
    pub fn load_checkpoint(&mut self, checkpoint: &Checkpoint) -> Result<(), FluidError> {
        let nodes = self.mesh.node_count();
        let scalars = |name: &'static str| -> Result<Vec<f64>, FluidError> {
            let values: Vec<f64> = checkpoint.array(name)?;
            if values.len() == nodes {
                Ok(values)
            } else {
                Err(FluidError::OtherMesh { name, found: values.len(), nodes })
            }
        };
        let vectors = |name: &'static str| -> Result<Vec<Vector<D>>, FluidError> {
            let values: Vec<f64> = checkpoint.array(name)?;
            let found = values.len();
            if found == D * nodes {
                Ok(dense::by_node(&values).to_vec())
            } else {
                Err(FluidError::OtherMesh { name, found, nodes })
            }
        };
        let (velocity, void_fraction) = (vectors("velocity")?, scalars("void_fraction")?);
        self.state = State {
            velocity_old: velocity.clone(),
            velocity,
            velocity_older: vectors("velocity_older")?,
            pressure: scalars("pressure")?,
            void_fraction_old: void_fraction.clone(),
            void_fraction,
            void_fraction_older: scalars("void_fraction_older")?,
            acceleration: vectors("acceleration")?,
            previous_step: checkpoint.array("previous_step")?.first().copied(),
        };
        let mobility: Vec<f64> = checkpoint.array("mobility")?;
        if mobility.len() == nodes {
            self.work.preconditioning.schur.refresh(&self.mesh, &self.incidence, &self.outlets, &mobility)?;
        }
        Ok(())
    }
}
