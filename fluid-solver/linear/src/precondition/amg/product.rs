//! Product of sparse matrices, its symbolic part apart from its numbers.

use crate::pattern::index;
use crate::{Csr, Error, Pattern};
use rayon::prelude::*;

/// Pattern of A B.
pub(super) fn pattern(a: &Pattern, b: &Pattern) -> Result<Pattern, Error> {
    let mut last_seen_in = vec![u32::MAX; b.columns()];
    let mut row_start = Vec::with_capacity(a.rows() + 1);
    let mut column = Vec::new();
    row_start.push(0);
    for i in 0..a.rows() {
        let first = column.len();
        for &k in a.row(i) {
            for &j in b.row(k as usize) {
                if last_seen_in[j as usize] != i as u32 {
                    last_seen_in[j as usize] = i as u32;
                    column.push(j);
                }
            }
        }
        column[first..].sort_unstable();
        row_start.push(index(column.len())?);
    }
    Ok(Pattern::from_parts(row_start, column, b.columns()))
}

/// C ← A B, C on the pattern of the product: c_ij = Σ_k a_ik b_kj.
pub(super) fn multiply(a: &Csr, b: &Csr, c: &mut Csr) {
    let pattern = c.pattern().clone();
    let position = || vec![0u32; b.columns()];
    c.values_by_chunk_of_rows().into_par_iter().for_each_init(position, |position, (rows, values)| {
        let chunk_start = pattern.slots(rows.start).start;
        for i in rows {
            let slots = pattern.slots(i);
            let row = &mut values[slots.start - chunk_start..slots.end - chunk_start];
            row.fill(0.0);
            for (k, &j) in pattern.row(i).iter().enumerate() {
                position[j as usize] = k as u32;
            }
            let (columns, values) = a.row(i);
            for (&k, a_ik) in columns.iter().zip(values) {
                let (columns, values) = b.row(k as usize);
                for (&j, b_kj) in columns.iter().zip(values) {
                    row[position[j as usize] as usize] += a_ik * b_kj;
                }
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;

    #[test]
    fn the_product_of_matrices_maps_like_one_after_the_other() {
        let a = Pattern::from_rows(3, [&[0u32, 2][..], &[], &[1], &[0, 1, 2]]).unwrap();
        let b = Pattern::from_rows(2, [&[1u32][..], &[0, 1], &[0]]).unwrap();
        let a = Csr::new(Arc::new(a), vec![2.0, -1.0, 3.0, 1.0, 5.0, 7.0]).unwrap();
        let b = Csr::new(Arc::new(b), vec![4.0, -2.0, 0.5, 6.0]).unwrap();
        let mut c = Csr::zeros(Arc::new(pattern(a.pattern(), b.pattern()).unwrap()));
        c.values_mut().fill(f64::NAN);
        multiply(&a, &b, &mut c);
        let (x, mut bx, mut abx, mut cx) = ([1.0, 10.0], [0.0; 3], [0.0; 4], [0.0; 4]);
        b.multiply(&x, &mut bx);
        a.multiply(&bx, &mut abx);
        c.multiply(&x, &mut cx);
        assert_eq!(cx, abx);
    }
}
