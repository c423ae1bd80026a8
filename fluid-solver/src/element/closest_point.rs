//! The point of a boundary facet that is closest to a given point.

use super::simplex::{Vector, difference, distance, dot};

/// Closest point to `x` on the facet with `D` vertices: a segment in the plane, a triangle in space.
///
/// A triangle is tried by its foot point first, then by its three edges (Ericson, *Real-Time Collision
/// Detection*, §5.1).
pub fn on_facet<const D: usize>(vertices: &[Vector<D>; D], x: &Vector<D>) -> Vector<D> {
    const { assert!(D == 2 || D == 3) };
    if D == 2 {
        return on_segment(&vertices[0], &vertices[1], x);
    }
    if let Some(foot) = foot_in_triangle(vertices, x) {
        return foot;
    }
    let candidates = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| on_segment(&vertices[i], &vertices[j], x));
    let nearer = |a: Vector<D>, b: Vector<D>| if distance(&b, x) < distance(&a, x) { b } else { a };
    nearer(nearer(candidates[0], candidates[1]), candidates[2])
}

fn on_segment<const D: usize>(a: &Vector<D>, b: &Vector<D>, x: &Vector<D>) -> Vector<D> {
    let along = difference(b, a);
    let t = (dot(&difference(x, a), &along) / dot(&along, &along)).clamp(0.0, 1.0);
    std::array::from_fn(|k| a[k] + t * along[k])
}

/// The orthogonal foot of `x` in the triangle's plane, if it lies in the triangle.
fn foot_in_triangle<const D: usize>(vertices: &[Vector<D>; D], x: &Vector<D>) -> Option<Vector<D>> {
    let (u, v) = (difference(&vertices[1], &vertices[0]), difference(&vertices[2], &vertices[0]));
    let w = difference(x, &vertices[0]);
    let (uu, uv, vv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v));
    let (wu, wv) = (dot(&w, &u), dot(&w, &v));
    let determinant = uu * vv - uv * uv;
    let s = (wu * vv - wv * uv) / determinant;
    let t = (wv * uu - wu * uv) / determinant;
    (s >= 0.0 && t >= 0.0 && s + t <= 1.0)
        .then(|| std::array::from_fn(|k| vertices[0][k] + s * u[k] + t * v[k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closest_point_is_the_foot_the_edge_or_the_vertex() {
        let triangle = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        assert_eq!(on_facet(&triangle, &[0.25, 0.25, 3.0]), [0.25, 0.25, 0.0]);
        assert_eq!(on_facet(&triangle, &[0.5, -2.0, 1.0]), [0.5, 0.0, 0.0]);
        assert_eq!(on_facet(&triangle, &[1.0, 1.0, 0.0]), [0.5, 0.5, 0.0]);
        assert_eq!(on_facet(&triangle, &[-1.0, -1.0, 5.0]), [0.0; 3]);
        assert_eq!(on_facet(&[[0.0, 0.0], [2.0, 0.0]], &[1.5, 4.0]), [1.5, 0.0]);
        assert_eq!(on_facet(&[[0.0, 0.0], [2.0, 0.0]], &[9.0, 4.0]), [2.0, 0.0]);
    }
}
