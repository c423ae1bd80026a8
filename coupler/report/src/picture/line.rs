//! Lines that hide behind what is nearer.

use super::camera::Pixel;
use super::colour_map::Colour;
use super::layer::{Layer, around};

/// Draws a line with round ends, a little nearer than it is, so that it is not hidden by its own face.
pub(super) fn draw_line(layer: &mut Layer, from: Pixel, to: Pixel, width: f64, colour: Colour) {
    let along = [to[0] - from[0], to[1] - from[1]];
    let length_squared = along[0] * along[0] + along[1] * along[1];
    if !length_squared.is_finite() {
        return;
    }
    let radius = 0.5 * width;
    let (low, high) = around(&[from, to]);
    for (index, place) in layer.window(low.map(|x| x - radius), high.map(|x| x + radius)) {
        let arm = [place[0] - from[0], place[1] - from[1]];
        // The nearest point of the segment; a segment without length is its first end.
        let projected = (arm[0] * along[0] + arm[1] * along[1]) / length_squared;
        let share = if projected.is_nan() { 0.0 } else { projected.clamp(0.0, 1.0) };
        if (arm[0] - share * along[0]).hypot(arm[1] - share * along[1]) <= radius {
            layer.paint(index, from[2] + share * (to[2] - from[2]) + width, colour);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_as_wide_as_it_should_be_and_hides_behind_what_is_nearer() {
        let mut layer = Layer::new([60, 40], [1.0; 3]);
        draw_line(&mut layer, [10.0, 20.0, 0.0], [50.0, 20.0, 0.0], 4.0, [0.0; 3]);
        let painted = |layer: &Layer| layer.colour.iter().filter(|colour| colour[0] == 0.0).count();
        let expected = 40.0 * 4.0 + std::f64::consts::PI * 4.0;
        assert!((painted(&layer) as f64 - expected).abs() < 8.0, "{} of {expected}", painted(&layer));

        let mut hidden = Layer::new([60, 40], [1.0; 3]);
        hidden.depth.fill(10.0);
        draw_line(&mut hidden, [10.0, 20.0, 0.0], [50.0, 20.0, 0.0], 4.0, [0.0; 3]);
        assert_eq!(painted(&hidden), 0);
    }
}
