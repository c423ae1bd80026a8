//! Materials, laws, walls and the domain of a case.

use case_io::document::{self, Case, WallShape, unit_vector};
use case_io::error::CaseError;

use super::{FluidMesh, at_key};
use crate::contact::NormalLaw;
use crate::contact::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke};
use crate::domain::Domain;
use crate::error::DemError;
use crate::material::{Material, Materials};
use crate::scene::{Escape, Scene};
use crate::vector::{Spin, Vector};
use crate::wall::stl::read_stl;
use crate::wall::{Facet, Motion, Plane, Shape, Wall, Walls};
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
        document::NormalLaw::Hertz => NormalLaw::Hertz(Hertz { depth }),
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
        ..Scene::new(materials(case, normal_law != NormalLaw::None)?, normal_law)
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
    Ok(Materials::new(list.collect::<Result<_, CaseError>>()?, pair))
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

fn walls<const D: usize>(case: &Case, mesh: Option<&FluidMesh<D>>) -> Result<Walls<D>, DemError> {
    let walls = case.document.wall.iter().enumerate().map(|(index, wall)| {
        let key = |key: &str| format!("wall[{index}].{key}");
        let material = material_index(case, &wall.material, &key("material"))?;
        let shapes = match wall.shape() {
            Some(WallShape::Plane(plane)) => vec![Shape::Plane(Plane {
                point: Vector::from(plane.point.to_array()),
                normal: Vector::from(unit_vector(&plane.normal)),
            })],
            Some(WallShape::Stl(stl)) => read_stl(&case.folder.join(&stl.path), stl.scale)
                .map_err(|error| at_key(case, &key("stl.path"), error))?
                .iter()
                .map(spatial::<D>)
                .collect::<Option<_>>()
                .ok_or_else(|| {
                    case.error(
                        &key("stl"),
                        "an STL surface in 2D",
                        "planes and mesh boundaries",
                        "write a plane",
                    )
                })?,
            Some(WallShape::Mesh(boundary)) => {
                of_mesh(case, &key("mesh.boundary"), &boundary.boundary, mesh)?
            }
            None => {
                return Err(case
                    .error(&key("plane"), "missing", "one of plane, stl, mesh", "give the wall a shape")
                    .into());
            }
        };
        Ok(Wall {
            motion: wall.motion.as_ref().map(motion),
            torque_about: wall.torque_about.as_ref().map_or(Vector::zeros(), |point| point.to_array().into()),
            ..Wall::new(&wall.name, material, shapes)
        })
    });
    Ok(Walls::new(walls.collect::<Result<_, DemError>>()?))
}

/// The sum of the stated motions; in 2D the axis of a rotation is z.
fn motion<const D: usize>(document: &document::Motion) -> Motion<D> {
    let none = Motion::none();
    let rotation = document.rotation.as_ref();
    let oscillation = document.oscillation.as_ref();
    Motion {
        translation: document.translation.as_ref().map_or(none.translation, |v| v.to_array().into()),
        amplitude: oscillation.map_or(none.amplitude, |oscillation| {
            Vector::from(unit_vector(&oscillation.direction)) * oscillation.amplitude.si()
        }),
        frequency: oscillation.map_or(none.frequency, |oscillation| oscillation.frequency.si()),
        point: rotation.map_or(none.point, |rotation| rotation.point.to_array().into()),
        angular_velocity: rotation.map_or(none.angular_velocity, |rotation| {
            let axis = rotation.axis.as_deref().map_or([0.0, 0.0, 1.0], unit_vector);
            Spin::from(axis) * rotation.rate.si()
        }),
    }
}

/// A triangle as a piece of wall, which it can only be in 3D.
fn spatial<const D: usize>(triangle: &Facet<3>) -> Option<Shape<D>> {
    (D == 3).then(|| {
        Shape::Facet(Facet {
            vertices: std::array::from_fn(|k| crate::vector::restrict(&triangle.vertices[k])),
        })
    })
}

fn of_mesh<const D: usize>(
    case: &Case,
    key: &str,
    names: &[String],
    mesh: Option<&FluidMesh<D>>,
) -> Result<Vec<Shape<D>>, CaseError> {
    let mut shapes = Vec::new();
    for name in names {
        let boundaries = mesh.map(|mesh| &mesh.boundaries);
        let Some(faces) = boundaries.and_then(|boundaries| boundaries.get(name)) else {
            let allowed = boundaries
                .map_or(String::new(), |known| known.keys().cloned().collect::<Vec<_>>().join(", "));
            return Err(case.error(
                key,
                format_args!("the fluid mesh has no boundary \"{name}\""),
                allowed,
                "",
            ));
        };
        shapes.extend(faces.iter().copied().map(Shape::Facet));
    }
    Ok(shapes)
}

/// Where the case states no domain: the box around the fluid mesh, the facets and the grains; all space where there
/// is neither mesh nor facet, since planes and falling grains have no end.
pub fn default_domain<const D: usize>(
    scene: &Scene<D>,
    world: &World<D>,
    mesh: Option<&FluidMesh<D>>,
) -> Domain<D> {
    let mesh = mesh.map(|mesh| (Vector::from(mesh.bounds.0), Vector::from(mesh.bounds.1)));
    let solid = mesh.into_iter().chain(scene.walls.facet_bounds());
    let grains = world.grains.place.iter().map(|place| (place.centre, place.centre));
    let feeds = world.feeds.iter().map(|feed| (feed.lower, feed.upper));
    if solid.clone().next().is_none() {
        return Domain::unbounded();
    }
    let around = solid.chain(grains).chain(feeds).reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)));
    around.map_or(Domain::unbounded(), |(lower, upper)| Domain { lower, upper, periodic: [false; D] })
}
