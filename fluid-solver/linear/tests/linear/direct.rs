use crate::matrices::{dirichlet, neumann, relative_residual, rough};
use linear::{Csr, Error, Pattern, SparseCholesky};
use std::sync::Arc;

#[test]
fn cholesky_solves_laplacians_in_2d_and_3d_to_rounding() {
    for a in [dirichlet([60, 50]), dirichlet([14, 13, 12])] {
        let b = rough(a.rows());
        let mut x = b.clone();
        SparseCholesky::new(&a).unwrap().solve_in_place(&mut x);
        assert!(relative_residual(&a, &b, &x) < 1e-13);
    }
}

#[test]
fn a_refreshed_factor_has_the_bits_of_a_new_one() {
    let (old, new) = (dirichlet([30, 30]), neumann([30, 30], |i, _| 1.0 + (i % 7) as f64));
    let new = {
        let mut shifted = new;
        (0..900).for_each(|i| shifted.add(i, i, 0.5));
        shifted
    };
    let mut refreshed = SparseCholesky::new(&old).unwrap();
    refreshed.refresh(&new).unwrap();
    let (mut x, mut y) = (rough(900), rough(900));
    refreshed.solve_in_place(&mut x);
    SparseCholesky::new(&new).unwrap().solve_in_place(&mut y);
    assert_eq!(x, y);
}

#[test]
fn one_unknown_and_none_are_solved() {
    let one = Csr::new(Arc::new(Pattern::from_rows(1, [[0]]).unwrap()), vec![4.0]).unwrap();
    let mut x = [2.0];
    SparseCholesky::new(&one).unwrap().solve_in_place(&mut x);
    assert_eq!(x, [0.5]);
    let none = Csr::zeros(Arc::new(Pattern::from_rows(0, [[0u32; 0]; 0]).unwrap()));
    SparseCholesky::new(&none).unwrap().solve_in_place(&mut []);
}

#[test]
fn an_indefinite_matrix_a_nan_and_another_pattern_are_refused() {
    let mut a = dirichlet([5, 5]);
    let mut factor = SparseCholesky::new(&a).unwrap();
    let other = factor.refresh(&dirichlet([5, 6]));
    assert!(matches!(other, Err(Error::PatternChanged { rows: 30, .. })));
    a.add(7, 7, -10.0);
    assert_eq!(factor.refresh(&a), Err(Error::NotPositiveDefinite { rows: 25 }));
    a.add(7, 7, f64::NAN);
    assert!(matches!(factor.refresh(&a), Err(Error::NonFinite { row: 7, column: 7, .. })));
}
