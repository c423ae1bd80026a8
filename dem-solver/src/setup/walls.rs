//! The walls of a case.

use case_io::document::{self, Case, WallShape, unit_vector};
use case_io::error::CaseError;

use super::FluidMesh;
use super::surroundings::material_index;
use crate::error::DemError;
use crate::vector::{Vector, restrict};
use crate::wall::{Cylinder, Disc, Facet, Plane, Servo, Shape, Side, Sphere, Tube, Wall, Walls};
use surface::case::{motion, triangles as read_triangles};
use surface::triangles::Format;

/// The walls of a case.
pub fn walls<const D: usize>(case: &Case, mesh: Option<&FluidMesh<D>>) -> Result<Walls<D>, DemError> {
    let walls = case.document.wall.iter().enumerate().map(|(index, wall)| {
        let key = |key: &str| format!("wall[{index}].{key}");
        let named = wall.material.as_deref().ok_or_else(|| {
            case.error(&key("material"), "missing", "", "grains touch the wall: name one of [materials.*]")
        })?;
        let material = material_index(case, named, &key("material"))?;
        let shapes = match wall.shape() {
            Some(WallShape::Plane(stated)) => vec![Shape::Plane(plane(stated))],
            Some(WallShape::Cylinder(stated)) => cylinder(stated),
            Some(WallShape::Sphere(stated)) => vec![sphere(stated)],
            Some(WallShape::Polyline(line)) => polyline(line),
            Some(WallShape::Stl(file)) => triangles(case, &key("stl"), Format::Stl, file)?,
            Some(WallShape::Obj(file)) => triangles(case, &key("obj"), Format::Obj, file)?,
            Some(WallShape::Mesh(boundary)) => {
                of_mesh(case, &key("mesh.boundary"), &boundary.boundary, mesh)?
            }
            None => {
                return Err(case.error(&key("plane"), "missing", "a shape", "give the wall one").into());
            }
        };
        Ok(Wall {
            motion: wall.motion.as_ref().map(|stated| motion(case, &key("motion"), stated)).transpose()?,
            servo: wall.servo.as_ref().map(servo),
            torque_about: wall.torque_about.as_ref().map_or(Vector::zeros(), |point| point.to_array().into()),
            ..Wall::new(&wall.name, material, shapes)
        })
    });
    Ok(Walls::new(walls.collect::<Result<_, DemError>>()?))
}

/// The plane that a table states.
pub fn plane<const D: usize>(stated: &document::Plane) -> Plane<D> {
    let normal = Vector::from(unit_vector(&stated.normal));
    Plane { point: Vector::from(stated.point.to_array()), normal }
}

fn servo<const D: usize>(stated: &document::Servo) -> Servo<D> {
    Servo {
        direction: Vector::from(unit_vector(&stated.direction)),
        force: stated.force.si(),
        mass: stated.mass.si(),
        largest_speed: stated.largest_speed.si(),
    }
}

fn cylinder<const D: usize>(stated: &document::Cylinder) -> Vec<Shape<D>> {
    let (point, axis) = (Vector::from(stated.point.to_array()), Vector::from(unit_vector(&stated.axis)));
    let radius = stated.radius.si();
    let Some(length) = stated.length.map(|length| length.si()) else {
        return vec![Shape::Cylinder(Cylinder { point, axis, radius, side: side(stated.grains) })];
    };
    let mut shapes = vec![Shape::Tube(Tube { start: point, axis, length, radius })];
    if stated.closed {
        shapes
            .extend([point, point + axis * length].map(|centre| Shape::Disc(Disc { centre, axis, radius })));
    }
    shapes
}

/// Its segments, which there are in 2D only.
fn polyline<const D: usize>(stated: &document::Polyline) -> Vec<Shape<D>> {
    let spatial = |end: [f64; 2]| std::array::from_fn(|k| end.get(k).copied().unwrap_or(0.0));
    let facet = |[from, to]: [[f64; 2]; 2]| {
        Shape::Facet(Facet::new(std::array::from_fn(|k| spatial(if k == 0 { from } else { to }))))
    };
    stated.segments().into_iter().map(facet).collect()
}

fn sphere<const D: usize>(stated: &document::Sphere) -> Shape<D> {
    let centre = Vector::from(stated.centre.to_array());
    Shape::Sphere(Sphere { centre, radius: stated.radius.si(), side: side(Some(stated.grains)) })
}

fn side(stated: Option<document::Side>) -> Side {
    match stated {
        Some(document::Side::Outside) => Side::Outside,
        Some(document::Side::Inside) | None => Side::Inside,
    }
}

/// The triangles of a file as pieces of wall, which they can only be in 3D.
fn triangles<const D: usize>(
    case: &Case,
    key: &str,
    format: Format,
    file: &document::SurfaceFile,
) -> Result<Vec<Shape<D>>, DemError> {
    if D != 3 {
        return Err(case
            .error(key, "a surface of triangles in 2D", "planes, spheres, mesh boundaries", "")
            .into());
    }
    let facets = read_triangles(case, key, format, file)?;
    let spatial =
        |facet: &Facet<3>| Facet { vertices: std::array::from_fn(|k| restrict(&facet.vertices[k])) };
    Ok(facets.iter().map(|facet| Shape::Facet(spatial(facet))).collect())
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
