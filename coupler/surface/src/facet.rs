//! A triangle, or in 2D a segment.

use crate::vector::Vector;

/// The simplex of `D` vertices: a triangle in 3D, a segment in 2D; it pushes to both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet<const D: usize> {
    /// Vertices \[m\].
    pub vertices: [Vector<D>; D],
}

impl<const D: usize> Facet<D> {
    /// The facet of these vertices.
    pub fn new(vertices: [[f64; D]; D]) -> Self {
        Self { vertices: vertices.map(Vector::from) }
    }

    /// The point of the facet nearest to `p`.
    pub fn closest_point(&self, p: &Vector<D>) -> Vector<D> {
        let v = &self.vertices;
        if D == 2 { on_segment(p, &v[0], &v[1]) } else { on_triangle(p, &v[0], &v[1], &v[D - 1]) }
    }
}

fn on_segment<const D: usize>(p: &Vector<D>, a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    let edge = b - a;
    a + edge * ((p - a).dot(&edge) / edge.norm_squared()).clamp(0.0, 1.0)
}

/// By Voronoi regions of vertices, edges and face.
/// Source: Ericson, Real-Time Collision Detection (2005), section 5.1.5.
fn on_triangle<const D: usize>(p: &Vector<D>, a: &Vector<D>, b: &Vector<D>, c: &Vector<D>) -> Vector<D> {
    let (ab, ac) = (b - a, c - a);
    let projections = |from: &Vector<D>| (ab.dot(&(p - from)), ac.dot(&(p - from)));
    let (d1, d2) = projections(a);
    if d1 <= 0.0 && d2 <= 0.0 {
        return *a;
    }
    let (d3, d4) = projections(b);
    if d3 >= 0.0 && d4 <= d3 {
        return *b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let (d5, d6) = projections(c);
    if d6 >= 0.0 && d5 <= d6 {
        return *c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let scale = 1.0 / (va + vb + vc);
    a + ab * (vb * scale) + ac * (vc * scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closest_point_beats_every_sampled_point_of_the_triangle() {
        let triangle = Facet::new([[0.1, 0.0, 0.2], [1.0, 0.1, 0.0], [0.3, 0.9, 0.4]]);
        let [a, b, c] = triangle.vertices;
        for k in 0..200 {
            let k = f64::from(k);
            let p = Vector::from([(k * 0.37).sin() * 1.5, (k * 0.73).cos() * 1.5, (k * 1.1).sin()]);
            let best = (triangle.closest_point(&p) - p).norm();
            for s in 0..=20 {
                for t in 0..=20 - s {
                    let q = a + (b - a) * (f64::from(s) / 20.0) + (c - a) * (f64::from(t) / 20.0);
                    assert!(best <= (q - p).norm() + 1e-12);
                }
            }
        }
    }
}
