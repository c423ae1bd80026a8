//! What the flow writes: statistics and frames.

use super::flow::Flow;
use crate::element::simplex::{Vector, dot};
use crate::error::FluidError;
use case_io::output::vtk::{Compression, Field, Format, Precision, UnstructuredGrid};
use std::path::{Path, PathBuf};

impl<const D: usize, const N: usize> Flow<D, N> {
    /// Integrals (those of a slab of `depth` in 2D) and extremes: name with unit, value.
    pub fn statistics(&self, depth: f64) -> Vec<(&'static str, f64)> {
        const NAMES: [&str; 3] = ["momentum-x[kg m/s]", "momentum-y[kg m/s]", "momentum-z[kg m/s]"];
        let (state, measure) = (self.state(), self.mesh().measure());
        let density = self.properties().density;
        let weighted = |value: &dyn Fn(usize) -> f64| {
            let share = |(i, measure): (usize, &f64)| measure * state.void_fraction[i] * value(i);
            depth * measure.iter().enumerate().map(share).sum::<f64>()
        };
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NEG_INFINITY, f64::max);
        let smallest = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
        let speed = |u: &Vector<D>| dot(u, u).sqrt();
        let mut statistics = vec![("volume[m^3]", weighted(&|_| 1.0))];
        statistics.extend((0..D).map(|k| (NAMES[k], density * weighted(&|i| state.velocity[i][k]))));
        statistics.extend([
            ("kinetic-energy[J]", 0.5 * density * weighted(&|i| dot(&state.velocity[i], &state.velocity[i]))),
            ("speed-max[m/s]", largest(&mut state.velocity.iter().map(speed))),
            ("pressure-min[Pa]", smallest(&mut state.pressure.iter().copied())),
            ("pressure-max[Pa]", largest(&mut state.pressure.iter().copied())),
            ("void-fraction-min[-]", smallest(&mut state.void_fraction.iter().copied())),
        ]);
        statistics
    }

    /// Writes velocity, pressure and void fraction on all points, periodic images included, to a VTU file.
    ///
    /// # Errors
    /// The disk's.
    pub fn write_frame(&self, path: &Path, compress: bool) -> Result<PathBuf, FluidError> {
        let (mesh, state) = (self.mesh(), self.state());
        let nodes = || (0..mesh.points().len() as u32).map(|point| mesh.node_of(point) as usize);
        let velocity: Vec<Vector<D>> = nodes().map(|node| state.velocity[node]).collect();
        let pressure: Vec<f64> = nodes().map(|node| state.pressure[node]).collect();
        let void_fraction: Vec<f64> = nodes().map(|node| state.void_fraction[node]).collect();
        let grid = UnstructuredGrid {
            points: mesh.points(),
            cells: mesh.cells(),
            point_fields: &[
                Field::vector("velocity", &velocity),
                Field::scalar("pressure", &pressure),
                Field::scalar("void_fraction", &void_fraction),
            ],
            cell_fields: &[],
        };
        let compression = if compress { Compression::Lz4 } else { Compression::None };
        grid.write(path, Format { precision: Precision::default(), compression })?;
        Ok(path.to_path_buf())
    }
}
