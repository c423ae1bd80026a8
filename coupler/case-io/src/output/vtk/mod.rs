//! Frames for ParaView: unstructured grids (VTU), grains as points (VTP), and the collection that dates them (PVD).
//!
//! VTK's XML format with raw appended data: `header_type="UInt64"`, little-endian, points and cell fields in f64 or
//! f32, optionally in LZ4 blocks. Source: VTK file formats, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>.

mod appended;
mod collection;
mod document;
mod field;
mod frame;
mod grain_points;
mod unstructured_grid;

pub use appended::Compression;
pub use collection::{Collection, CollectionEntry};
pub use document::Format;
pub use field::{Field, Precision};
pub use frame::{Frame, FrameField};
pub use grain_points::GrainPoints;
pub use unstructured_grid::UnstructuredGrid;
