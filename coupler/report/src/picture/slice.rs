//! The cut of a plane through tetrahedra.

use super::scene::FluidMesh;
use super::vector::{Vector, between};

/// A triangle of the cut with the value at its corners.
pub(super) struct Cut {
    pub(super) corners: [Vector; 3],
    pub(super) values: [f64; 3],
}

/// Cuts the tetrahedra by the plane where coordinate `axis` equals `place`.
///
/// A node on the plane counts as above it: a face that lies in the plane is cut once, by the tetrahedron below.
pub(super) fn slice(mesh: &FluidMesh, axis: usize, place: f64) -> Vec<Cut> {
    let mut cuts = Vec::new();
    for tetrahedron in &mesh.tetrahedra {
        let nodes = tetrahedron.map(|node| node as usize);
        let height = nodes.map(|node| mesh.points[node][axis] - place);
        let mut corners: Vec<(Vector, f64)> = Vec::with_capacity(4);
        // Around the quadrilateral of a 2–2 split: above × below in the order 00, 01, 11, 10.
        let above: Vec<usize> = (0..4).filter(|&k| height[k] >= 0.0).collect();
        let below: Vec<usize> = (0..4).filter(|&k| height[k] < 0.0).collect();
        for (i, &up) in above.iter().enumerate() {
            let mut row: Vec<usize> = below.clone();
            if i % 2 == 1 {
                row.reverse();
            }
            for down in row {
                let share = height[up] / (height[up] - height[down]);
                let point = between(mesh.points[nodes[up]], mesh.points[nodes[down]], share);
                let (from, to) = (mesh.values[nodes[up]], mesh.values[nodes[down]]);
                corners.push((point, from + share * (to - from)));
            }
        }
        for k in 2..corners.len() {
            let three = [corners[0], corners[k - 1], corners[k]];
            cuts.push(Cut { corners: three.map(|corner| corner.0), values: three.map(|corner| corner.1) });
        }
    }
    cuts
}

#[cfg(test)]
mod tests {
    use super::super::vector::{cross, dot, subtract};
    use super::*;

    /// The unit cube in six tetrahedra around its diagonal; the value is x + 2 z.
    fn cube() -> FluidMesh {
        let points: Vec<Vector> =
            (0..8).map(|corner| std::array::from_fn(|k| f64::from(corner >> k & 1))).collect();
        let values = points.iter().map(|p| p[0] + 2.0 * p[2]).collect();
        let tetrahedra =
            vec![[0, 1, 3, 7], [0, 1, 5, 7], [0, 2, 3, 7], [0, 2, 6, 7], [0, 4, 5, 7], [0, 4, 6, 7]];
        FluidMesh { points, tetrahedra, values, triangles: Vec::new() }
    }

    #[test]
    fn the_cut_of_a_cube_has_its_cross_section_also_on_a_face() {
        for axis in 0..3 {
            for (place, area) in [(0.5, 1.0), (0.1, 1.0), (1.0, 1.0), (1.5, 0.0), (-0.5, 0.0)] {
                let cuts = slice(&cube(), axis, place);
                let total: f64 = cuts
                    .iter()
                    .map(|Cut { corners: [a, b, c], .. }| {
                        let normal = cross(subtract(*b, *a), subtract(*c, *a));
                        0.5 * dot(normal, normal).sqrt()
                    })
                    .sum();
                assert!((total - area).abs() < 1e-14, "axis {axis} at {place}: {total}");
            }
        }
    }

    #[test]
    fn a_linear_field_is_linear_on_the_cut() {
        for Cut { corners, values } in slice(&cube(), 1, 0.3) {
            for (corner, value) in corners.iter().zip(values) {
                assert!((corner[0] + 2.0 * corner[2] - value).abs() < 1e-14);
                assert!((corner[1] - 0.3).abs() < 1e-14);
            }
        }
    }
}
