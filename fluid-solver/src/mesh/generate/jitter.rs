//! Random displacement of inner nodes, to test accuracy on irregular meshes.

use crate::element::simplex::{Vector, volume_and_gradients};
use crate::mesh::MeshError;

/// No cell loses more than this share of its volume in one displacement.
const LARGEST_LOSS: f64 = 0.8;

/// Displaces each inner node by up to `fraction` of the brick size along every axis.
///
/// A displacement that would take more than 80 % of the volume of a cell is not made, so that every cell stays positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jitter {
    /// Largest displacement over the brick's shortest edge, 0 to 0.5.
    pub fraction: f64,
    /// Seed: the same seed gives the same mesh.
    pub seed: u64,
}

impl Jitter {
    /// Moves the points that are `inner`.
    pub(super) fn apply<const D: usize, const N: usize>(
        &self,
        points: &mut [Vector<D>],
        cells: &[[u32; N]],
        brick: f64,
        inner: impl Fn(usize) -> bool,
    ) -> Result<(), MeshError> {
        if !(0.0..=0.5).contains(&self.fraction) {
            return Err(MeshError::Generator {
                generator: "jitter",
                key: "fraction",
                found: self.fraction.to_string(),
                allowed: "0 to 0.5",
            });
        }
        let volume = |points: &[Vector<D>], cell: u32| {
            volume_and_gradients(&cells[cell as usize].map(|point| points[point as usize])).0
        };
        let around = cells_around(points.len(), cells);
        let mut random = SplitMix64(self.seed);
        for point in (0..points.len()).filter(|&point| inner(point)) {
            let old = points[point];
            let before: Vec<f64> = around[point].iter().map(|&cell| volume(points, cell)).collect();
            points[point] = old.map(|c| c + self.fraction * brick * (2.0 * random.next_unit() - 1.0));
            let mut pairs = around[point].iter().zip(&before);
            if pairs.any(|(&cell, before)| volume(points, cell) < (1.0 - LARGEST_LOSS) * before) {
                points[point] = old;
            }
        }
        Ok(())
    }
}

fn cells_around<const N: usize>(points: usize, cells: &[[u32; N]]) -> Vec<Vec<u32>> {
    let mut around = vec![Vec::new(); points];
    for (index, cell) in cells.iter().enumerate() {
        cell.iter().for_each(|&point| around[point as usize].push(index as u32));
    }
    around
}

/// Steele, Lea & Flood, OOPSLA 2014.
struct SplitMix64(u64);

impl SplitMix64 {
    /// Uniform in `[0, 1)`.
    fn next_unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
