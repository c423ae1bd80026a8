//! Triangles whose value is linear between the nodes.

use super::camera::Pixel;
use super::colour_map::Colour;
use super::layer::{Layer, around};

/// Fills a triangle; `colour` turns the value at a pixel into its colour.
pub(super) fn draw_triangle(
    layer: &mut Layer,
    corners: [Pixel; 3],
    values: [f64; 3],
    colour: impl Fn(f64) -> Colour,
) {
    let [a, b, c] = corners;
    let double_area = edge(a, b, [c[0], c[1]]);
    if !(double_area.is_finite() && double_area != 0.0) {
        return;
    }
    let (low, high) = around(&corners);
    for (index, place) in layer.window(low, high) {
        let weights =
            [edge(b, c, place), edge(c, a, place), edge(a, b, place)].map(|part| part / double_area);
        if weights.iter().all(|&weight| weight >= 0.0) {
            let mean = |at: [f64; 3]| weights[0] * at[0] + weights[1] * at[1] + weights[2] * at[2];
            layer.paint(index, mean([a[2], b[2], c[2]]), colour(mean(values)));
        }
    }
}

/// Twice the signed area of the triangle `from`, `to`, `place`.
fn edge(from: Pixel, to: Pixel, place: [f64; 2]) -> f64 {
    (to[0] - from[0]) * (place[1] - from[1]) - (to[1] - from[1]) * (place[0] - from[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_triangles_fill_their_square_once_with_linear_values() {
        let mut layer = Layer::new([20, 20], [0.0; 3]);
        let corner = |x: f64, y: f64| [x, y, 0.0];
        let square = [corner(0.0, 0.0), corner(20.0, 0.0), corner(20.0, 20.0), corner(0.0, 20.0)];
        let grey = |value: f64| [value as f32; 3];
        for [i, j, k] in [[0, 1, 2], [0, 3, 2]] {
            let corners = [square[i], square[j], square[k]];
            draw_triangle(&mut layer, corners, corners.map(|corner| corner[0] / 20.0), grey);
        }
        for (index, colour) in layer.colour.iter().enumerate() {
            let x = (index % 20) as f32 + 0.5;
            assert!((colour[0] - x / 20.0).abs() < 1e-6, "pixel {index}");
        }
    }

    #[test]
    fn degenerate_and_non_finite_triangles_draw_nothing() {
        let mut layer = Layer::new([8, 8], [0.0; 3]);
        for x in [0.0, f64::NAN, f64::INFINITY] {
            let corners = [[x, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 0.0]];
            draw_triangle(&mut layer, corners, [1.0; 3], |_| [1.0; 3]);
        }
        assert!(layer.depth.iter().all(|&depth| depth == f32::NEG_INFINITY));
    }
}
