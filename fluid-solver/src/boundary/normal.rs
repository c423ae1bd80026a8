//! Nodal normals of slip walls.

use crate::element::simplex::{Vector, dot};
use crate::mesh::{BoundaryFace, Mesh};

/// Faces at a node whose normals differ by less than 30° belong to one smooth wall.
const SMOOTH: f64 = 0.866_025_403_784_438_6;

/// For each node of the faces, in ascending order, an orthonormal basis of the directions normal to its walls.
///
/// A smooth wall has one normal, n_a ∝ ∮ N_a n, with which ∮ u·n = 0 whenever u_a·n_a = 0 (Engelman, Sani and Gresho,
/// *Int. J. Numer. Meth. Fluids* 2 (1982) 225); edges and corners have one for each wall.
pub fn wall_normals<const D: usize, const N: usize>(
    mesh: &Mesh<D, N>,
    faces: &[&BoundaryFace<D>],
) -> Vec<(u32, Vec<Vector<D>>)> {
    let areas = faces.iter().map(|face| mesh.area_vector(face));
    let mut corners: Vec<(u32, Vector<D>)> = faces
        .iter()
        .zip(areas)
        .flat_map(|(face, area)| face.points.map(|point| (mesh.node_of(point), area)))
        .collect();
    corners.sort_by_key(|corner| corner.0);
    let nodes = corners.chunk_by(|a, b| a.0 == b.0);
    nodes.map(|around| (around[0].0, basis(&walls(around.iter().map(|corner| corner.1))))).collect()
}

/// Joins area vectors of smooth walls.
fn walls<const D: usize>(areas: impl Iterator<Item = Vector<D>>) -> Vec<Vector<D>> {
    let mut walls: Vec<Vector<D>> = Vec::new();
    for area in areas {
        let smooth =
            |wall: &&mut Vector<D>| dot(wall, &area) > SMOOTH * (dot(wall, wall) * dot(&area, &area)).sqrt();
        match walls.iter_mut().find(smooth) {
            Some(wall) => *wall = std::array::from_fn(|k| wall[k] + area[k]),
            None => walls.push(area),
        }
    }
    walls
}

/// Gram–Schmidt; a direction that is nearly in the span of those before adds nothing.
fn basis<const D: usize>(directions: &[Vector<D>]) -> Vec<Vector<D>> {
    let mut basis: Vec<Vector<D>> = Vec::new();
    for direction in directions {
        let length = dot(direction, direction).sqrt();
        let mut rest = direction.map(|component| component / length);
        for unit in &basis {
            let along = dot(unit, &rest);
            rest = std::array::from_fn(|k| rest[k] - along * unit[k]);
        }
        let left = dot(&rest, &rest).sqrt();
        if left > 0.1 && basis.len() < D {
            basis.push(rest.map(|component| component / left));
        }
    }
    basis
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn facets_of_a_round_wall_share_a_normal_and_those_of_a_corner_do_not() {
        let round = walls([[1.0, 0.1], [1.0, -0.1]].into_iter());
        assert_eq!(basis(&round), [[1.0, 0.0]]);
        let corner = walls([[1.0, 0.0], [0.0, 2.0], [3.0, 0.0]].into_iter());
        assert_eq!(basis(&corner), [[1.0, 0.0], [0.0, 1.0]]);
    }

    #[test]
    fn no_more_than_all_directions_are_taken() {
        let walls = [[1.0, 0.0], [-1.0, 0.2], [0.0, 1.0]];
        assert_eq!(basis(&walls).len(), 2);
    }
}
