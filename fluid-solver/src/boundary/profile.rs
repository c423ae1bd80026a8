//! The nodal speeds of an inlet of stated mean speed.

use crate::element::simplex::{Vector, difference, distance, dot};
use crate::mesh::{BoundaryFace, Mesh};
use case_io::document::Profile;

/// Velocity at the nodes of an inlet, in ascending order of nodes; zero where `sticks`.
///
/// The shape is 1, or (d/d_max)(2 − d/d_max) with d the distance to the wall where the fluid sticks: the exact parabola
/// for plane channels and round pipes, a plausible one for other sections. Directions are the inward nodal normals. The
/// whole is scaled so that −∮ u·n = mean × area. `None` if all nodes stick.
pub fn inlet_velocity<const D: usize, const N: usize>(
    mesh: &Mesh<D, N>,
    faces: &[&BoundaryFace<D>],
    sticks: &[bool],
    mean: f64,
    profile: Profile,
) -> Option<Vec<(u32, Vector<D>)>> {
    let areas: Vec<Vector<D>> = faces.iter().map(|face| mesh.area_vector(face)).collect();
    let nodes_of = |face: &BoundaryFace<D>| face.points.map(|point| mesh.node_of(point));
    let mut corners: Vec<(u32, u32, Vector<D>)> = faces
        .iter()
        .zip(&areas)
        .flat_map(|(face, &area)| face.points.map(|point| (mesh.node_of(point), point, area)))
        .collect();
    corners.sort_by_key(|corner| corner.0);

    let rim = Rim::new(mesh, faces, sticks);
    let deepest = depth_of(mesh, faces, &rim);
    let shape = |point: u32| match profile {
        Profile::Constant => 1.0,
        Profile::Parabolic => {
            let depth = (rim.distance(&mesh.points()[point as usize]) / deepest).min(1.0);
            depth * (2.0 - depth)
        }
    };
    let velocity: Vec<(u32, Vector<D>)> = corners
        .chunk_by(|a, b| a.0 == b.0)
        .map(|around| {
            let (node, point, _) = around[0];
            let normal = around.iter().fold([0.0; D], |sum, c| std::array::from_fn(|k| sum[k] + c.2[k]));
            let speed = if sticks[node as usize] { 0.0 } else { shape(point) / dot(&normal, &normal).sqrt() };
            (node, normal.map(|component| -speed * component))
        })
        .collect();

    let at = |node: u32| velocity[velocity.partition_point(|entry| entry.0 < node)].1;
    let inflow: f64 = faces
        .iter()
        .zip(&areas)
        .map(|(face, area)| nodes_of(face).iter().map(|&node| -dot(&at(node), area)).sum::<f64>() / D as f64)
        .sum();
    let area: f64 = areas.iter().map(|area| dot(area, area).sqrt()).sum();
    let scale = mean * area / inflow;
    (inflow > 0.0).then(|| velocity.iter().map(|&(node, u)| (node, u.map(|c| scale * c))).collect())
}

/// Where an inlet meets walls at which the fluid sticks: points in the plane, edges in space.
struct Rim<const D: usize> {
    edges: Vec<[Vector<D>; 2]>,
}

impl<const D: usize> Rim<D> {
    /// An edge of one face of the inlet only belongs to its rim; it is a wall if both ends stick.
    fn new<const N: usize>(mesh: &Mesh<D, N>, faces: &[&BoundaryFace<D>], sticks: &[bool]) -> Self {
        let mut edges: Vec<[u32; 2]> = Vec::new();
        for face in faces {
            for skipped in 0..D {
                let others: Vec<u32> = (0..D).filter(|&k| k != skipped).map(|k| face.points[k]).collect();
                let (first, last) = (others[0], others[others.len() - 1]);
                edges.push([first.min(last), first.max(last)]);
            }
        }
        edges.sort_unstable();
        let once = edges.chunk_by(|a, b| a == b).filter(|same| same.len() == 1).map(|same| same[0]);
        let wall = once.filter(|edge| edge.iter().all(|&point| sticks[mesh.node_of(point) as usize]));
        Self { edges: wall.map(|edge| edge.map(|point| mesh.points()[point as usize])).collect() }
    }

    fn distance(&self, x: &Vector<D>) -> f64 {
        let to_edge = |[a, b]: &[Vector<D>; 2]| distance_to_segment(a, b, x);
        self.edges.iter().map(to_edge).fold(f64::INFINITY, f64::min)
    }
}

fn distance_to_segment<const D: usize>(a: &Vector<D>, b: &Vector<D>, x: &Vector<D>) -> f64 {
    let (along, from_a) = (difference(b, a), difference(x, a));
    let length_squared = dot(&along, &along);
    let t = if length_squared > 0.0 { (dot(&from_a, &along) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
    distance(x, &std::array::from_fn(|k| a[k] + t * along[k]))
}

/// Largest distance to the rim over the nodes and the centres of the faces.
fn depth_of<const D: usize, const N: usize>(
    mesh: &Mesh<D, N>,
    faces: &[&BoundaryFace<D>],
    rim: &Rim<D>,
) -> f64 {
    let mut deepest: f64 = 0.0;
    for face in faces {
        let vertices = mesh.face_vertices(face);
        let centre: Vector<D> =
            std::array::from_fn(|k| vertices.iter().map(|v| v[k]).sum::<f64>() / D as f64);
        deepest = vertices.iter().chain([&centre]).map(|x| rim.distance(x)).fold(deepest, f64::max);
    }
    deepest
}
