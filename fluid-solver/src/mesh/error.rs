//! What can be wrong with a mesh.

use std::path::PathBuf;

/// A mesh was refused: what is wrong, where, what was found, what is allowed, what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum MeshError {
    #[error(
        "the mesh has no cells: at least one is needed; check that the volume (in 2D the surface) was meshed and saved"
    )]
    Empty,
    #[error("point {point} has coordinates {position:?}: all must be finite; repair the mesh")]
    NotFinite { point: usize, position: Vec<f64> },
    #[error("{what} {index} refers to point {point}, but the mesh has points 0 to {last}; repair the mesh")]
    NoSuchPoint { what: &'static str, index: usize, point: u32, last: usize },
    #[error(
        "point {point} at {position:?} belongs to no cell: every point must be a corner of a cell; delete it"
    )]
    UnreferencedPoint { point: usize, position: Vec<f64> },
    #[error(
        "cell {cell} with points {points:?} is {}: its volume {volume:e} must be positive, above 1e-12 of its \
         longest edge to the power of the dimension; {}",
        if *volume < 0.0 { "inverted" } else { "degenerate" },
        if *volume < 0.0 { "swap two of its points" } else { "remesh there" }
    )]
    CellVolume { cell: usize, points: Vec<u32>, volume: f64 },
    #[error("face {points:?} is shared by {} cells {cells:?}: at most two may meet at a face; remove the overlapping cells", cells.len())]
    FaceShared { points: Vec<u32>, cells: Vec<u32> },
    #[error(
        "boundary face {points:?} of cell {cell}, centre {centre:?}, is in no physical group: every boundary face needs \
         one; add its line or surface to a physical group"
    )]
    FaceWithoutGroup { points: Vec<u32>, cell: u32, centre: Vec<f64> },
    #[error(
        "face {points:?} of group \"{group}\" is not on the boundary of the mesh: groups hold boundary faces only; \
         take inner faces out of the group"
    )]
    FaceNotOnBoundary { points: Vec<u32>, group: String },
    #[error(
        "face {points:?} is listed twice, in groups \"{first}\" and \"{second}\": one entry is allowed; keep one of them"
    )]
    FaceListedTwice { points: Vec<u32>, first: String, second: String },
    #[error("face {face} has group number {group}, but there are {count} groups; repair the mesh")]
    NoSuchGroup { face: usize, group: u32, count: usize },
    #[error("physical group \"{group}\" holds no face: every named group must; fill it or delete it")]
    EmptyGroup { group: String },
    #[error(
        "the mesh falls apart: cell {cell} with points {points:?} cannot be reached from cell 0 through faces \
         ({reached} of {cells} cells can): it must be connected; merge the coincident points or keep one part"
    )]
    Disconnected { cell: usize, points: Vec<u32>, reached: usize, cells: usize },
    #[error(
        "periodic pair {image} → {master} along axis {axis} is displaced by {displacement:?}: all pairs of an axis must \
         differ by the same shift along it, here {length}; make both sides identical"
    )]
    PeriodicPair { axis: usize, image: u32, master: u32, displacement: Vec<f64>, length: f64 },
    #[error(
        "point {point} at {position:?} lies outside the period [{lower}, {upper}] of axis {axis}: a periodic mesh must fill \
         exactly one period; correct the periodic sides"
    )]
    OutsidePeriod { point: usize, position: Vec<f64>, axis: usize, lower: f64, upper: f64 },
    #[error(
        "cell {cell} with points {points:?} has one node at two of its corners: at least three cells are needed along a \
         periodic axis; refine along it"
    )]
    PeriodicCell { cell: usize, points: Vec<u32> },
    #[error(
        "boundary faces {first:?} and {second:?} are images of the same nodes: at least three cells are needed along a \
         periodic axis; refine along it"
    )]
    PeriodicFaces { first: Vec<u32>, second: Vec<u32> },
    #[error("axis {axis} is periodic with {found}: {allowed}; correct the periodic sides")]
    PeriodicAxis { axis: usize, found: String, allowed: &'static str },
    #[error("{generator}: {key} is {found}, allowed is {allowed}; change it")]
    Generator { generator: &'static str, key: &'static str, found: String, allowed: &'static str },
    #[error("{}{place}: found {found}, expected {expected}; {advice}", file.display())]
    File { file: PathBuf, place: Place, found: String, expected: String, advice: &'static str },
}

/// Where in a mesh file an error is; its text follows the path of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Line of a text file, from 1.
    Line(usize),
    /// Offset in a binary section, from 0.
    Byte(usize),
    /// The file as a whole.
    File,
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Place::Line(line) => write!(f, ":{line}"),
            Place::Byte(byte) => write!(f, ": byte {byte}"),
            Place::File => Ok(()),
        }
    }
}
