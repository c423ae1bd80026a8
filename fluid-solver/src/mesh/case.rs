//! The mesh of a case.

use super::generate::{BentPipe, BoxMesh, Jitter, Pipe};
use super::{Mesh, MeshError, gmsh};
use crate::error::FluidError;
use case_io::document::{self, Case, Fluid, MeshSource};

/// The mesh of a case in the plane.
///
/// # Errors
/// A mesh that is refused, or not stated.
pub fn plane(case: &Case, fluid: &Fluid) -> Result<Mesh<2, 3>, FluidError> {
    match fluid.mesh.as_ref().and_then(document::Mesh::source) {
        Some(MeshSource::Box(mesh)) => Ok(generate_box(case, mesh)?),
        Some(MeshSource::Gmsh(file)) => read_gmsh(case, file),
        Some(MeshSource::Pipe(_)) => {
            Err(case.error("fluid.mesh.pipe", "a pipe needs three dimensions", "box, gmsh", "use box").into())
        }
        None => Err(missing(case)),
    }
}

/// The mesh of a case in space.
///
/// # Errors
/// A mesh that is refused, or not stated.
pub fn space(case: &Case, fluid: &Fluid) -> Result<Mesh<3, 4>, FluidError> {
    match fluid.mesh.as_ref().and_then(document::Mesh::source) {
        Some(MeshSource::Box(mesh)) => Ok(generate_box(case, mesh)?),
        Some(MeshSource::Gmsh(file)) => read_gmsh(case, file),
        Some(MeshSource::Pipe(pipe)) => generate_pipe(case, pipe),
        None => Err(missing(case)),
    }
}

fn read_gmsh<const D: usize, const N: usize>(
    case: &Case,
    file: &document::GmshFile,
) -> Result<Mesh<D, N>, FluidError> {
    let path = case.folder.join(&file.path);
    let mesh = gmsh::read(&path).map_err(|error| {
        let found = match error {
            MeshError::File { .. } => error.to_string(),
            _ => format!("{}: {error}", path.display()),
        };
        case.error("fluid.mesh.gmsh.path", found, "", "")
    })?;
    Ok(mesh.scaled(file.scale))
}

fn missing(case: &Case) -> FluidError {
    case.error("fluid.mesh", "it is missing", "box, pipe, gmsh", "the backend needs one").into()
}

fn generate_box<const D: usize, const N: usize>(
    case: &Case,
    mesh: &document::BoxMesh,
) -> Result<Mesh<D, N>, FluidError> {
    let seed = case.document.case.seed;
    let periodic = std::array::from_fn(|axis| mesh.periodic.iter().any(|other| other.index() == axis));
    let (lower, upper, cells) = (mesh.lower.to_array(), mesh.upper.to_array(), mesh.cells());
    let jitter = (mesh.jitter > 0.0).then_some(Jitter { fraction: mesh.jitter, seed });
    Ok(BoxMesh { lower, upper, cells, periodic, jitter }.generate()?)
}

fn generate_pipe(case: &Case, pipe: &document::PipeMesh) -> Result<Mesh<3, 4>, FluidError> {
    let size = pipe.size.si();
    let along = |length: f64| (length / size).ceil().max(1.0) as usize;
    let (radius, length) = (pipe.radius.si(), pipe.length.si());
    let rings = along(radius);
    let (Some(bend_radius), Some(angle)) = (pipe.bend_radius, pipe.bend_angle) else {
        return Ok(Pipe { radius, length, rings, layers: along(length) }.generate()?);
    };
    let Some(outlet) = pipe.outlet_length else {
        let advice = "state the length of the straight part behind the bend";
        return Err(case.error("fluid.mesh.pipe.outlet-length", "it is missing", "a length", advice).into());
    };
    let (bend_radius, angle, outlet) = (bend_radius.si(), angle.si(), outlet.si());
    let layers = [along(length), along(bend_radius * angle), along(outlet)];
    Ok(BentPipe { radius, rings, bend_radius, angle, legs: [length, outlet], layers }.generate()?)
}
