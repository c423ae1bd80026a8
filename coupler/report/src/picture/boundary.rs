//! The boundary of a mesh and its sharp edges.

use super::scene::FluidMesh;
use super::vector::{Vector, cross, dot, subtract, unit};

/// Faces that belong to one tetrahedron only, wound so that their normals point outwards.
pub(super) fn boundary_faces(mesh: &FluidMesh) -> Vec<[u32; 3]> {
    let mut faces: Vec<([u32; 3], [u32; 3])> = Vec::with_capacity(4 * mesh.tetrahedra.len());
    for &[a, b, c, d] in &mesh.tetrahedra {
        for (face, opposite) in [([b, c, d], a), ([a, c, d], b), ([a, b, d], c), ([a, b, c], d)] {
            let outwards = dot(normal(mesh, face), arm(mesh, face[0], opposite)) <= 0.0;
            let wound = if outwards { face } else { [face[0], face[2], face[1]] };
            faces.push((sorted(face), wound));
        }
    }
    once(faces)
}

/// Edges where the surface ends or two faces meet at more than 30°.
pub(super) fn sharp_edges(mesh: &FluidMesh, faces: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let largest_cosine = f64::to_radians(30.0).cos();
    let mut edges: Vec<([u32; 2], usize)> = Vec::with_capacity(3 * faces.len());
    for (number, &[a, b, c]) in faces.iter().enumerate() {
        edges.extend([[a, b], [b, c], [c, a]].map(|edge| (sorted(edge), number)));
    }
    edges.sort_unstable();
    edges
        .chunk_by(|one, next| one.0 == next.0)
        .filter(|faces_at| match faces_at {
            [(_, one), (_, other)] => {
                let normals = [one, other].map(|&number| unit(normal(mesh, faces[number])));
                dot(normals[0], normals[1]) < largest_cosine
            }
            _ => true,
        })
        .map(|faces_at| faces_at[0].0)
        .collect()
}

/// The normal of a face; its length is twice the area.
pub(super) fn normal(mesh: &FluidMesh, [a, b, c]: [u32; 3]) -> Vector {
    cross(arm(mesh, a, b), arm(mesh, a, c))
}

fn arm(mesh: &FluidMesh, from: u32, to: u32) -> Vector {
    subtract(mesh.points[to as usize], mesh.points[from as usize])
}

fn sorted<const N: usize>(mut nodes: [u32; N]) -> [u32; N] {
    nodes.sort_unstable();
    nodes
}

/// What occurs under a key that occurs once.
fn once<K: Ord, V: Ord + Copy>(mut pairs: Vec<(K, V)>) -> Vec<V> {
    pairs.sort_unstable();
    pairs.chunk_by(|one, next| one.0 == next.0).filter(|same| same.len() == 1).map(|same| same[0].1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> FluidMesh {
        let points: Vec<Vector> =
            (0..8).map(|corner| std::array::from_fn(|k| f64::from(corner >> k & 1))).collect();
        let tetrahedra =
            vec![[0, 1, 3, 7], [0, 1, 5, 7], [0, 2, 3, 7], [0, 2, 6, 7], [0, 4, 5, 7], [0, 4, 6, 7]];
        FluidMesh { points, tetrahedra, ..FluidMesh::default() }
    }

    #[test]
    fn a_cube_has_twelve_triangles_that_face_outwards_and_twelve_edges() {
        let mesh = cube();
        let faces = boundary_faces(&mesh);
        assert_eq!(faces.len(), 12);
        for &face in &faces {
            let outwards = subtract(mesh.points[face[0] as usize], [0.5; 3]);
            assert!(dot(normal(&mesh, face), outwards) > 0.0);
        }
        assert_eq!(sharp_edges(&mesh, &faces).len(), 12);
    }

    #[test]
    fn the_outline_of_a_plane_square_is_its_four_sides() {
        let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let mesh = FluidMesh { points, ..FluidMesh::default() };
        assert_eq!(sharp_edges(&mesh, &[[0, 1, 2], [0, 2, 3]]), [[0, 1], [0, 3], [1, 2], [2, 3]]);
    }
}
