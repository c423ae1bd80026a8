use crate::matrices::{dirichlet, neumann, relative_difference, rough};
use linear::{
    ConjugateGradient, Csr, Error, Identity, IncompleteCholesky, Jacobi, Preconditioner, SparseCholesky,
    Stopping, SymmetricGaussSeidel, Verdict,
};

fn iterations(a: &Csr, m: &mut impl Preconditioner) -> usize {
    let (b, mut x) = (rough(a.rows()), vec![0.0; a.rows()]);
    let outcome = ConjugateGradient::new(a.rows()).solve(a, m, &b, &mut x, Stopping::relative(1e-12, 5000));
    assert_eq!(outcome.verdict, Verdict::Converged);
    let mut exact = b;
    SparseCholesky::new(a).unwrap().solve_in_place(&mut exact);
    let error = relative_difference(&x, &exact);
    assert!(error < 1e-10, "error {error:e}");
    outcome.iterations
}

#[test]
fn conjugate_gradients_meet_the_direct_solution_and_a_better_preconditioner_needs_fewer_iterations() {
    for a in [dirichlet([64, 64]), dirichlet([16, 16, 16])] {
        let plain = iterations(&a, &mut Identity);
        let jacobi = iterations(&a, &mut Jacobi::new(&a).unwrap());
        let gauss_seidel = iterations(&a, &mut SymmetricGaussSeidel::new(&a).unwrap());
        let incomplete = iterations(&a, &mut IncompleteCholesky::new(&a).unwrap());
        assert!(jacobi <= plain + 1 && 3 * gauss_seidel < 2 * jacobi && incomplete < gauss_seidel);
    }
}

#[test]
fn on_a_tridiagonal_matrix_the_incomplete_factor_is_exact() {
    let a = dirichlet([500]);
    assert_eq!(iterations(&a, &mut IncompleteCholesky::new(&a).unwrap()), 1);
}

/// Kershaw's matrix: positive definite, yet without a plain IC(0) (*J. Comput. Phys.* 26 (1978) 43).
#[test]
fn a_shift_rescues_the_factor_where_a_pivot_is_negative() {
    let mut a = neumann([2, 2], |_, _| 1.0);
    let places = [
        (0, 0, 3.0),
        (1, 1, 3.0),
        (2, 2, 3.0),
        (3, 3, 3.0),
        (0, 1, -2.0),
        (1, 3, -2.0),
        (3, 2, -2.0),
        (2, 0, 2.0),
    ];
    for (i, j, value) in places {
        for (i, j) in [(i, j), (j, i)] {
            let slot = a.pattern().slot(i, j).unwrap();
            a.values_mut()[slot] = value;
        }
    }
    let mut m = IncompleteCholesky::new(&a).unwrap();
    assert!(m.shift() > 0.0);
    iterations(&a, &mut m);
}

#[test]
fn a_refreshed_factor_has_the_bits_of_a_new_one() {
    let a = dirichlet([20, 20]);
    let doubled = Csr::new(a.pattern().clone(), a.values().iter().map(|v| 3.0 * v).collect()).unwrap();
    let mut refreshed = IncompleteCholesky::new(&a).unwrap();
    refreshed.refresh(&doubled).unwrap();
    let (r, mut z, mut w) = (rough(400), vec![0.0; 400], vec![0.0; 400]);
    refreshed.apply(&r, &mut z);
    IncompleteCholesky::new(&doubled).unwrap().apply(&r, &mut w);
    assert_eq!(z, w);
}

#[test]
fn zero_rows_and_nans_are_reported_with_the_row() {
    let mut a = dirichlet([6, 6]);
    for slot in a.pattern().clone().slots(11) {
        a.values_mut()[slot] = 0.0;
    }
    assert_eq!(IncompleteCholesky::new(&a).unwrap_err(), Error::DiagonalNotPositive { row: 11, value: 0.0 });
    assert_eq!(
        SymmetricGaussSeidel::new(&a).unwrap_err(),
        Error::DiagonalNotPositive { row: 11, value: 0.0 }
    );
    assert_eq!(Jacobi::new(&a).unwrap_err(), Error::SingularDiagonal { row: 11 });
    a.add(20, 21, f64::NAN);
    assert!(matches!(Jacobi::new(&a), Err(Error::NonFinite { row: 20, column: 21, .. })));
    assert!(matches!(SymmetricGaussSeidel::new(&a), Err(Error::NonFinite { row: 20, column: 21, .. })));
    assert!(matches!(IncompleteCholesky::new(&a), Err(Error::NonFinite { row: 20, column: 21, .. })));
}
