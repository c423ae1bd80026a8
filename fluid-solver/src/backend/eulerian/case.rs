//! From a case to a flow.

use super::backend::{Eulerian, Response};
use super::flow::{Flow, Properties};
use crate::backend::FluidBackend;
use crate::boundary::{Boundaries, Condition, velocity_field};
use crate::element::simplex::Vector;
use crate::error::FluidError;
use crate::mesh::generate::{BentPipe, BoxMesh, Jitter, Pipe};
use crate::mesh::{Mesh, MeshError, gmsh};
use case_io::document::{self, Case, Dimension, Fluid, MeshSource};

/// The flow of a case.
///
/// # Errors
/// A mesh or a boundary condition that is refused.
pub fn of(case: &Case, fluid: &Fluid, response: Response) -> Result<Box<dyn FluidBackend>, FluidError> {
    match case.document.case.dimension {
        Dimension::Two => Ok(Box::new(backend::<2, 3>(case, fluid, plane_mesh(case, fluid)?, response)?)),
        Dimension::Three => Ok(Box::new(backend::<3, 4>(case, fluid, space_mesh(case, fluid)?, response)?)),
    }
}

fn backend<const D: usize, const N: usize>(
    case: &Case,
    fluid: &Fluid,
    mesh: Mesh<D, N>,
    response: Response,
) -> Result<Eulerian<D, N>, FluidError> {
    let table = &case.document.case;
    let properties = Properties {
        density: fluid.density.si(),
        viscosity: fluid.viscosity.si(),
        gravity: table.gravity.to_array(),
        tolerance: fluid.solve_tolerance(),
    };
    let named = fluid.boundary.iter().enumerate().flat_map(|(index, boundary)| {
        boundary.on.iter().enumerate().map(move |(place, name)| (index, place, name, boundary))
    });
    let mut conditions = Vec::new();
    for (index, place, name, boundary) in named {
        if mesh.group(name).is_none() {
            let key = format!("fluid.boundary[{index}].on[{place}]");
            let found = format!("the mesh has no boundary \"{name}\"");
            return Err(case.error(&key, found, mesh.groups().join(", "), "").into());
        }
        conditions.push((name.clone(), Condition::of(boundary)));
    }
    let boundaries = Boundaries::new(&mesh, conditions)?;
    let mut flow = Flow::new(mesh, &boundaries, properties)?;
    let velocity = velocity_field(fluid.velocity.as_ref());
    flow.set_velocity(|x| velocity(x, 0.0));
    if let Some(force) = &fluid.body_force {
        let force: Vector<D> = force.to_array();
        flow.set_body_force(|_| force);
    }
    Ok(Eulerian::new(flow, response, table.depth()))
}

fn plane_mesh(case: &Case, fluid: &Fluid) -> Result<Mesh<2, 3>, FluidError> {
    match fluid.mesh.as_ref().and_then(document::Mesh::source) {
        Some(MeshSource::Box(mesh)) => Ok(generate_box(case, mesh)?),
        Some(MeshSource::Gmsh(file)) => read_gmsh(case, file),
        Some(MeshSource::Pipe(_)) => {
            Err(case.error("fluid.mesh.pipe", "a pipe needs three dimensions", "box, gmsh", "use box").into())
        }
        None => Err(missing(case)),
    }
}

fn space_mesh(case: &Case, fluid: &Fluid) -> Result<Mesh<3, 4>, FluidError> {
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
    case.error("fluid.mesh", "it is missing", "box, pipe, gmsh", "backend \"eulerian\" needs one").into()
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
