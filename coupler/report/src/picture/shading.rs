//! Light and the darkening of crevices.

use super::colour_map::Colour;
use super::layer::Layer;
use super::vector::{Vector, dot, unit};

/// From the scene to the lamp, in the frame of the image: over the viewer's left shoulder.
const LAMP: Vector = [-0.45, 0.6, 0.8];

/// The colour of a grain under the lamp, with a faint highlight; `normal` is in the frame of the image.
pub(super) fn lit_grain(colour: Colour, normal: Vector) -> Colour {
    let lamp = unit(LAMP);
    let diffuse = diffuse(normal);
    let highlight = dot(normal, unit([lamp[0], lamp[1], lamp[2] + 1.0])).max(0.0).powi(40) as f32;
    colour.map(|part| (part * (0.5 + 0.56 * diffuse) + 0.18 * highlight).min(1.0))
}

/// The colour of the fluid's surface under the lamp: shaded little, so that the colour bar still holds.
pub(super) fn lit_surface(colour: Colour, normal: Vector) -> Colour {
    scaled(colour, 0.8 + 0.2 * diffuse(normal))
}

/// Lambert's cosine.
fn diffuse(normal: Vector) -> f32 {
    dot(normal, unit(LAMP)).max(0.0) as f32
}

pub(super) fn scaled(colour: Colour, factor: f32) -> Colour {
    colour.map(|part| part * factor)
}

/// Darkens a pixel by how much nearer its surroundings are, in units of `scale` pixels: packed grains come apart.
///
/// Eye-dome lighting, C. Boucheny, Université Joseph Fourier (2009): f = exp(−k Σ max(0, Δdepth)/scale).
pub(super) fn darken_crevices(layer: &mut Layer, scale: f32) {
    const STRENGTH: f32 = 0.11;
    const LARGEST_STEP: f32 = 1.5;
    let [width, height] = layer.size;
    let distance = (0.35 * scale).clamp(2.0, 8.0) as isize;
    let slanted = (0.7 * distance as f32).round() as isize;
    let around = [
        (distance, 0),
        (-distance, 0),
        (0, distance),
        (0, -distance),
        (slanted, slanted),
        (slanted, -slanted),
        (-slanted, slanted),
        (-slanted, -slanted),
    ];
    for row in 0..height {
        for column in 0..width {
            let index = row * width + column;
            let depth = layer.depth[index];
            if depth == f32::NEG_INFINITY {
                continue;
            }
            let nearer: f32 = around
                .iter()
                .filter_map(|&(dx, dy)| {
                    let x = column.checked_add_signed(dx).filter(|&x| x < width)?;
                    let y = row.checked_add_signed(dy).filter(|&y| y < height)?;
                    Some(((layer.depth[y * width + x] - depth) / scale).clamp(0.0, LARGEST_STEP))
                })
                .sum();
            layer.colour[index] = scaled(layer.colour[index], (-STRENGTH * nearer).exp());
        }
    }
}
