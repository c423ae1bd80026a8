//! A surface of facets, cut at its concave edges into patches: in a corner a node touches each of them.

use super::patch::{Facet, Patch, Side};
use crate::element::simplex::{Vector, difference, distance, dot};
use std::collections::BTreeMap;

/// Edges that are concave by less than this angle are no corners: cos 30°.
const CORNER: f64 = 0.866_025_403_784_438_6;

/// The patches of a surface, in the order of their first facets; segments have the fluid on their left, triangles on the side
/// from which their vertices go round anticlockwise. Facets are neighbours where their vertices are the same to the bit.
pub fn patches<const D: usize>(vertices: &[[Vector<D>; D]]) -> Vec<Patch<D>> {
    let normals: Vec<Vector<D>> = vertices.iter().map(normal).collect();
    let mut by_side: BTreeMap<Vec<[u64; D]>, Vec<(usize, usize)>> = BTreeMap::new();
    for (facet, corners) in vertices.iter().enumerate() {
        for k in 0..D {
            by_side.entry(side_key(corners, k)).or_default().push((facet, k));
        }
    }
    let mut sides = vec![[Side::Rim; D]; vertices.len()];
    let mut patch_of: Vec<usize> = (0..vertices.len()).collect();
    for pair in by_side.values() {
        let &[(f, i), (g, j)] = pair.as_slice() else { continue };
        let rises = difference(&vertices[g][j], &vertices[f][(i + 1) % D]);
        let concave = dot(&rises, &normals[f]) > 0.0 && dot(&normals[f], &normals[g]) < CORNER;
        let side = if concave { Side::Concave } else { Side::Joined };
        (sides[f][i], sides[g][j]) = (side, side);
        if !concave {
            join(&mut patch_of, f, g);
        }
    }
    let mut found: BTreeMap<usize, Vec<Facet<D>>> = BTreeMap::new();
    for (facet, corners) in vertices.iter().enumerate() {
        let root = root(&patch_of, facet);
        let facet = Facet { vertices: *corners, normal: normals[facet], sides: sides[facet] };
        found.entry(root).or_default().push(facet);
    }
    let is_open = sides.as_flattened().contains(&Side::Rim);
    found.into_values().map(|facets| Patch::new(facets, is_open)).collect()
}

/// The least facet of the patch that a facet belongs to.
fn root(patch_of: &[usize], mut facet: usize) -> usize {
    while patch_of[facet] != facet {
        facet = patch_of[facet];
    }
    facet
}

fn join(patch_of: &mut [usize], one: usize, other: usize) {
    let (one, other) = (root(patch_of, one), root(patch_of, other));
    patch_of[one.max(other)] = one.min(other);
}

/// The vertices of the side opposite to vertex `k`, in an order that does not depend on the facet.
fn side_key<const D: usize>(corners: &[Vector<D>; D], k: usize) -> Vec<[u64; D]> {
    // Adding 0 makes −0 and 0 the same.
    let bits = |corner: &Vector<D>| corner.map(|c| (c + 0.0).to_bits());
    let mut key: Vec<_> = (0..D).filter(|&i| i != k).map(|i| bits(&corners[i])).collect();
    key.sort_unstable();
    key
}

fn normal<const D: usize>(corners: &[Vector<D>; D]) -> Vector<D> {
    let a = difference(&corners[1], &corners[0]);
    let across: Vector<D> = if D == 2 {
        std::array::from_fn(|k| if k == 0 { -a[1] } else { a[0] })
    } else {
        let b = difference(&corners[D - 1], &corners[0]);
        std::array::from_fn(|k| a[(k + 1) % D] * b[(k + 2) % D] - a[(k + 2) % D] * b[(k + 1) % D])
    };
    let length = distance(&across, &[0.0; D]);
    across.map(|c| c / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(points: &[[f64; 2]]) -> Vec<Patch<2>> {
        patches(&points.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>())
    }

    #[test]
    fn a_basin_is_four_walls_and_a_node_in_its_corner_touches_two() {
        let basin = line(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0], [0.0, 0.0]]);
        assert_eq!(basin.len(), 4);
        let gaps: Vec<f64> = basin.iter().map(|wall| wall.touch(&[1.9, 0.2]).gap).collect();
        let expected = [0.2, 0.1, 0.8, 1.9];
        assert!(gaps.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{gaps:?}");
        // Pushed out through the corner it is behind both.
        assert!(basin[..2].iter().all(|wall| wall.touch(&[2.01, -0.02]).gap < 0.0));
    }

    #[test]
    fn deep_below_a_floor_but_far_from_it_is_not_behind_it() {
        // A tank with a weir into a lower one.
        let weir =
            line(&[[0.0, 1.0], [0.0, 0.0], [0.5, 0.0], [0.5, 0.2], [0.52, 0.2], [0.52, -0.2], [1.2, -0.2]]);
        for depth in [0.05, 0.1, 0.19] {
            assert!(weir.iter().all(|wall| wall.touch(&[0.76, -depth]).gap > 0.0), "{depth}");
        }
    }

    #[test]
    fn round_a_step_the_facet_that_faces_the_fluid_is_touched() {
        // A block on the floor, the fluid around it: floor and block meet at concave edges, the block's own are convex.
        let step = line(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [2.0, 1.0], [2.0, 0.0], [3.0, 0.0]]);
        assert_eq!(step.len(), 3);
        let block = &step[1];
        let touch = |x: [f64; 2]| {
            let touch = block.touch(&x);
            (touch.gap, touch.normal)
        };
        assert_eq!(touch([0.75, 0.5]), (0.25, [-1.0, 0.0]));
        assert_eq!(touch([0.5, 1.25]), (0.5, [-1.0, 0.0]), "the side is farther than the top");
        assert_eq!(touch([0.875, 1.25]), (0.25, [0.0, 1.0]));
        assert_eq!(touch([1.25, 0.875]), (-0.125, [0.0, 1.0]), "in it the nearer face is touched");
        // The floor before the block goes on below its corner, and not to the floor behind it, whose nodes it does not touch.
        assert!(step[0].touch(&[1.1, -0.1]).gap < 0.0);
        assert!((step[0].touch(&[2.5, 0.0]).gap - 1.5).abs() < 1e-15);
    }

    #[test]
    fn off_its_end_a_wall_is_as_far_as_its_end() {
        let weir = line(&[[0.0, 1.0], [0.0, 0.0], [1.0, 0.0]]);
        let touch = weir[0].touch(&[-0.3, 1.4]);
        assert!((touch.gap - 0.5).abs() < 1e-15);
        assert!((touch.normal[0] + 0.6).abs() < 1e-15 && (touch.normal[1] - 0.8).abs() < 1e-15);
    }

    #[test]
    fn a_polygon_that_is_nearly_a_circle_is_one_wall() {
        let corner = |k: usize| {
            let angle = std::f64::consts::TAU * (k % 24) as f64 / 24.0;
            [angle.cos(), angle.sin()]
        };
        let drum = line(&(0..=24).map(corner).collect::<Vec<_>>());
        assert_eq!(drum.len(), 1);
        let gap = drum[0].touch(&[0.0, 0.5]).gap;
        assert!(gap > 0.48 && gap <= 0.5, "{gap}");
    }

    #[test]
    fn a_box_of_triangles_is_six_walls_from_inside_and_one_from_outside() {
        let corner = |k: usize| [(k & 1) as f64, (k >> 1 & 1) as f64, (k >> 2) as f64];
        // Quadrilaterals anticlockwise from outside.
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let outside: Vec<[Vector<3>; 3]> = faces
            .iter()
            .flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]])
            .map(|t| t.map(corner))
            .collect();
        let inside: Vec<_> = outside.iter().map(|[a, b, c]| [*a, *c, *b]).collect();
        assert_eq!(patches(&outside).len(), 1);
        let basin = patches(&inside);
        assert_eq!(basin.len(), 6);
        let x = [0.9, 0.25, 0.4];
        let mut gaps: Vec<f64> = basin.iter().map(|wall| wall.touch(&x).gap).collect();
        gaps.sort_by(f64::total_cmp);
        let expected = [0.1, 0.25, 0.4, 0.6, 0.75, 0.9];
        assert!(gaps.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{gaps:?}");
        let block = &patches(&outside)[0];
        let touch = block.touch(&[1.5, 0.5, 1.25]);
        assert_eq!((touch.gap, touch.normal), (0.5, [1.0, 0.0, 0.0]));
        assert!((block.touch(&[0.5, 0.5, 0.9]).gap + 0.1).abs() < 1e-15);
    }
}
