//! VTP: grains as points with a vertex each, so that ParaView shows them without a filter.

use std::path::Path;

use super::document::{Document, Format};
use super::field::{Field, position_bytes};
use crate::output::OutputError;

/// Grains as points; `radius`, `velocity` and the like are fields.
#[derive(Debug, Clone, Copy)]
pub struct GrainPoints<'a, const D: usize> {
    /// Centres \[m\].
    pub centres: &'a [[f64; D]],
    /// Fields with one row per grain.
    pub fields: &'a [Field<'a>],
}

impl<const D: usize> GrainPoints<'_, D> {
    /// Writes a `.vtp` file.
    ///
    /// # Errors
    /// A field whose rows do not match, or a file that cannot be written.
    pub fn write(&self, path: &Path, format: Format) -> Result<(), OutputError> {
        const { assert!(D == 2 || D == 3) }
        let count = self.centres.len();
        let connectivity: Vec<i64> = (0..count as i64).collect();
        let ends: Vec<i64> = (1..=count as i64).collect();

        let mut document = Document::new("PolyData", format);
        document.tag("Points");
        document.array("points", "Float64", 3, &position_bytes(self.centres));
        document.tag("/Points");
        document.tag("Verts");
        document.array("connectivity", "Int64", 1, bytemuck::cast_slice(&connectivity));
        document.array("offsets", "Int64", 1, bytemuck::cast_slice(&ends));
        document.tag("/Verts");
        document.fields(path, "PointData", self.fields, count)?;
        document.write(
            path,
            &[
                ("NumberOfPoints", count),
                ("NumberOfVerts", count),
                ("NumberOfLines", 0),
                ("NumberOfStrips", 0),
                ("NumberOfPolys", 0),
            ],
        )
    }
}
