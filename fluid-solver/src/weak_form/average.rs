//! Averages over a simplex of products of shape functions and a linear field.

use crate::element::simplex::Vector;

/// ⟨N_a N_b⟩ = (1 + δ_ab) / (N (N + 1)), N = D + 1.
pub fn share<const N: usize>(a: usize, b: usize) -> f64 {
    let same = if a == b { 2.0 } else { 1.0 };
    same * reciprocal(N * (N + 1))
}

/// 1/n, a constant: multiplying is faster than dividing.
const fn reciprocal(n: usize) -> f64 {
    1.0 / n as f64
}

/// A linear field f on a simplex, ready for averages ⟨·⟩ = ∫·/V.
///
/// From ∫ Π λ_k^{e_k} = V D! Π e_k! / (D + Σ e_k)!.
#[derive(Debug, Clone, Copy)]
pub struct Average<const N: usize> {
    /// Values f_k at the vertices.
    pub values: [f64; N],
    /// Σ_k f_k.
    sum: f64,
}

impl<const N: usize> Average<N> {
    /// The field with these values at the vertices.
    pub fn new(values: [f64; N]) -> Self {
        Self { values, sum: values.iter().sum() }
    }

    /// ⟨f⟩ = Σ f_k / N.
    pub fn mean(&self) -> f64 {
        self.sum * reciprocal(N)
    }

    /// ⟨N_a f⟩ = (Σ f_k + f_a) / (N (N + 1)).
    pub fn first(&self, a: usize) -> f64 {
        (self.sum + self.values[a]) * reciprocal(N * (N + 1))
    }

    /// ⟨N_a N_b f⟩ = (1 + δ_ab)(Σ f_k + f_a + f_b) / (N (N + 1) (N + 2)).
    pub fn second(&self, a: usize, b: usize) -> f64 {
        let same = if a == b { 2.0 } else { 1.0 };
        same * (self.sum + self.values[a] + self.values[b]) * reciprocal(N * (N + 1) * (N + 2))
    }

    /// ⟨N_a f x⟩ = Σ_b ⟨N_a N_b f⟩ x_b = ((Σ f_k + f_a) Σ x_b + Σ f_b x_b + (Σ f_k + 2 f_a) x_a) / (N (N + 1) (N + 2)) for
    /// a linear vector field x and every a.
    pub fn moments<const D: usize>(&self, x: &[Vector<D>; N]) -> [Vector<D>; N] {
        let total: Vector<D> = std::array::from_fn(|k| x.iter().map(|x| x[k]).sum());
        let weighted: Vector<D> = std::array::from_fn(|k| (0..N).map(|b| self.values[b] * x[b][k]).sum());
        std::array::from_fn(|a| {
            let value = self.values[a];
            let (all, own) = (self.sum + value, self.sum + 2.0 * value);
            std::array::from_fn(|k| {
                (all * total[k] + weighted[k] + own * x[a][k]) * reciprocal(N * (N + 1) * (N + 2))
            })
        })
    }

    /// ⟨f²⟩ = ((Σ f_k)² + Σ f_k²) / (N (N + 1)).
    pub fn square(&self) -> f64 {
        let squares: f64 = self.values.iter().map(|f| f * f).sum();
        (self.sum * self.sum + squares) * reciprocal(N * (N + 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::quadrature::degree_5;

    fn agrees<const D: usize, const N: usize>(values: [f64; N]) {
        let average = Average::new(values);
        let quadrature = |f: &dyn Fn(&[f64; N]) -> f64| {
            degree_5::<D, N>().iter().map(|(point, weight)| weight * f(point)).sum::<f64>()
        };
        let field = |point: &[f64; N]| (0..N).map(|k| point[k] * values[k]).sum::<f64>();
        let close = |exact: f64, found: f64| assert!((exact - found).abs() < 1e-14, "{exact} {found}");
        close(quadrature(&|x| field(x)), average.mean());
        close(quadrature(&|x| field(x).powi(2)), average.square());
        let other: [Vector<2>; N] = std::array::from_fn(|b| [b as f64 - 0.6, (b * b) as f64]);
        let moments = average.moments(&other);
        for a in 0..N {
            for k in 0..2 {
                let component = |x: &[f64; N]| (0..N).map(|b| x[b] * other[b][k]).sum::<f64>();
                close(quadrature(&|x| x[a] * field(x) * component(x)), moments[a][k]);
            }
            close(quadrature(&|x| x[a] * field(x)), average.first(a));
            for b in 0..N {
                close(quadrature(&|x| x[a] * x[b] * field(x)), average.second(a, b));
                close(quadrature(&|x| x[a] * x[b]), share::<N>(a, b));
            }
        }
    }

    #[test]
    fn closed_forms_are_the_integrals() {
        agrees::<2, 3>([0.4, 1.0, 0.7]);
        agrees::<3, 4>([0.4, 1.0, 0.7, -0.3]);
    }
}
