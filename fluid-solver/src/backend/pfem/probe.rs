//! The fluid at a point, and its surface above one.

use super::cloud::{Cloud, OUTSIDE};
use super::remesh::TargetSize;
use crate::backend::PointValue;
use crate::element::closest_point::on_facet;
use crate::element::simplex::{Vector, barycentric, distance, volume_and_gradients};

/// A cell holds a point if no barycentric coordinate is below this: the round-off of their computation.
const INSIDE: f64 = -1e-12;
/// Outside, the fluid is looked for this far away, in target sizes.
const NEAR: f64 = 0.5;

/// The fluid at a point: in the first cell that holds it, else at the nearest place of the boundary within half a size; none
/// beyond.
pub fn at<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    x: &Vector<D>,
    size: &TargetSize,
) -> Option<PointValue> {
    let inside = |cell: &[u32; N]| Some((*cell, coordinates(cloud, cell, x)?));
    let holding = cloud.cells.iter().filter_map(inside).find(|(_, c)| c.iter().all(|&c| c >= INSIDE));
    let (cell, coordinates) = match holding {
        Some(found) => found,
        None => {
            let (cell, place) = nearest(cloud, x)?;
            if distance(&place, x) > NEAR * size.largest() {
                return None;
            }
            (cell, coordinates(cloud, &cell, &place)?)
        }
    };
    let weighted = |value: &dyn Fn(usize) -> f64| {
        cell.iter().zip(&coordinates).map(|(&node, share)| share * value(node as usize)).sum::<f64>()
    };
    let velocity =
        std::array::from_fn(|k| if k < D { weighted(&|node| cloud.velocity[node][k]) } else { 0.0 });
    Some(PointValue { velocity, pressure: weighted(&|node| cloud.pressure[node]), void_fraction: 1.0 })
}

/// The highest place of the fluid, along the last axis, on the line along that axis through a point (m); none where the line
/// misses it.
pub fn elevation<const D: usize, const N: usize>(cloud: &Cloud<D, N>, x: &Vector<D>) -> Option<f64> {
    let top = |cell: &[u32; N]| {
        let vertices = cloud.vertices(cell);
        let (volume, gradients) = volume_and_gradients(&vertices);
        if volume <= 0.0 {
            return None;
        }
        // λ_i(z) = λ_i(x) + (z − x_D) ∂λ_i/∂z ≥ 0 for all i.
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for (share, gradient) in barycentric(&gradients, &vertices, x).into_iter().zip(&gradients) {
            let slope = gradient[D - 1];
            let end = x[D - 1] + (INSIDE - share) / slope;
            if slope > 0.0 {
                low = low.max(end);
            } else if slope < 0.0 {
                high = high.min(end);
            } else if share < INSIDE {
                return None;
            }
        }
        (low <= high).then_some(high)
    };
    cloud.cells.iter().filter_map(top).reduce(f64::max)
}

/// Barycentric coordinates in a cell that has a volume.
fn coordinates<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    cell: &[u32; N],
    x: &Vector<D>,
) -> Option<[f64; N]> {
    let vertices = cloud.vertices(cell);
    let (volume, gradients) = volume_and_gradients(&vertices);
    (volume > 0.0).then(|| barycentric(&gradients, &vertices, x))
}

/// The cell and the place on its boundary that are nearest to a point.
fn nearest<const D: usize, const N: usize>(
    cloud: &Cloud<D, N>,
    x: &Vector<D>,
) -> Option<([u32; N], Vector<D>)> {
    let faces = cloud.cells.iter().zip(&cloud.neighbours).flat_map(|(cell, around)| {
        let free = (0..N).filter(|&corner| around[corner] == OUTSIDE);
        free.map(|corner| {
            let nodes: [u32; D] = std::array::from_fn(|k| cell[(corner + 1 + k) % N]);
            let place = on_facet(&nodes.map(|node| cloud.place[node as usize]), x);
            (distance(&place, x), (*cell, place))
        })
    });
    faces.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, found)| found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::backend::pfem::body::Body;

    fn tank() -> Cloud<2, 3> {
        let body = Body::<2, 3>::of_box([0.0; 2], [2.0, 1.0], 0.1).unwrap();
        let mut cloud = body.with_surface(0.0, 1.0, |x| 1.0 + 0.1 * x[0]).cloud();
        for (p, x) in cloud.pressure.iter_mut().zip(&cloud.place) {
            *p = 5.0 - 3.0 * x[1];
        }
        cloud
    }

    #[test]
    fn a_probe_reads_in_the_fluid_and_half_a_cell_beside_it() {
        let (cloud, size) = (tank(), TargetSize::Constant(0.1));
        let p = |x: [f64; 2]| at(&cloud, &x, &size).map(|value| value.pressure);
        assert!((p([0.33, 0.4]).unwrap() - 3.8).abs() < 1e-12);
        assert!((p([-0.04, 0.5]).unwrap() - 3.5).abs() < 1e-12, "as at the wall beside it");
        assert_eq!(p([-0.06, 0.5]), None);
    }

    #[test]
    fn the_surface_is_found_above_a_point_wherever_it_is_stated() {
        let cloud = tank();
        for height in [-3.0, 0.2, 9.0] {
            assert!((elevation(&cloud, &[1.23, height]).unwrap() - 1.123).abs() < 1e-9);
        }
        assert!((elevation(&cloud, &[0.0, 0.0]).unwrap() - 1.0).abs() < 1e-9, "on a wall too");
        assert_eq!(elevation(&cloud, &[2.1, 0.5]), None);
    }
}
