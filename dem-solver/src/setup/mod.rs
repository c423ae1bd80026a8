//! From a checked case to a scene and a world.

mod insert;
mod surroundings;

use std::collections::BTreeMap;

use case_io::document::Case;

use crate::critical_time_step::Substep;
use crate::error::DemError;
use crate::scene::Scene;
use crate::wall::Facet;
use crate::world::World;

/// What the grains must know of the fluid's mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct FluidMesh<const D: usize> {
    /// Corners of the box around the mesh \[m\].
    pub bounds: ([f64; D], [f64; D]),
    /// Boundary faces, by the name of the boundary.
    pub boundaries: BTreeMap<String, Vec<Facet<D>>>,
}

/// A case ready to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup<const D: usize> {
    /// What stays the same.
    pub scene: Scene<D>,
    /// The grains at the start.
    pub world: World<D>,
    /// How the case asks for its substep.
    pub substep: Substep,
}

/// Builds scene and world of a case with `[grains]`; `mesh` where there is a fluid.
///
/// # Errors
/// What the case asks for cannot be: each message names the key.
pub fn set_up<const D: usize>(case: &Case, mesh: Option<&FluidMesh<D>>) -> Result<Setup<D>, DemError> {
    let document = &case.document;
    let Some(grains) = &document.grains else {
        return Err(case.error("grains", "missing", "", "add [grains] to a case that has grains").into());
    };
    let mut scene = surroundings::scene(case, grains, mesh)?;
    let world = insert::insert(case, &scene)?;
    if grains.domain.is_none() {
        let domain = surroundings::default_domain(&scene, &world, mesh);
        scene = scene.in_domain(domain);
    }
    insert::check_places(case, &scene, &world)?;
    let substep = match document.time.substep {
        Some(step) => Substep::Given(step.si()),
        None => Substep::Fraction(document.time.substep_safety),
    };
    Ok(Setup { scene, world, substep })
}
