//! An image with a depth per pixel.

use super::camera::Pixel;
use super::colour_map::Colour;

/// Colours with depths; a pixel that nothing covers has depth −∞.
#[derive(Debug, Clone)]
pub(super) struct Layer {
    pub(super) size: [usize; 2],
    pub(super) colour: Vec<Colour>,
    pub(super) depth: Vec<f32>,
}

impl Layer {
    pub(super) fn new(size: [usize; 2], background: Colour) -> Self {
        let pixels = size[0] * size[1];
        Self { size, colour: vec![background; pixels], depth: vec![f32::NEG_INFINITY; pixels] }
    }

    /// Visits the pixels whose centres may lie within `reach` of a place.
    pub(super) fn window(
        &self,
        low: [f64; 2],
        high: [f64; 2],
    ) -> impl Iterator<Item = (usize, [f64; 2])> + use<> {
        let width = self.size[0];
        // A cast saturates: what lies left of or above the image begins at 0.
        let begin = low.map(|x| x.floor() as usize);
        let end: [usize; 2] = std::array::from_fn(|k| (high[k].ceil().max(0.0) as usize).min(self.size[k]));
        (begin[1]..end[1]).flat_map(move |row| {
            (begin[0]..end[0])
                .map(move |column| (row * width + column, [column as f64 + 0.5, row as f64 + 0.5]))
        })
    }

    /// Paints a pixel unless something nearer is there.
    pub(super) fn paint(&mut self, index: usize, depth: f64, colour: Colour) {
        let depth = depth as f32;
        if depth > self.depth[index] {
            self.depth[index] = depth;
            self.colour[index] = colour;
        }
    }

    /// Lays `veil` over this layer where it is nearer, letting 1 − `opacity` shine through.
    pub(super) fn cover(&mut self, veil: &Self, opacity: f32) {
        let nearer = veil.depth.iter().zip(&self.depth).map(|(veil, own)| veil > own);
        for ((own, over), nearer) in self.colour.iter_mut().zip(&veil.colour).zip(nearer) {
            if nearer {
                *own = std::array::from_fn(|k| own[k] + opacity * (over[k] - own[k]));
            }
        }
    }

    /// The mean of every 2 × 2 pixels, as bytes.
    pub(super) fn halved(&self) -> ([usize; 2], Vec<[u8; 3]>) {
        let [width, height] = self.size.map(|size| size / 2);
        let mut pixels = Vec::with_capacity(width * height);
        for row in 0..height {
            for column in 0..width {
                let first = 2 * row * self.size[0] + 2 * column;
                let four = [first, first + 1, first + self.size[0], first + self.size[0] + 1];
                pixels.push(std::array::from_fn(|k| {
                    let mean = four.map(|index| self.colour[index][k]).iter().sum::<f32>() / 4.0;
                    (255.0 * mean.clamp(0.0, 1.0)).round() as u8
                }));
            }
        }
        ([width, height], pixels)
    }
}

/// The box around places in the image.
pub(super) fn around(places: &[Pixel]) -> ([f64; 2], [f64; 2]) {
    let fold = |start: f64, pick: fn(f64, f64) -> f64| {
        [0, 1].map(|k| places.iter().map(|place| place[k]).fold(start, pick))
    };
    (fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max))
}
