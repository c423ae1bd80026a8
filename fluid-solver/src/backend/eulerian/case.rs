//! From a case to a flow.

use super::backend::Eulerian;
use super::flow::{Flow, Properties};
use crate::backend::{FluidBackend, Response};
use crate::boundary::{Boundaries, Condition, velocity_field};
use crate::element::simplex::Vector;
use crate::error::FluidError;
use crate::mesh::{self, Mesh};
use case_io::document::{Case, Dimension, Fluid};

/// The flow of a case.
///
/// # Errors
/// A mesh or a boundary condition that is refused.
pub fn of(case: &Case, fluid: &Fluid, response: Response) -> Result<Box<dyn FluidBackend>, FluidError> {
    match case.document.case.dimension {
        Dimension::Two => {
            Ok(Box::new(backend::<2, 3>(case, fluid, mesh::case::plane(case, fluid)?, response)?))
        }
        Dimension::Three => {
            Ok(Box::new(backend::<3, 4>(case, fluid, mesh::case::space(case, fluid)?, response)?))
        }
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
