//! Grains as shaded spheres, or in the plane as discs with a rim.

use super::camera::Camera;
use super::colour_map::Colour;
use super::layer::Layer;
use super::scene::Grain;
use super::shading::{lit_grain, scaled};

/// Smallest radius on screen \[pixels\]: a grain never vanishes.
const SMALLEST: f64 = 1.0;

pub(super) fn draw_sphere(layer: &mut Layer, camera: &Camera, grain: &Grain, colour: Colour) {
    let [x, y, depth] = camera.project(grain.centre);
    let radius = (grain.radius * camera.scale).max(SMALLEST);
    for (index, place) in layer.window([x - radius, y - radius], [x + radius, y + radius]) {
        let (dx, dy) = ((place[0] - x) / radius, (place[1] - y) / radius);
        let height_squared = 1.0 - dx * dx - dy * dy;
        if height_squared > 0.0 {
            let height = height_squared.sqrt();
            layer.paint(index, depth + radius * height, lit_grain(colour, [dx, -dy, height]));
        }
    }
}

pub(super) fn draw_disc(layer: &mut Layer, camera: &Camera, grain: &Grain, colour: Colour) {
    let [x, y, depth] = camera.project(grain.centre);
    let radius = (grain.radius * camera.scale).max(SMALLEST);
    let rim = if radius > 6.0 { (0.08 * radius).clamp(1.0, 3.0) } else { 0.0 };
    let dark = scaled(colour, 0.55);
    for (index, place) in layer.window([x - radius, y - radius], [x + radius, y + radius]) {
        let distance = (place[0] - x).hypot(place[1] - y);
        if distance < radius {
            layer.paint(index, depth + 1.0, if distance > radius - rim { dark } else { colour });
        }
    }
}
