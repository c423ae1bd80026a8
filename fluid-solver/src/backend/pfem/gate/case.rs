//! The gates of a case.

use super::outlet::Outlet;
use super::shape::Shape;
use crate::backend::pfem::body::Body;
use crate::backend::pfem::cloud::OUTSIDE;
use crate::backend::pfem::wall::{Contacts, Inflow, Plane, Wall, flat_boundary};
use crate::boundary::{VelocityField, velocity_field};
use crate::element::simplex::{Vector, dot, volume_and_areas};
use crate::error::FluidError;
use crate::mesh::Mesh;
use case_io::document::quantity::Velocity;
use case_io::document::{Boundary, BoundaryKind, BoundaryVelocity, Case, Fluid, unit_vector};
use std::ops::Range;
use std::sync::Arc;

/// A node this near to an inlet is in it, in sizes.
const NEAR: f64 = 1e-6;
/// An inlet that the fluid covers at the start has faces on at least this share of its area.
const COVERED: f64 = 0.5;

/// The nodes that are in an inlet.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Its wall.
    pub wall: usize,
    /// Nodes in it.
    pub nodes: Vec<u32>,
    /// Nodes of the layer of cells that was put before it, if one was.
    pub layer: Range<usize>,
}

/// The velocity of a checked inlet: stated whole, or by its speed along the normal.
fn stated<const D: usize>(
    velocity: Option<&BoundaryVelocity>,
    speed: Option<Velocity>,
    normal: Vector<D>,
) -> VelocityField<D> {
    match speed {
        Some(speed) => {
            let velocity = normal.map(|component| speed.si() * component);
            Arc::new(move |_, _| velocity)
        }
        None => velocity_field(velocity),
    }
}

/// A flat boundary of the mesh that is a gate.
struct Side<'a, const D: usize, const N: usize> {
    boundary: &'a Boundary,
    name: &'a str,
    mesh: &'a Mesh<D, N>,
    group: u32,
    plane: Plane<D>,
}

/// The boundaries of the mesh that are gates of a kind.
fn sides<'a, const D: usize, const N: usize>(
    case: &Case,
    fluid: &'a Fluid,
    mesh: Option<&'a Mesh<D, N>>,
    kind: BoundaryKind,
) -> Result<Vec<Side<'a, D, N>>, FluidError> {
    let mut sides = Vec::new();
    for (index, boundary) in fluid.boundary.iter().enumerate().filter(|(_, boundary)| boundary.kind == kind) {
        for (place, name) in boundary.on.iter().enumerate() {
            let key = format!("fluid.boundary[{index}].on[{place}]");
            let Some((mesh, group)) = mesh.and_then(|mesh| Some((mesh, mesh.group(name)?))) else {
                let allowed = mesh.map_or(String::new(), |mesh| mesh.groups().join(", "));
                let found = format!("the mesh has no boundary \"{name}\"");
                let advice = "state what is not of the mesh as [[fluid.inlet]] or [[fluid.outlet]]";
                return Err(case.error(&key, found, allowed, advice).into());
            };
            let plane = flat_boundary(case, &key, name, mesh, group)?;
            sides.push(Side { boundary, name, mesh, group, plane });
        }
    }
    Ok(sides)
}

/// Adds the inlets to the walls, and to the fluid the layers of cells before those where there is none; the nodes in them.
///
/// # Errors
/// A boundary that is not flat; an inlet thinner than a cell, outside of the vessel, or half in the fluid; too many walls.
pub fn open<const D: usize, const N: usize>(
    case: &Case,
    fluid: &Fluid,
    mesh: Option<&Mesh<D, N>>,
    walls: &mut Vec<Wall<D>>,
    size: f64,
    body: &mut Body<D, N>,
) -> Result<Vec<Opening>, FluidError> {
    let mut openings = Vec::new();
    for Side { boundary, name, mesh, group, plane } in sides(case, fluid, mesh, BoundaryKind::Inlet)? {
        let faces = || mesh.boundary().iter().filter(|face| face.group == group);
        let area = faces().map(|face| mesh.area_vector(face)).map(|area| dot(&area, &area).sqrt()).sum();
        let velocity = stated(boundary.velocity.as_ref(), boundary.speed, plane.normal);
        let nodes: Vec<u32> = faces().flat_map(|face| face.points.map(|point| mesh.node_of(point))).collect();
        let corners = faces().map(|face| face.points.map(|point| mesh.nodes()[mesh.node_of(point) as usize]));
        let inflow = Inflow::new::<N>(plane.normal, area, corners, velocity);
        openings.push(Opening { wall: walls.len(), nodes, layer: 0..0 });
        walls.push(Wall::inlet(name, plane, inflow));
    }
    for (index, inlet) in fluid.inlet.iter().enumerate() {
        let key = format!("fluid.inlet[{index}]");
        let shape = Shape::of(inlet);
        if shape.width() < size * (1.0 - NEAR) {
            let found = format!("\"{}\" is {:.3e} m wide", inlet.name, shape.width());
            let allowed = format!("at least the size of the cells, {size:.3e} m");
            return Err(case.error(&key, found, allowed, "widen it, or lower fluid.pfem.size").into());
        }
        let velocity = stated(inlet.velocity.as_ref(), inlet.speed, unit_vector(&inlet.normal));
        let first = body.place.len();
        let nodes = nodes_in(case, &key, &shape, walls, size, body)?;
        let corners = faces_within(body, &nodes)
            .map(|(cell, opposite)| std::array::from_fn(|i| body.vertices(cell)[(opposite + 1 + i) % N]));
        let inflow = Inflow::new::<N>(shape.plane.normal, shape.area(), corners, velocity);
        openings.push(Opening { wall: walls.len(), nodes, layer: first..body.place.len() });
        walls.push(Wall::inlet(&inlet.name, shape.plane, inflow));
    }
    if walls.len() > Contacts::MOST {
        let found = format!("walls between concave edges and inlets are {} in all", walls.len());
        let allowed = format!("at most {}", Contacts::MOST);
        return Err(case.error("fluid", found, allowed, "simplify the walls, or join inlets").into());
    }
    Ok(openings)
}

/// The nodes in an inlet, those of a new layer of cells where there is no fluid yet.
fn nodes_in<const D: usize, const N: usize>(
    case: &Case,
    key: &str,
    shape: &Shape<D>,
    walls: &[Wall<D>],
    size: f64,
    body: &mut Body<D, N>,
) -> Result<Vec<u32>, FluidError> {
    let near = NEAR * size;
    let first = body.place.len();
    let in_it = |body: &Body<D, N>, from: usize| -> Vec<u32> {
        let nodes = (from..body.place.len()).filter(|&node| shape.holds(&body.place[node], 0.0, near));
        nodes.map(|node| node as u32).collect()
    };
    let partly = |found: String| {
        let advice = "raise the fluid over all of it, or lower it below";
        Err(case.error(key, found, "an inlet that the fluid covers, or does not touch", advice).into())
    };
    let there = in_it(body, 0);
    if !there.is_empty() {
        let covered = area_within(body, &there, &shape.plane.normal) / shape.area();
        if covered < COVERED {
            return partly(format!("the fluid covers {:.0} % of it", 100.0 * covered));
        }
        return Ok(there);
    }
    let layer = shape.layer::<N>(size)?;
    let outside = |x: &Vector<D>| {
        let behind = walls.iter().filter(|wall| wall.inflow.is_none());
        behind.map(|wall| (wall.touch(x, 0.0).gap, wall)).find(|(gap, _)| *gap < -near)
    };
    if let Some((x, (gap, wall))) = layer.place.iter().find_map(|x| Some((x, outside(x)?))) {
        let found =
            format!("the fluid before it, at {x:?} m, is {:.3e} m behind the wall \"{}\"", -gap, wall.name);
        let advice = "move it into the vessel, or turn its normal round";
        return Err(case.error(key, found, "an inlet that blows into the vessel", advice).into());
    }
    if let Some(x) = body.place.iter().find(|x| shape.holds(x, size, near)) {
        return partly(format!("fluid at {x:?} m is in the layer of cells before it"));
    }
    body.join(layer);
    Ok(in_it(body, first))
}

/// Faces of a body that have all of their nodes among these, each the one opposite to a corner of a cell.
fn faces_within<'a, const D: usize, const N: usize>(
    body: &'a Body<D, N>,
    nodes: &'a [u32],
) -> impl Iterator<Item = (&'a [u32; N], usize)> {
    let faces = body.cells.iter().zip(&body.neighbours).flat_map(|(cell, around)| {
        (0..N).filter(|&opposite| around[opposite] == OUTSIDE).map(move |opposite| (cell, opposite))
    });
    faces.filter(|(cell, opposite)| (0..N).all(|i| i == *opposite || nodes.contains(&cell[i])))
}

/// Area of the faces of a body that have all of their nodes among these, along a normal (m²).
fn area_within<const D: usize, const N: usize>(body: &Body<D, N>, nodes: &[u32], normal: &Vector<D>) -> f64 {
    let across = |(cell, opposite): (&[u32; N], usize)| {
        D as f64 * dot(&volume_and_areas(&body.vertices(cell)).1[opposite], normal)
    };
    faces_within(body, nodes).map(across).sum()
}

/// The outlets.
///
/// # Errors
/// A boundary that is not flat; fluid behind an outlet at the start; an outlet behind a wall.
pub fn outlets<const D: usize, const N: usize>(
    case: &Case,
    fluid: &Fluid,
    mesh: Option<&Mesh<D, N>>,
    walls: &[Wall<D>],
    size: f64,
    body: &Body<D, N>,
) -> Result<Vec<Outlet<D>>, FluidError> {
    let sides = sides(case, fluid, mesh, BoundaryKind::Outlet)?.into_iter();
    let mut outlets: Vec<Outlet<D>> =
        sides.map(|side| Outlet { name: side.name.to_string(), plane: side.plane, within: None }).collect();
    for outlet in &fluid.outlet {
        let plane =
            Plane { point: outlet.beyond.point.to_array(), normal: unit_vector(&outlet.beyond.normal) };
        let within = outlet.within.as_ref().map(|bounds| [bounds.lower.to_array(), bounds.upper.to_array()]);
        outlets.push(Outlet { name: outlet.name.clone(), plane, within });
    }
    for outlet in &outlets {
        let behind = |x: &&Vector<D>| outlet.plane.touch(x).gap < -NEAR * size && outlet.holds(x);
        if let Some(x) = body.place.iter().find(behind) {
            let found = format!("the fluid at {x:?} m is behind the outlet \"{}\" at the start", outlet.name);
            let advice = "move one of them, or turn the normal round";
            return Err(case.error("fluid.outlet", found, "fluid before its outlets", advice).into());
        }
        if let Some(wall) = walls.iter().find(|wall| wall.hides(&outlet.plane, NEAR * size)) {
            let found = format!("the outlet \"{}\" is behind the wall \"{}\"", outlet.name, wall.name);
            let advice = "make the wall of a polyline or of triangles with a hole there";
            return Err(case.error("fluid.outlet", found, "outlets that fluid can reach", advice).into());
        }
    }
    Ok(outlets)
}
