//! Integrals over a boundary face.

use super::share;
use crate::element::simplex::{Vector, dot};

/// A boundary face with D corners and its outward area vector (m²; m in 2D).
#[derive(Debug, Clone, Copy)]
pub struct Facet<const D: usize> {
    /// Area times outward normal.
    pub area: Vector<D>,
}

impl<const D: usize> Facet<D> {
    /// ∮ N_a N_b f n for a linear f: A (1 + δ_ab)(Σ f_k + f_a + f_b) / (D (D + 1) (D + 2)).
    pub fn second(&self, f: &[f64; D], a: usize, b: usize) -> Vector<D> {
        let same = if a == b { 2.0 } else { 1.0 };
        let sum: f64 = f.iter().sum();
        let factor = same * (sum + f[a] + f[b]) / (D * (D + 1) * (D + 2)) as f64;
        self.area.map(|area| factor * area)
    }

    /// ∮ f g n for linear f and g.
    pub fn product(&self, f: &[f64; D], g: &[f64; D]) -> Vector<D> {
        let pairs = (0..D).flat_map(|a| (0..D).map(move |b| (a, b)));
        let factor: f64 = pairs.map(|(a, b)| f[a] * g[b] * share::<D>(a, b)).sum();
        self.area.map(|area| factor * area)
    }

    /// ∮ N_a f g n for linear f and g.
    pub fn triple(&self, f: &[f64; D], g: &[f64; D], a: usize) -> Vector<D> {
        (0..D).fold([0.0; D], |sum, b| {
            let part = self.second(f, a, b);
            std::array::from_fn(|k| sum[k] + g[b] * part[k])
        })
    }

    /// ∮ ε (v·n)₊ N_a N_b: what leaves, by the rule of degree 2 (3 in 2D) with D points, where ε and v are linear.
    pub fn outflow(&self, void_fraction: &[f64; D], velocity: &[Vector<D>; D]) -> [[f64; D]; D] {
        let side = (1.0 - 1.0 / (D as f64 + 1.0).sqrt()) / D as f64;
        let mut outflow = [[0.0; D]; D];
        for point in 0..D {
            let shape: [f64; D] =
                std::array::from_fn(|a| if a == point { 1.0 - (D as f64 - 1.0) * side } else { side });
            let normal: f64 = (0..D).map(|a| shape[a] * dot(&velocity[a], &self.area)).sum();
            let void: f64 = (0..D).map(|a| shape[a] * void_fraction[a]).sum();
            let weight = void * normal.max(0.0) / D as f64;
            for a in 0..D {
                for b in 0..D {
                    outflow[a][b] += weight * shape[a] * shape[b];
                }
            }
        }
        outflow
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_of_a_face_add_up_to_the_face() {
        let facet = Facet { area: [0.0, 3.0, 4.0] };
        let (f, one) = ([0.4, 1.0, 0.7], [1.0; 3]);
        let mean = 0.7;
        let sum = |parts: Vec<Vector<3>>| parts.iter().fold(0.0, |sum, part| sum + part[2]);
        let close = |found: f64| assert!((found - mean * 4.0).abs() < 1e-14, "{found}");
        close(facet.product(&f, &one)[2]);
        close(sum((0..3).map(|a| facet.triple(&f, &one, a)).collect()));
        close(sum((0..9).map(|ab| facet.second(&f, ab / 3, ab % 3)).collect()));
    }

    #[test]
    fn outflow_counts_what_leaves_and_never_what_enters() {
        let facet = Facet { area: [2.0, 0.0] };
        let total = |u: [[f64; 2]; 2]| facet.outflow(&[0.5, 0.5], &u).as_flattened().iter().sum::<f64>();
        assert!((total([[3.0, 1.0]; 2]) - 0.5 * 3.0 * 2.0).abs() < 1e-14);
        assert_eq!(total([[-3.0, 1.0]; 2]), 0.0);
    }
}
