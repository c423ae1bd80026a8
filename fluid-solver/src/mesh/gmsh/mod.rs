//! Meshes in the MSH format of Gmsh, versions 2.2 and 4.1, text and binary.
//!
//! Cells are the triangles (2D, in a plane of constant z) or tetrahedra (3D); the named physical groups of lines or
//! triangles are the boundary. Elements of lower dimension and nodes that no cell uses (centres of arcs) are passed
//! over; triangles are turned counter-clockwise, for Gmsh orients them like their surface. Periodic sides must be shifted
//! along an axis.

mod content;
mod element_type;
mod source;
mod version2;
mod version4;

use super::{Mesh, MeshError, Place};
use content::Content;
use source::Source;
use std::path::Path;

/// Reads a mesh from a file.
///
/// # Errors
/// An unreadable or damaged file, another version, element types other than linear simplices, groups without a name,
/// and all that [`Mesh::new`] refuses.
pub fn read<const D: usize, const N: usize>(file: &Path) -> Result<Mesh<D, N>, MeshError> {
    let bytes = std::fs::read(file).map_err(|error| MeshError::File {
        file: file.to_path_buf(),
        place: Place::File,
        found: error.to_string(),
        expected: "a readable file".into(),
        advice: "check the path",
    })?;
    parse(file, &bytes)
}

/// Reads a mesh from the bytes of a file; `file` is named in errors.
///
/// # Errors
/// As [`read`].
pub fn parse<const D: usize, const N: usize>(file: &Path, bytes: &[u8]) -> Result<Mesh<D, N>, MeshError> {
    let mut source = Source::new(file, bytes);
    let version = read_format(&mut source)?;
    let mut content = Content::default();
    let mut entities = version4::Entities::default();
    while let Some(section) = source.open_section()? {
        match (section, version) {
            ("PhysicalNames", _) => content.read_names(&mut source)?,
            ("Entities", Version::Four) => entities.read(&mut source)?,
            ("Nodes", Version::Two) => version2::read_nodes(&mut source, &mut content)?,
            ("Nodes", Version::Four) => version4::read_nodes(&mut source, &mut content)?,
            ("Elements", Version::Two) => version2::read_elements(&mut source, &mut content)?,
            ("Elements", Version::Four) => version4::read_elements(&mut source, &entities, &mut content)?,
            ("Periodic", Version::Two) => version2::read_periodic(&mut source, &mut content)?,
            ("Periodic", Version::Four) => version4::read_periodic(&mut source, &mut content)?,
            _ => {
                source.skip_section(section)?;
                continue;
            }
        }
        source.close_section(section)?;
    }
    Mesh::new(content.into_parts(&source)?)
}

#[derive(Clone, Copy)]
enum Version {
    Two,
    Four,
}

/// Reads `$MeshFormat` and sets the source to binary if the file is.
fn read_format(source: &mut Source) -> Result<Version, MeshError> {
    const ADVICE: &str = "export as MSH 2.2 or 4.1 from Gmsh";
    let head = source.word().unwrap_or_default();
    if head != "$MeshFormat" {
        let shown: String = head.chars().take(40).collect();
        return Err(source.error(format!("\"{shown}\""), "$MeshFormat", ADVICE));
    }
    let version = match source.word()? {
        "2.2" => Version::Two,
        "4.1" => Version::Four,
        other => return Err(source.error(format!("version {other}"), "version 2.2 or 4.1", ADVICE)),
    };
    let kind: i32 = source.text("0 for text or 1 for binary")?;
    let size: i32 = source.text("the size of a number, 8")?;
    if !(0..=1).contains(&kind) || size != 8 {
        return Err(source.error(
            format!("file type {kind}, data size {size}"),
            "file type 0 or 1, data size 8",
            ADVICE,
        ));
    }
    if kind == 1 {
        source.end_line()?;
        source.set_binary();
        let one = source.int()?;
        if one != 1 {
            return Err(source.error(
                format!("{one} as the number one"),
                "little-endian bytes",
                "export as text",
            ));
        }
    }
    source.close_section("MeshFormat")?;
    Ok(version)
}
