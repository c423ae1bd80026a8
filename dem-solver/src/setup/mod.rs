//! From a checked case to a scene and a world.

mod bonds;
mod clumps;
mod deletion;
mod insert;
mod places;
mod region;
mod sizes;
mod sleep;
mod surroundings;
mod walls;

use std::collections::BTreeMap;

use case_io::document::Case;

use crate::critical_time_step::{Substep, critical_time_step, substeps};
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
    clumps::check_periods(case, &scene)?;
    let (mut world, firsts) = insert::insert(case, &scene)?;
    if grains.domain.is_none() {
        let domain = surroundings::default_domain(&scene, &world, mesh);
        scene = scene.in_domain(domain);
    }
    places::check_places(case, &scene, &world, &firsts)?;
    world.bonds = bonds::bonds(case, &scene, &world, &firsts)?;
    scene.sleep = grains.sleep.as_ref().map(|stated| sleep::bound(stated, &scene, &world));
    let substep = match document.time.substep {
        Some(step) => Substep::Given(step.si()),
        None => Substep::Fraction(document.time.substep_safety),
    };
    check_substeps(case, &scene, &world, substep)?;
    Ok(Setup { scene, world, substep })
}

/// The first window can be stepped through: an impossible substep is found before the run.
fn check_substeps<const D: usize>(
    case: &Case,
    scene: &Scene<D>,
    world: &World<D>,
    substep: Substep,
) -> Result<(), DemError> {
    let critical = critical_time_step(scene, world);
    match substeps(case.document.window(), substep, &critical) {
        Err(DemError::StepTooLarge { step, limit, binding }) => {
            let allowed = format!("at most the critical step {limit:.4e} s, which {binding} sets");
            let advice = "take a smaller substep or a softer material";
            Err(case.error("time.substep", format_args!("found {step} s"), allowed, advice).into())
        }
        Err(DemError::TooManySubsteps { window, step, count, most, .. }) => {
            let found = format!("{window} s takes {count:.3e} substeps of {step:.3e} s");
            let allowed = format!("at most {most} substeps");
            let advice = match substep {
                Substep::Given(_) => "take a shorter window or a longer time.substep".to_string(),
                Substep::Fraction(_) => {
                    format!(
                        "{} sets the substep: take a shorter window or a softer material",
                        critical.binding
                    )
                }
            };
            Err(case.error("time.window", found, allowed, advice).into())
        }
        Err(other) => Err(other),
        Ok(_) => Ok(()),
    }
}

/// The error of an insertion at `key`, told with the key.
fn refused_at(case: &Case, key: &str, error: DemError) -> DemError {
    match error {
        DemError::NoRoom { fitted, wanted, why, .. } => {
            let found = format!("{fitted} of {wanted} grains fitted: {why}");
            case.error(key, found, "", "ask for fewer or smaller grains, or for a larger region").into()
        }
        other => other,
    }
}
