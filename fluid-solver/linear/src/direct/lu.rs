//! Dense LU factor.

use crate::{Csr, Error};

/// P A = L U of a small dense matrix, by partial pivoting.
///
/// Source: Golub and Van Loan, *Matrix Computations*, 4th ed. 2013, algorithm 3.4.1.
#[derive(Debug, Clone)]
pub struct DenseLu {
    n: usize,
    /// L below the diagonal (its own is 1), U on and above; by rows.
    factors: Vec<f64>,
    /// Row exchanged with row k in step k.
    exchange: Vec<usize>,
}

impl DenseLu {
    /// Factors a sparse matrix stored densely: n² values, n³/3 multiplications.
    ///
    /// # Errors
    /// Not square, a coefficient not finite, or singular.
    pub fn new(a: &Csr) -> Result<Self, Error> {
        a.pattern().require_square()?;
        a.require_finite()?;
        let n = a.rows();
        let mut factors = vec![0.0; n * n];
        for i in 0..n {
            let (columns, values) = a.row(i);
            for (&j, &value) in columns.iter().zip(values) {
                factors[i * n + j as usize] = value;
            }
        }
        let exchange = eliminate(&mut factors, n)?;
        Ok(Self { n, factors, exchange })
    }

    /// x ← A⁻¹ x.
    pub fn solve_in_place(&self, x: &mut [f64]) {
        assert_eq!(x.len(), self.n, "right-hand side");
        for (k, &other) in self.exchange.iter().enumerate() {
            x.swap(k, other);
        }
        let row = |i: usize| &self.factors[i * self.n..(i + 1) * self.n];
        let dot = |a: &[f64], x: &[f64]| a.iter().zip(x).map(|(a, x)| a * x).sum::<f64>();
        for i in 0..self.n {
            x[i] -= dot(&row(i)[..i], &x[..i]);
        }
        for i in (0..self.n).rev() {
            x[i] = (x[i] - dot(&row(i)[i + 1..], &x[i + 1..])) / row(i)[i];
        }
    }
}

/// Replaces the matrix by its factors; returns the row exchanges.
fn eliminate(a: &mut [f64], n: usize) -> Result<Vec<usize>, Error> {
    let scale = a.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
    let mut exchange = Vec::with_capacity(n);
    for k in 0..n {
        let pivot_row =
            (k..n).max_by(|&i, &j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs())).unwrap_or(k);
        exchange.push(pivot_row);
        for j in 0..n {
            a.swap(k * n + j, pivot_row * n + j);
        }
        let (above, below) = a.split_at_mut((k + 1) * n);
        let pivot_row = &above[k * n + k..];
        let pivot = pivot_row[0];
        if pivot.abs() <= f64::EPSILON * scale {
            return Err(Error::Singular { column: k, columns: n });
        }
        for row in below.chunks_exact_mut(n) {
            let row = &mut row[k..];
            let factor = row[0] / pivot;
            row[0] = factor;
            for (a, u) in row[1..].iter_mut().zip(&pivot_row[1..]) {
                *a -= factor * u;
            }
        }
    }
    Ok(exchange)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Pattern;
    use std::sync::Arc;

    fn dense(rows: &[&[f64]]) -> Csr {
        let n = rows.len() as u32;
        let pattern = Pattern::from_elements(rows.len(), [(0..n).collect::<Vec<_>>()]).unwrap();
        Csr::new(Arc::new(pattern), rows.concat()).unwrap()
    }

    #[test]
    fn a_nonsymmetric_matrix_with_a_zero_corner_is_solved_to_rounding() {
        let a = dense(&[&[0.0, 2.0, 1.0], &[1.0, 1.0, 0.0], &[4.0, -1.0, -3.0]]);
        let mut x = [0.0; 3];
        a.multiply(&[1.0, -2.0, 3.0], &mut x);
        DenseLu::new(&a).unwrap().solve_in_place(&mut x);
        for (x, exact) in x.iter().zip([1.0, -2.0, 3.0]) {
            assert!((x - exact).abs() < 1e-14);
        }
    }

    #[test]
    fn a_singular_matrix_is_refused_with_the_column_and_an_empty_one_is_solved() {
        let singular = dense(&[&[1.0, 2.0], &[2.0, 4.0]]);
        assert_eq!(DenseLu::new(&singular).unwrap_err(), Error::Singular { column: 1, columns: 2 });
        DenseLu::new(&dense(&[])).unwrap().solve_in_place(&mut []);
    }
}
