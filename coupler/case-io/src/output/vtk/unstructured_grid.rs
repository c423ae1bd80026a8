//! VTU: a mesh of lines, triangles or tetrahedra with fields on its nodes and cells.

use std::path::Path;

use super::document::{Document, Format};
use super::field::{Field, position_bytes};
use crate::output::OutputError;

/// A simplicial mesh in D dimensions whose cells have N nodes: lines (2), triangles (3) or tetrahedra (4).
///
/// N is free of D: triangles in 3D are a surface.
#[derive(Debug, Clone, Copy)]
pub struct UnstructuredGrid<'a, const D: usize, const N: usize> {
    /// Node positions \[m\].
    pub points: &'a [[f64; D]],
    /// Node numbers of every cell.
    pub cells: &'a [[u32; N]],
    /// Fields with one row per node.
    pub point_fields: &'a [Field<'a>],
    /// Fields with one row per cell.
    pub cell_fields: &'a [Field<'a>],
}

impl<const D: usize, const N: usize> UnstructuredGrid<'_, D, N> {
    /// VTK's number for the cell: line 3, triangle 5, tetrahedron 10.
    const CELL_TYPE: u8 = match N {
        2 => 3,
        3 => 5,
        4 => 10,
        _ => panic!("cells are lines, triangles or tetrahedra"),
    };

    /// Writes a `.vtu` file.
    ///
    /// # Errors
    /// A field whose rows do not match, a cell that names a node beyond the last, or a file that cannot be written.
    pub fn write(&self, path: &Path, format: Format) -> Result<(), OutputError> {
        const { assert!(D == 2 || D == 3) }
        let nodes = self.points.len();
        if let Some((cell, node)) =
            self.cells.iter().enumerate().find_map(|(cell, row)| {
                row.iter().find(|&&node| node as usize >= nodes).map(|node| (cell, node))
            })
        {
            return Err(OutputError::Inconsistent {
                path: path.to_path_buf(),
                what: format!("node number in cell {cell}"),
                found: node.to_string(),
                expected: format!("below the number of nodes, {nodes}"),
            });
        }

        let connectivity: Vec<i64> = self.cells.as_flattened().iter().map(|&node| i64::from(node)).collect();
        let ends: Vec<i64> = (1..=self.cells.len()).map(|cell| (cell * N) as i64).collect();
        let types = vec![Self::CELL_TYPE; self.cells.len()];

        let mut document = Document::new("UnstructuredGrid", format);
        document.tag("Points");
        document.array("points", "Float64", 3, &position_bytes(self.points));
        document.tag("/Points");
        document.tag("Cells");
        document.array("connectivity", "Int64", 1, bytemuck::cast_slice(&connectivity));
        document.array("offsets", "Int64", 1, bytemuck::cast_slice(&ends));
        document.array("types", "UInt8", 1, &types);
        document.tag("/Cells");
        document.fields(path, "PointData", self.point_fields, nodes)?;
        document.fields(path, "CellData", self.cell_fields, self.cells.len())?;
        document.write(path, &[("NumberOfPoints", nodes), ("NumberOfCells", self.cells.len())])
    }
}
