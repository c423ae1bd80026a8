//! Where a node may go that touches walls.

use crate::backend::pfem::wall::{Contacts, Wall, inlet_of};
use crate::element::simplex::{Vector, cross, dot};

/// The part of a vector along all walls that a node touches; a node in an inlet stays.
pub fn along_walls(
    g: &Vector<3>,
    contacts: Contacts,
    x: &Vector<3>,
    walls: &[Wall<3>],
    time: f64,
) -> Vector<3> {
    if inlet_of(walls, contacts).is_some() {
        return [0.0; 3];
    }
    let mut normals = contacts.iter().map(|wall| walls[wall].touch(x, time).normal);
    match (normals.next(), normals.next(), normals.next()) {
        (None, ..) => *g,
        (Some(n), None, _) => {
            let into = dot(g, &n);
            std::array::from_fn(|k| g[k] - into * n[k])
        }
        (Some(n), Some(m), None) => {
            let edge = cross(&n, &m);
            let share = dot(g, &edge) / dot(&edge, &edge).max(f64::MIN_POSITIVE);
            edge.map(|e| share * e)
        }
        _ => [0.0; 3],
    }
}

/// The nearest place of the walls that a node touches.
pub fn onto_walls(contacts: Contacts, mut x: Vector<3>, walls: &[Wall<3>], time: f64) -> Vector<3> {
    for wall in contacts.iter() {
        let touch = walls[wall].touch(&x, time);
        x = std::array::from_fn(|k| x[k] - touch.gap * touch.normal[k]);
    }
    x
}

/// The walls that a place is behind, beside some.
pub fn behind<'a>(
    contacts: Contacts,
    x: &'a Vector<3>,
    walls: &'a [Wall<3>],
    time: f64,
) -> impl Iterator<Item = usize> + 'a {
    let solid = walls.iter().enumerate().filter(|(_, wall)| wall.inflow.is_none());
    let others = solid.filter(move |(index, _)| !contacts.contains(*index));
    others.filter(move |(_, wall)| wall.touch(x, time).gap < 0.0).map(|(index, _)| index)
}
