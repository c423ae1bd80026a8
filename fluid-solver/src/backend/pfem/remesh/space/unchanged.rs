//! Cells that still are as good as new ones stay, lest a mesh at rest flickers.

use super::super::draft::Draft;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::element::simplex::{Vector, cross, difference, dot, volume_and_areas};

/// How far inside a sphere a point counts as on it, as a share of the fifth power of the distance.
const ROUNDOFF: f64 = 1e-9;

/// Sine of the angle by which a free surface may turn inwards at an edge.
const HOLLOW: f64 = 0.17;

/// Whether the cells may stay: they are Delaunay cells, and no part of the fluid can have met another.
pub fn stays(cloud: &Cloud<3, 4>, draft: &Draft<3>) -> bool {
    !draft.edited
        && !cloud.cells.is_empty()
        && still_delaunay(cloud)
        && is_alone(cloud)
        && !is_hollow(cloud, draft)
}

/// Whether the fluid is one piece, without drops.
fn is_alone(cloud: &Cloud<3, 4>) -> bool {
    let mut seen = vec![false; cloud.cells.len()];
    let mut piece = vec![0];
    seen[0] = true;
    let mut visited = 0;
    while let Some(&cell) = piece.get(visited) {
        visited += 1;
        for next in cloud.neighbours[cell].into_iter().filter(|&next| next != OUTSIDE) {
            if !std::mem::replace(&mut seen[next as usize], true) {
                piece.push(next as usize);
            }
        }
    }
    piece.len() == cloud.cells.len() && cloud.drop.iter().all(|&drop| drop == 0.0)
}

/// Whether the free surface turns inwards somewhere, so that it could meet itself or a wall.
fn is_hollow(cloud: &Cloud<3, 4>, draft: &Draft<3>) -> bool {
    let free = |face: &[u32; 3]| {
        let [a, b, c] = face.map(|node| cloud.contacts[node as usize]);
        a.common(b).common(c).is_empty()
    };
    // Each edge with the corner opposite to it; an edge of two faces is met twice.
    let mut sides = Vec::with_capacity(3 * draft.edges.len());
    for face in &draft.edges {
        for k in 0..3 {
            let [a, b, apex] = [0, 1, 2].map(|i| face[(k + i) % 3]);
            sides.push(([a.min(b), a.max(b)], apex, *face));
        }
    }
    sides.sort_unstable();
    sides.windows(2).any(|pair| {
        let [(edge, _, face), (other_edge, apex, other)] = [pair[0], pair[1]];
        edge == other_edge && (free(&face) || free(&other)) && {
            let [a, b, c] = face.map(|node| cloud.place[node as usize]);
            let normal = cross(&difference(&b, &a), &difference(&c, &a));
            let reach = difference(&cloud.place[apex as usize], &cloud.place[edge[0] as usize]);
            dot(&normal, &reach) > HOLLOW * (dot(&normal, &normal) * dot(&reach, &reach)).sqrt()
        }
    })
}

/// Whether all cells are positive and no neighbour's corner lies in the sphere of a cell by more than round-off.
fn still_delaunay(cloud: &Cloud<3, 4>) -> bool {
    cloud.cells.iter().zip(&cloud.neighbours).enumerate().all(|(index, (cell, around))| {
        let vertices = cloud.vertices(cell);
        volume_and_areas(&vertices).0 > 0.0
            && (0..4).filter(|&i| around[i] != OUTSIDE && around[i] as usize > index).all(|i| {
                let other = &cloud.cells[around[i] as usize];
                let apex = other.iter().find(|node| !cell.contains(node));
                apex.is_some_and(|&apex| !inside_sphere(&vertices, &cloud.place[apex as usize]))
            })
    })
}

/// Whether a point lies in the sphere through the corners by more than round-off.
///
/// Seen from the first corner, 2 V c = Σ |x_i|² V∇N_i, and e lies inside if |e|² < 2 c · e.
fn inside_sphere(vertices: &[Vector<3>; 4], point: &Vector<3>) -> bool {
    let (volume, areas) = volume_and_areas(vertices);
    let e = difference(point, &vertices[0]);
    let mut excess = -volume * dot(&e, &e);
    let mut reach = dot(&e, &e);
    for i in 1..4 {
        let x = difference(&vertices[i], &vertices[0]);
        excess += dot(&x, &x) * dot(&areas[i], &e);
        reach = reach.max(dot(&x, &x));
    }
    excess > ROUNDOFF * reach.powf(2.5)
}

#[cfg(test)]
mod tests {
    use super::super::super::size::TargetSize;
    use super::super::surface;
    use super::*;
    use crate::backend::pfem::body::Body;

    #[test]
    fn a_box_may_stay_but_two_of_them_or_one_with_a_notch_may_not() {
        let box_at = |x: f64| Body::<3, 4>::of_box([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0], 0.5).unwrap();
        let may_stay = |body: Body<3, 4>| {
            let cloud = body.cloud();
            let mut draft = Draft::default();
            draft.read_sizes(&cloud, &TargetSize::Constant(0.5));
            surface::read(&cloud, &mut draft);
            stays(&cloud, &draft)
        };
        assert!(may_stay(box_at(0.0)));
        let mut two = box_at(0.0);
        two.join(box_at(1.5));
        assert!(!may_stay(two));
        let notched = box_at(0.0).with_surface(0.0, 1.0, |x| 1.0 + 0.2 * (x[0] - 0.5).abs());
        assert!(!may_stay(notched));
    }

    #[test]
    fn the_eighth_corner_of_a_cube_lies_on_the_sphere_and_its_middle_in_it() {
        let cell = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!(!inside_sphere(&cell, &[1.0; 3]));
        assert!(inside_sphere(&cell, &[1.0 - 1e-6; 3]));
        assert!(!inside_sphere(&cell, &[1.0 + 1e-6; 3]));
    }
}
