//! The walls of a case.

use super::{Contacts, Grip, Patch, Plane, Round, Shape, Wall, patches};
use crate::element::simplex::{Vector, distance, dot};
use crate::error::FluidError;
use crate::mesh::Mesh;
use case_io::document::{self, BoundaryKind, Case, Fluid, Side, WallShape, unit_vector};
use surface::case::{motion, triangles};
use surface::triangles::Format;

/// Points of a flat boundary are this near to its plane, in parts of the size of the mesh.
const FLAT: f64 = 1e-6;

/// The walls that `[[fluid.boundary]]` names, in that order, without inlets and outlets: flat boundaries of the mesh as planes without end, and walls of
/// the case, those of segments and triangles cut into patches.
///
/// # Errors
/// A name that is not there; a boundary that is not flat, or has fluid behind it; more walls than nodes can tell apart.
pub fn walls<const D: usize, const N: usize>(
    case: &Case,
    fluid: &Fluid,
    mesh: Option<&Mesh<D, N>>,
) -> Result<Vec<Wall<D>>, FluidError> {
    let mut walls = Vec::new();
    for (index, boundary) in fluid.boundary.iter().enumerate() {
        for (place, name) in boundary.on.iter().enumerate() {
            let key = format!("fluid.boundary[{index}].on[{place}]");
            let grip = match boundary.kind {
                BoundaryKind::NoSlip => Grip::NoSlip,
                BoundaryKind::WallFunction => Grip::WallFunction,
                BoundaryKind::Inlet | BoundaryKind::Outlet => continue,
                // Loading has refused all kinds but those and this.
                _ => Grip::Slip,
            };
            let is_free = boundary.kind == BoundaryKind::FreeSurface;
            let of_mesh = mesh.and_then(|mesh| Some((mesh, mesh.group(name)?)));
            match (of_mesh, case.document.wall.iter().position(|wall| wall.name == *name)) {
                (Some(_), _) if is_free => {}
                (Some((mesh, group)), _) => {
                    let plane = flat_boundary(case, &key, name, mesh, group)?;
                    walls.push(Wall::new(name, Shape::Plane(plane), grip));
                }
                (None, Some(wall)) => walls.extend(of_table(case, wall, grip)?),
                (None, None) => {
                    let found = format!("there is neither a boundary of the mesh nor a wall \"{name}\"");
                    let groups = mesh.map_or(&[][..], |mesh| mesh.groups());
                    let stated = case.document.wall.iter().map(|wall| &wall.name);
                    let allowed: Vec<&str> = groups.iter().chain(stated).map(String::as_str).collect();
                    return Err(case.error(&key, found, allowed.join(", "), "").into());
                }
            }
        }
    }
    if walls.len() > Contacts::MOST {
        let found = format!("the fluid's walls have {} parts between concave edges", walls.len());
        let allowed = format!("at most {}", Contacts::MOST);
        return Err(case
            .error("fluid.boundary", found, allowed, "simplify them, or round their edges")
            .into());
    }
    Ok(walls)
}

/// The plane of a boundary of the mesh, its normal into the fluid.
///
/// # Errors
/// A boundary that is not flat, or has fluid behind it.
pub fn flat_boundary<const D: usize, const N: usize>(
    case: &Case,
    key: &str,
    name: &str,
    mesh: &Mesh<D, N>,
    group: u32,
) -> Result<Plane<D>, FluidError> {
    let faces = || mesh.boundary().iter().filter(|face| face.group == group);
    let (mut outwards, mut point) = ([0.0; D], [0.0; D]);
    for face in faces() {
        let area = mesh.area_vector(face);
        outwards = std::array::from_fn(|k| outwards[k] + area[k]);
        point = mesh.face_vertices(face)[0];
    }
    let length = dot(&outwards, &outwards).sqrt();
    let plane = Plane { point, normal: outwards.map(|c| -c / length) };
    let (lower, upper) = mesh.bounds();
    let near = FLAT * distance(&lower, &upper);
    let gap = |x: &Vector<D>| plane.touch(x).gap;
    let advice =
        "state the vessel as a [[wall]] and name that; the boundary of the mesh is then a free-surface";
    let is_flat = faces().flat_map(|face| mesh.face_vertices(face)).all(|x| gap(&x).abs() <= near);
    if !is_flat {
        return Err(case
            .error(key, format!("the boundary \"{name}\" is not flat"), "flat ones", advice)
            .into());
    }
    match mesh.nodes().iter().find(|x| gap(x) < -near) {
        Some(x) => {
            let found = format!("the fluid at {x:?} m is behind the plane of the boundary \"{name}\"");
            Err(case.error(key, found, "fluid on one side of it", advice).into())
        }
        None => Ok(plane),
    }
}

/// The walls that a `[[wall]]` is.
fn of_table<const D: usize>(case: &Case, index: usize, grip: Grip) -> Result<Vec<Wall<D>>, FluidError> {
    let stated = &case.document.wall[index];
    let key = |key: &str| format!("wall[{index}].{key}");
    let shapes = match stated.shape() {
        Some(WallShape::Plane(plane)) => {
            vec![Shape::Plane(Plane { point: plane.point.to_array(), normal: unit_vector(&plane.normal) })]
        }
        Some(WallShape::Cylinder(cylinder)) => vec![Shape::Round(Round {
            centre: cylinder.point.to_array(),
            axis: unit_vector(&cylinder.axis),
            radius: cylinder.radius.si(),
            holds_fluid: cylinder.grains != Some(Side::Outside),
        })],
        Some(WallShape::Sphere(sphere)) => vec![Shape::Round(round(sphere))],
        Some(WallShape::Polyline(line)) => {
            let spatial = |end: [f64; 2]| std::array::from_fn(|k| end.get(k).copied().unwrap_or(0.0));
            let segment = |ends: [[f64; 2]; 2]| std::array::from_fn(|k| spatial(ends[k.min(1)]));
            shapes(patches(&line.segments().into_iter().map(segment).collect::<Vec<_>>()))
        }
        Some(WallShape::Stl(file)) => shapes(of_file(case, &key("stl"), Format::Stl, file)?),
        Some(WallShape::Obj(file)) => shapes(of_file(case, &key("obj"), Format::Obj, file)?),
        Some(WallShape::Mesh(_)) | None => {
            let allowed = "plane, cylinder, sphere, polyline, stl, obj";
            return Err(case
                .error(&format!("wall[{index}]"), "it cannot hold the fluid", allowed, "")
                .into());
        }
    };
    let motion = stated.motion.as_ref().map(|stated| motion(case, &key("motion"), stated)).transpose()?;
    let wall = |shape| {
        let wall = Wall::new(&stated.name, shape, grip);
        motion.clone().map_or(wall.clone(), |motion| wall.moving(motion))
    };
    Ok(shapes.into_iter().map(wall).collect())
}

fn round<const D: usize>(sphere: &document::Sphere) -> Round<D> {
    Round {
        centre: sphere.centre.to_array(),
        axis: [0.0; D],
        radius: sphere.radius.si(),
        holds_fluid: sphere.grains == Side::Inside,
    }
}

fn shapes<const D: usize>(patches: Vec<Patch<D>>) -> Vec<Shape<D>> {
    patches.into_iter().map(Shape::Patch).collect()
}

fn of_file<const D: usize>(
    case: &Case,
    key: &str,
    format: Format,
    file: &document::SurfaceFile,
) -> Result<Vec<Patch<D>>, FluidError> {
    let facets = triangles(case, key, format, file)?;
    let corner = |corner: [f64; 3]| -> Vector<D> { std::array::from_fn(|k| corner[k]) };
    let facet = |vertices: [[f64; 3]; 3]| -> [Vector<D>; D] { std::array::from_fn(|k| corner(vertices[k])) };
    Ok(patches(&facets.iter().map(|found| facet(found.vertices.map(Into::into))).collect::<Vec<_>>()))
}

/// Refuses ends of walls that are nearer to another wall than a cell is large without meeting it: fluid would be caught there.
///
/// A side in which a wall ends lies along a wall that all of its vertices meet; else its middle is looked at as they are.
///
/// # Errors
/// Where the first is.
pub fn refuse_gaps<const D: usize>(case: &Case, walls: &[Wall<D>], size: f64) -> Result<(), FluidError> {
    for (index, wall) in walls.iter().enumerate() {
        let Shape::Patch(patch) = &wall.shape else { continue };
        let others = || walls.iter().enumerate().filter(|&(other, _)| other != index).map(|(_, other)| other);
        let gap = |other: &Wall<D>, end: &Vector<D>| other.shape.touch(end).gap;
        for mut ends in patch.ends() {
            if others().any(|other| ends.iter().all(|end| gap(other, end).abs() <= FLAT * size)) {
                continue;
            }
            let share = 1.0 / ends.len() as f64;
            ends.push(std::array::from_fn(|k| share * ends.iter().map(|end| end[k]).sum::<f64>()));
            for end in ends {
                let nearest = others().map(|other| (gap(other, &end), other));
                let Some((gap, other)) = nearest.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs())) else {
                    continue;
                };
                if gap > FLAT * size && gap < size {
                    let found = format!(
                        "there is a gap of {gap:.3e} m between an end of the wall \"{}\", at {end:?} m, and \"{}\"",
                        wall.name, other.name
                    );
                    let allowed = format!("walls that meet, or are farther apart than a cell, {size:.3e} m");
                    return Err(case.error("fluid.boundary", found, allowed, "close it or widen it").into());
                }
            }
        }
    }
    Ok(())
}
