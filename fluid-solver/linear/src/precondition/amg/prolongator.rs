//! Interpolation from the aggregates.

use super::aggregation::ALONE;
use crate::precondition::gauss_seidel::Diagonal;
use crate::vector::norm;
use crate::{Csr, Pattern};

/// Pattern of P: aggregates of an unknown and of its strong neighbours.
pub(super) fn pattern(a: &Pattern, strong: &[bool], aggregate: &[u32], count: usize) -> Pattern {
    let mut row_start = Vec::with_capacity(a.rows() + 1);
    let mut column = Vec::new();
    let mut row = Vec::new();
    row_start.push(0);
    for i in 0..a.rows() {
        row.clear();
        row.push(aggregate[i]);
        row.extend(
            a.row(i)
                .iter()
                .zip(&strong[a.slots(i)])
                .filter(|(_, s)| **s)
                .map(|(&j, _)| aggregate[j as usize]),
        );
        row.sort_unstable();
        row.dedup();
        column.extend(row.iter().filter(|&&g| g != ALONE));
        row_start.push(column.len() as u32);
    }
    Pattern::from_parts(row_start, column, count)
}

/// P = (I − ω D_F⁻¹ A_F) T with T the indicator of the aggregates, A_F the matrix with its weak couplings lumped into the
/// diagonal D_F, and ω = 4 / (3 ρ(D⁻¹ A)).
///
/// Rows of A_F sum to what those of A do, so constants that A maps to zero are interpolated exactly.
pub(super) fn fill(p: &mut Csr, a: &Csr, strong: &[bool], aggregate: &[u32], diagonal: &Diagonal) {
    let omega = 4.0 / (3.0 * spectral_radius(a, diagonal));
    let pattern = p.pattern().clone();
    for i in (0..a.rows()).filter(|&i| aggregate[i] != ALONE) {
        let (columns, values) = a.row(i);
        let couplings = || columns.iter().zip(values).zip(&strong[a.pattern().slots(i)]);
        let (mut own, mut weak) = (0.0, 0.0);
        for ((&j, a_ij), strong) in couplings() {
            if j as usize == i {
                own = *a_ij;
            } else if !strong {
                weak += a_ij;
            }
        }
        // Lumping may cancel the diagonal of a badly shaped cell; then the plain one is the safer scale.
        let lumped = if own + weak > 0.1 * own { own + weak } else { own };

        let row = &mut p.values_mut()[pattern.slots(i)];
        row.fill(0.0);
        let mut add = |g: u32, value: f64| {
            if let Ok(position) = pattern.row(i).binary_search(&g) {
                row[position] += value;
            }
        };
        add(aggregate[i], 1.0 - omega);
        for ((&j, a_ij), _) in couplings().filter(|(_, strong)| **strong) {
            add(aggregate[j as usize], -omega * a_ij / lumped);
        }
    }
}

/// ρ(D⁻¹ A) by a few power iterations, raised by 5 % because they stay below it.
fn spectral_radius(a: &Csr, diagonal: &Diagonal) -> f64 {
    // A start without structure: it must not be orthogonal to the rough modes that decide.
    let mut x: Vec<f64> =
        (0..a.rows() as u64).map(|i| (i * 2_654_435_761 % 1000) as f64 / 1000.0 - 0.4995).collect();
    let mut y = vec![0.0; a.rows()];
    let mut radius = 1.0;
    for _ in 0..8 {
        a.multiply(&x, &mut y);
        crate::vector::update(diagonal.inverse(), &mut y, |inverse, y| inverse * y);
        let length = norm(&y);
        radius = length / norm(&x);
        if !(radius > 0.0 && radius.is_finite()) {
            return 2.0;
        }
        crate::vector::scale(1.0 / length, &mut y);
        std::mem::swap(&mut x, &mut y);
    }
    1.05 * radius
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::precondition::amg::{aggregation, strength};
    use std::sync::Arc;

    #[test]
    fn constants_in_the_null_space_are_interpolated_exactly_with_and_without_weak_couplings() {
        let weight = |i: usize| if i.is_multiple_of(5) { 1e-3 } else { 1.0 + i as f64 };
        let edges = (1..40u32).map(|i| [i - 1, i]);
        let mut a = Csr::zeros(Arc::new(Pattern::from_elements(40, edges).unwrap()));
        for i in 1..40 {
            for (row, column, sign) in [(i, i, 1.0), (i - 1, i - 1, 1.0), (i, i - 1, -1.0), (i - 1, i, -1.0)]
            {
                a.add(row, column, sign * weight(i));
            }
        }
        for theta in [0.0, 0.1] {
            let diagonal = Diagonal::new(&a).unwrap();
            let strong = strength::strong_couplings(&a, &diagonal, theta);
            let (aggregate, count) = aggregation::aggregate(a.pattern(), &strong);
            let mut p = Csr::zeros(Arc::new(pattern(a.pattern(), &strong, &aggregate, count)));
            fill(&mut p, &a, &strong, &aggregate, &diagonal);
            let mut one = vec![0.0; 40];
            p.multiply(&vec![1.0; count], &mut one);
            assert!(one.iter().all(|one| (one - 1.0).abs() < 1e-14), "θ = {theta}: {one:?}");
        }
    }

    #[test]
    fn the_spectral_radius_of_a_scaled_chain_is_nearly_two() {
        let edges = (1..200u32).map(|i| [i - 1, i]);
        let mut a = Csr::zeros(Arc::new(Pattern::from_elements(200, edges).unwrap()));
        for i in 0..200usize {
            a.add(i, i, 2.0);
            if i > 0 {
                a.add(i, i - 1, -1.0);
                a.add(i - 1, i, -1.0);
            }
        }
        let radius = spectral_radius(&a, &Diagonal::new(&a).unwrap());
        assert!((1.8..2.1).contains(&radius), "{radius}");
    }
}
