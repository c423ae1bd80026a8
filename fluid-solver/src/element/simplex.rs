//! Volume, shape-function gradients and barycentric coordinates of a simplex.
//!
//! The P1 shape function `N_i` is one at vertex `i` and zero on the face opposite to it, so its constant
//! gradient carries all the geometry: the area vector (outward) of that face is `-D V ∇N_i`, and the
//! barycentric coordinate of a point is `λ_i = ∇N_i · (x - x_j)` for any vertex `j ≠ i`.

/// A point or a vector.
pub type Vector<const D: usize> = [f64; D];

/// `a · b`.
pub fn dot<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> f64 {
    (0..D).map(|k| a[k] * b[k]).sum()
}

/// `a × b`.
pub fn cross(a: &Vector<3>, b: &Vector<3>) -> Vector<3> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `a - b`.
pub fn difference<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    std::array::from_fn(|k| a[k] - b[k])
}

/// `|a - b|`.
pub fn distance<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> f64 {
    let d = difference(a, b);
    dot(&d, &d).sqrt()
}

/// Three components, z = 0 in 2D.
pub fn in_space<const D: usize>(x: &Vector<D>) -> [f64; 3] {
    std::array::from_fn(|k| if k < D { x[k] } else { 0.0 })
}

/// Signed volume (area in the plane) and gradients (1/m) of the shape functions of a simplex.
///
/// The volume is positive for counter-clockwise triangles and right-handed tetrahedra; for a volume of zero the
/// gradients are not finite.
pub fn volume_and_gradients<const D: usize, const N: usize>(
    vertices: &[Vector<D>; N],
) -> (f64, [Vector<D>; N]) {
    const { assert!(N == D + 1 && (D == 2 || D == 3)) };
    let cofactor = cofactors(vertices);
    let determinant = dot(&difference(&vertices[1], &vertices[0]), &cofactor[0]);
    let mut gradients = [[0.0; D]; N];
    for k in 0..D {
        for j in 0..D {
            gradients[k + 1][j] = cofactor[k][j] / determinant;
            gradients[0][j] -= gradients[k + 1][j];
        }
    }
    (determinant / factorial(D), gradients)
}

/// Signed volume V and the vectors `V ∇N_i`, finite also where the volume is zero.
pub fn volume_and_areas<const D: usize, const N: usize>(vertices: &[Vector<D>; N]) -> (f64, [Vector<D>; N]) {
    const { assert!(N == D + 1 && (D == 2 || D == 3)) };
    let cofactor = cofactors(vertices);
    let determinant = dot(&difference(&vertices[1], &vertices[0]), &cofactor[0]);
    let mut areas = [[0.0; D]; N];
    for k in 0..D {
        for j in 0..D {
            areas[k + 1][j] = cofactor[k][j] / factorial(D);
            areas[0][j] -= areas[k + 1][j];
        }
    }
    (determinant / factorial(D), areas)
}

/// D!
fn factorial(dimension: usize) -> f64 {
    if dimension == 2 { 2.0 } else { 6.0 }
}

/// Cofactors of the matrix whose rows are the edges from the first vertex.
fn cofactors<const D: usize, const N: usize>(vertices: &[Vector<D>; N]) -> [Vector<D>; D] {
    let edge: [Vector<D>; D] = std::array::from_fn(|k| difference(&vertices[k + 1], &vertices[0]));
    std::array::from_fn(|k| cofactor_row(&edge, k))
}

/// Row `k` of the cofactors of the matrix with rows `edge`: normal to all other rows.
fn cofactor_row<const D: usize>(edge: &[Vector<D>; D], k: usize) -> Vector<D> {
    if D == 2 {
        let other = &edge[1 - k];
        let sign = if k == 0 { 1.0 } else { -1.0 };
        std::array::from_fn(|j| if j == 0 { sign * other[1] } else { -sign * other[0] })
    } else {
        let (a, b) = (&edge[(k + 1) % 3], &edge[(k + 2) % 3]);
        std::array::from_fn(|j| a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3])
    }
}

/// Barycentric coordinates `λ` of `x`: `Σ λ_i = 1`, `x = Σ λ_i x_i`, all non-negative inside.
///
/// Taken from differences to a vertex, so that they are exact to round-off wherever the simplex lies.
pub fn barycentric<const D: usize, const N: usize>(
    gradients: &[Vector<D>; N],
    vertices: &[Vector<D>; N],
    x: &Vector<D>,
) -> [f64; N] {
    let (from_first, from_second) = (difference(x, &vertices[0]), difference(x, &vertices[1]));
    std::array::from_fn(|i| dot(&gradients[i], if i == 0 { &from_second } else { &from_first }))
}

/// Longest edge of a simplex.
pub fn longest_edge<const D: usize, const N: usize>(vertices: &[Vector<D>; N]) -> f64 {
    let pairs = (0..N).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs.map(|(i, j)| distance(&vertices[i], &vertices[j])).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TETRAHEDRON: [[f64; 3]; 4] = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.2], [0.2, 1.5, 0.4], [0.3, 0.1, 1.9]];

    #[test]
    fn shape_functions_are_one_at_their_vertex_and_zero_at_the_others() {
        let (volume, gradients) = volume_and_gradients(&TETRAHEDRON);
        assert!(volume > 0.0);
        for (i, vertex) in TETRAHEDRON.iter().enumerate() {
            let coordinates = barycentric(&gradients, &TETRAHEDRON, vertex);
            for (j, value) in coordinates.iter().enumerate() {
                assert!((value - f64::from(u8::from(i == j))).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn the_unit_simplices_have_volume_one_half_and_one_sixth() {
        assert_eq!(volume_and_gradients(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).0, 0.5);
        let unit = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(volume_and_gradients(&unit).0, 1.0 / 6.0);
        let inverted = [unit[1], unit[0], unit[2], unit[3]];
        assert_eq!(volume_and_gradients(&inverted).0, -1.0 / 6.0);
    }

    #[test]
    fn barycentric_coordinates_do_not_lose_digits_far_from_the_origin() {
        let far = TETRAHEDRON.map(|v| v.map(|c| (c * 1024.0).round() / 1024.0 + 1e6));
        let (_, gradients) = volume_and_gradients(&far);
        let middle: [f64; 3] = std::array::from_fn(|k| far.iter().map(|v| v[k] / 4.0).sum());
        for value in barycentric(&gradients, &far, &middle) {
            assert!((value - 0.25).abs() < 1e-9, "{value}");
        }
    }
}
