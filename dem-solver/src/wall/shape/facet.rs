//! A triangle, or in 2D a segment.

use super::{Nearest, Piece};
use crate::vector::{Spin, Vector};
use surface::Facet;
use surface::motion::Travel;

impl<const D: usize> Piece<D> for Facet<D> {
    #[inline]
    fn nearest(&self, centre: &Vector<D>) -> Nearest<D> {
        let to_wall = self.closest_point(centre) - centre;
        let distance = to_wall.norm();
        let normal = if distance > 0.0 { to_wall / distance } else { Vector::zeros() };
        Nearest { distance, normal }
    }

    fn bounds(&self) -> Option<(Vector<D>, Vector<D>)> {
        let corners = self.vertices.iter().map(|vertex| (*vertex, *vertex));
        corners.reduce(|a, b| (a.0.inf(&b.0), a.1.sup(&b.1)))
    }

    fn encloses(&self) -> bool {
        false
    }

    fn tilts(&self, _: &Spin) -> bool {
        false
    }

    fn approach(&self, travel: &Travel<D>) -> f64 {
        self.vertices.iter().map(|vertex| travel.of_point(vertex).norm()).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_above_the_face_is_nearest_to_its_foot() {
        let triangle = Facet::new([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        let nearest = triangle.nearest(&Vector::from([0.25, 0.25, 0.5]));
        assert_eq!((nearest.distance, nearest.normal), (0.5, Vector::from([0.0, 0.0, -1.0])));
    }
}
