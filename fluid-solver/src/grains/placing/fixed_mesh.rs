//! Grains in a mesh that fills its vessel and stays: a grain is wet if its centre is in a cell.

use super::Placing;
use crate::error::FluidError;
use crate::mesh::Mesh;
use crate::mesh::locate::Locator;
use crate::void_fraction::{Grain, NodeKernel, VoidFractionError, Weights};
use interface::frames::GrainRow;

/// Search and kernel of one mesh.
pub struct FixedMesh<const D: usize> {
    locator: Locator<D>,
    kernel: Option<NodeKernel<D>>,
    /// Smallest and largest diameter that the kernel is made for (m).
    diameters: Option<[f64; 2]>,
    hosts: Vec<Option<u32>>,
}

impl<const D: usize> FixedMesh<D> {
    /// Without a kernel.
    pub fn new<const N: usize>(mesh: &Mesh<D, N>) -> Self {
        Self { locator: Locator::new(mesh), kernel: None, diameters: None, hosts: Vec::new() }
    }

    /// Where points are.
    pub fn locator(&self) -> &Locator<D> {
        &self.locator
    }

    /// The range of diameters that the weights depend on; a checkpoint holds it.
    pub fn diameters(&self) -> Option<&[f64; 2]> {
        self.diameters.as_ref()
    }

    /// Makes the kernel for a range of diameters.
    ///
    /// # Errors
    /// A range that is not positive and finite.
    pub fn prepare<const N: usize>(
        &mut self,
        mesh: &Mesh<D, N>,
        range: Option<[f64; 2]>,
    ) -> Result<(), FluidError> {
        self.kernel = match range {
            None => None,
            Some([smallest, largest]) => Some(NodeKernel::new(mesh, smallest..=largest)?),
        };
        self.diameters = range;
        Ok(())
    }

    /// Takes other grains: widens the kernel's range of diameters where theirs needs it.
    ///
    /// # Errors
    /// A diameter that is not positive and finite.
    pub fn admit<const N: usize>(&mut self, mesh: &Mesh<D, N>, rows: &[GrainRow]) -> Result<(), FluidError> {
        self.hosts.clear();
        let smallest = rows.iter().map(|row| 2.0 * row.radius).fold(f64::INFINITY, f64::min);
        let largest = rows.iter().map(|row| 2.0 * row.radius).fold(f64::NEG_INFINITY, f64::max);
        let range = match self.diameters {
            _ if rows.is_empty() => return Ok(()),
            Some([low, high]) if low <= smallest && largest <= high => return Ok(()),
            Some([low, high]) => [low.min(smallest), high.max(largest)],
            None => [smallest, largest],
        };
        self.prepare(mesh, Some(range))
    }
}

impl<const D: usize, const N: usize> Placing<D, N> for FixedMesh<D> {
    fn place(
        &mut self,
        mesh: &Mesh<D, N>,
        grains: &[Grain<D>],
        weights: &mut Weights,
        wetted: &mut Vec<f64>,
    ) -> Result<(), VoidFractionError> {
        if let Some(kernel) = &self.kernel {
            kernel.weigh(mesh, &self.locator, grains, &mut self.hosts, weights)?;
        }
        wetted.clear();
        wetted.extend(self.hosts.iter().map(|host| f64::from(u8::from(host.is_some()))));
        Ok(())
    }
}
