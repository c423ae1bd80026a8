//! Which couplings the aggregates follow.

use crate::Csr;
use crate::precondition::gauss_seidel::Diagonal;

/// For each slot: j ≠ i and a_ij² > θ² a_ii a_jj.
pub(super) fn strong_couplings(a: &Csr, diagonal: &Diagonal, strength: f64) -> Vec<bool> {
    let inverse = diagonal.inverse();
    let mut strong = Vec::with_capacity(a.pattern().entries());
    for i in 0..a.rows() {
        let (columns, values) = a.row(i);
        strong.extend(columns.iter().zip(values).map(|(&j, a_ij)| {
            let j = j as usize;
            j != i && (a_ij * inverse[i]) * (a_ij * inverse[j]) > strength * strength
        }));
    }
    strong
}
