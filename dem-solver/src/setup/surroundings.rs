//! Materials, laws and the domain of a case.

use case_io::document::{self, Case};
use case_io::error::CaseError;

use super::FluidMesh;
use super::bonds::laws;
use super::clumps::kinds;
use super::deletion::deletions;
use super::walls::walls;
use crate::contact::cohesion::CohesionLaw;
use crate::contact::lubrication::Lubrication;
use crate::contact::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Onate};
use crate::contact::rolling::RollingLaw;
use crate::contact::twisting::TwistingLaw;
use crate::contact::{Extras, NormalLaw};
use crate::domain::Domain;
use crate::error::DemError;
use crate::insertion::Space;
use crate::material::{Material, Materials, PairMaterial};
use crate::scene::{Escape, Scene};
use crate::vector::Vector;
use crate::world::World;

/// The scene of a case, in the domain it states or in all space.
pub fn scene<const D: usize>(
    case: &Case,
    grains: &document::Grains,
    mesh: Option<&FluidMesh<D>>,
) -> Result<Scene<D>, DemError> {
    let document = &case.document;
    let depth = document.case.depth();
    let characteristic_velocity = || {
        let stated = grains.characteristic_velocity.map(|velocity| velocity.si());
        let advice = "state it: a linear law finds its stiffness from it";
        stated.ok_or_else(|| case.error("grains.characteristic-velocity", "missing", "a velocity", advice))
    };
    let normal_law = match grains.normal_law {
        document::NormalLaw::None => NormalLaw::None,
        document::NormalLaw::Hertz => match grains.tangential_law {
            None | Some(document::TangentialLaw::Coulomb) => NormalLaw::Hertz(Hertz { depth }),
            Some(document::TangentialLaw::PartialSlip) => NormalLaw::HertzPartialSlip(Hertz { depth }),
        },
        document::NormalLaw::Onate => {
            NormalLaw::Onate(Onate { area_factor: grains.area_factor.unwrap_or(1.0), depth })
        }
        document::NormalLaw::LiggghtsHertz => NormalLaw::LiggghtsHertz(LiggghtsHertz),
        document::NormalLaw::Hooke => {
            NormalLaw::Hooke(Hooke { characteristic_velocity: characteristic_velocity()?, depth })
        }
        document::NormalLaw::LiggghtsHooke => {
            NormalLaw::LiggghtsHooke(LiggghtsHooke { characteristic_velocity: characteristic_velocity()? })
        }
    };
    Ok(Scene {
        escape: match grains.escape {
            document::Escape::Stop => Escape::Stop,
            document::Escape::Remove => Escape::Remove,
        },
        gravity: Vector::from(document.case.gravity.to_array()),
        depth,
        walls: walls(case, mesh)?,
        deletions: deletions(case)?,
        ..Scene::new(materials(case, normal_law != NormalLaw::None)?, normal_law)
            .with_extras(extras(grains))
            .with_bond_laws(laws(case))
            .with_clumps(kinds::<D>(case)?)
            .in_domain(stated_domain(case, grains)?)
    })
}

/// Index of a material of the case: materials count in the order of their names.
pub fn material_index(case: &Case, name: &str, key: &str) -> Result<u32, CaseError> {
    let names = case.document.materials.keys();
    let index = names.clone().position(|known| known == name);
    index.map(|index| index as u32).ok_or_else(|| {
        let allowed = names.cloned().collect::<Vec<_>>().join(", ");
        case.error(key, format_args!("unknown material \"{name}\""), allowed, "")
    })
}

fn materials(case: &Case, touch: bool) -> Result<Materials, CaseError> {
    let document = &case.document;
    let needed = |name: &str, key: &str, value: Option<f64>| match value {
        Some(value) => Ok(value),
        None if touch => Err(case.error(
            &format!("materials.{name}.{key}"),
            "missing",
            "",
            "state it: grains touch in this case",
        )),
        // Nothing touches: the value is never used.
        None => Ok(1.0),
    };
    let list = document.materials.iter().map(|(name, material)| {
        Ok(Material {
            density: material.density.si(),
            youngs_modulus: needed(
                name,
                "youngs-modulus",
                material.youngs_modulus.map(|modulus| modulus.si()),
            )?,
            poissons_ratio: needed(name, "poissons-ratio", material.poissons_ratio)?,
        })
    });
    let names: Vec<&String> = document.materials.keys().collect();
    // Loading has checked that every pair that can touch is stated.
    let pair = |a: usize, b: usize| {
        document.pair(names[a], names[b]).map_or((1.0, 0.0), |pair| (pair.restitution, pair.sliding_friction))
    };
    let more = |a: usize, b: usize, of: &mut PairMaterial| {
        let Some(pair) = document.pair(names[a], names[b]) else { return };
        of.rolling_friction = pair.rolling_friction.unwrap_or(0.0);
        of.rolling_damping_ratio = pair.rolling_damping_ratio.unwrap_or(0.0);
        of.cohesion_energy_density = pair.cohesion_energy_density.map_or(0.0, |density| density.si());
        of.work_of_adhesion = pair.work_of_adhesion.map_or(0.0, |work| work.si());
        of.surface_tension = pair.surface_tension.map_or(0.0, |tension| tension.si());
        of.contact_angle = pair.contact_angle.map_or(0.0, |angle| angle.si());
        of.bridge_volume_ratio = pair.bridge_volume_ratio.unwrap_or(0.0);
    };
    let micro = |index: usize| document.materials[names[index]].micro;
    Ok(Materials::new(list.collect::<Result<_, CaseError>>()?, pair).with(more).with_micro(micro))
}

fn extras(grains: &document::Grains) -> Extras {
    Extras {
        rolling: grains.rolling_law.map(|law| match law {
            document::RollingLaw::Cdt => RollingLaw::Cdt,
            document::RollingLaw::Epsd => RollingLaw::Epsd,
            document::RollingLaw::Epsd2 => RollingLaw::Epsd2,
        }),
        twisting: grains.twisting_law.map(|law| match law {
            document::TwistingLaw::Marshall => TwistingLaw::Marshall,
        }),
        lubrication: grains.lubrication.map(|film| Lubrication {
            viscosity: film.viscosity.si(),
            roughness: film.roughness.si(),
            cut_off: film.cut_off.si(),
        }),
        cohesion: grains.cohesion_law.map(|law| match law {
            document::CohesionLaw::Sjkr => CohesionLaw::Sjkr,
            document::CohesionLaw::Sjkr2 => CohesionLaw::Sjkr2,
            document::CohesionLaw::Dmt => CohesionLaw::Dmt,
            document::CohesionLaw::Jkr => CohesionLaw::Jkr,
            document::CohesionLaw::Capillary => CohesionLaw::Capillary,
        }),
    }
}

fn stated_domain<const D: usize>(case: &Case, grains: &document::Grains) -> Result<Domain<D>, CaseError> {
    let Some(bounds) = &grains.domain else {
        if grains.periodic.is_empty() {
            return Ok(Domain::unbounded());
        }
        let advice = "state grains.domain: its ends are where the axis wraps";
        return Err(case.error("grains.periodic", "there is no domain that could wrap", "", advice));
    };
    let mut periodic = [false; D];
    for axis in &grains.periodic {
        periodic[axis.index()] = true;
    }
    Ok(Domain::new(bounds.lower.to_array(), bounds.upper.to_array()).periodic(periodic))
}

/// Where the case states no domain: the box around the fluid mesh, the walls that have ends and the grains; all space
/// where there is neither, since planes and falling grains have no end.
pub fn default_domain<const D: usize>(
    scene: &Scene<D>,
    world: &World<D>,
    mesh: Option<&FluidMesh<D>>,
) -> Domain<D> {
    let mesh = mesh.map(|mesh| (Vector::from(mesh.bounds.0), Vector::from(mesh.bounds.1)));
    let solid = mesh.into_iter().chain(scene.walls.bounds());
    let grains = world.grains.place.iter().map(|place| (place.at(), place.at()));
    let feeds = world.feeds.iter().map(|feed| feed.region.bounds());
    if solid.clone().next().is_none() {
        return Domain::unbounded();
    }
    let around = solid.chain(grains).chain(feeds).reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)));
    around.map_or(Domain::unbounded(), |(lower, upper)| Domain { lower, upper, periodic: [false; D] })
}
