//! Structured meshes of simple domains.

mod box_mesh;
mod disc;
mod jitter;
mod pipe;

pub use box_mesh::BoxMesh;
pub(crate) use disc::Disc;
pub use jitter::Jitter;
pub use pipe::{BentPipe, Pipe};

use super::topology::exposed_faces;
use super::{Mesh, MeshError, MeshParts, PeriodicPairs};
use crate::element::simplex::Vector;

/// Most points a generator makes: indices are 32-bit, and a cell has several times as many faces.
const MOST_POINTS: usize = 1 << 27;

/// Puts every exposed face into the group that `group_of` says, then checks and links the mesh.
fn assemble<const D: usize, const N: usize>(
    points: Vec<Vector<D>>,
    cells: Vec<[u32; N]>,
    groups: Vec<String>,
    periodic: Vec<PeriodicPairs>,
    group_of: impl Fn(&[u32; D]) -> Option<u32>,
) -> Result<Mesh<D, N>, MeshError> {
    let faces = exposed_faces::<D, N>(&cells);
    let boundary =
        faces.iter().filter_map(|face| group_of(&face.key).map(|group| (face.key, group))).collect();
    Mesh::new(MeshParts { points, cells, boundary, groups, periodic })
}

/// A number that must be positive and finite.
fn positive(generator: &'static str, key: &'static str, value: f64) -> Result<(), MeshError> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(MeshError::Generator {
        generator,
        key,
        found: value.to_string(),
        allowed: "a positive finite length",
    })
}

/// A count of cells that must be at least `least`.
fn at_least(
    generator: &'static str,
    key: &'static str,
    least: usize,
    value: usize,
    allowed: &'static str,
) -> Result<(), MeshError> {
    if value >= least {
        return Ok(());
    }
    Err(MeshError::Generator { generator, key, found: value.to_string(), allowed })
}

/// The number of points, refused if it is too large.
fn count_points(generator: &'static str, factors: &[usize]) -> Result<usize, MeshError> {
    let total = factors.iter().try_fold(1usize, |total, &factor| total.checked_mul(factor));
    total.filter(|&total| total <= MOST_POINTS).ok_or_else(|| MeshError::Generator {
        generator,
        key: "cells",
        found: format!("{factors:?} points"),
        allowed: "at most 2^27 points in all",
    })
}
