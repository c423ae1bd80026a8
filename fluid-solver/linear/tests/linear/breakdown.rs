//! What must end the iteration, and how.

use crate::matrices::{convection_diffusion, dirichlet, rough};
use linear::{
    BiCgStab, ConjugateGradient, Csr, Error, FlexibleGmres, Identity, LinearOperator, Outcome,
    Preconditioner, Stopping, Verdict,
};

/// Every method on the same problem, from the same start.
fn all(
    a: &dyn LinearOperator,
    m: &mut dyn Preconditioner,
    b: &[f64],
    start: f64,
    stopping: Stopping,
) -> [(Outcome, Vec<f64>); 3] {
    let mut x = [(); 3].map(|()| vec![start; b.len()]);
    let outcomes = [
        ConjugateGradient::new(0).solve(a, m, b, &mut x[0], stopping),
        BiCgStab::new(0).solve(a, m, b, &mut x[1], stopping),
        FlexibleGmres::new(0, 20).solve(a, m, b, &mut x[2], stopping),
    ];
    let mut pairs = outcomes.into_iter().zip(x);
    std::array::from_fn(|_| pairs.next().unwrap())
}

const STOPPING: Stopping = Stopping { relative: 1e-10, absolute: 0.0, iterations: 300 };

#[test]
fn a_zero_right_hand_side_gives_zero_at_once() {
    for (outcome, x) in all(&dirichlet([8, 8]), &mut Identity, &[0.0; 64], 3.0, STOPPING) {
        assert_eq!(outcome, Outcome { iterations: 0, residual_norm: 0.0, verdict: Verdict::Converged });
        assert_eq!(x, [0.0; 64]);
    }
}

#[test]
fn an_empty_system_is_solved() {
    for (outcome, _) in all(&dirichlet([0]), &mut Identity, &[], 0.0, STOPPING) {
        assert_eq!((outcome.iterations, outcome.verdict), (0, Verdict::Converged));
    }
}

#[test]
fn one_unknown_takes_one_iteration() {
    for (outcome, x) in all(&dirichlet([1]), &mut Identity, &[3.0], 7.0, STOPPING) {
        assert_eq!((outcome.iterations, outcome.verdict), (1, Verdict::Converged));
        assert_eq!(x, [1.5]);
    }
}

#[test]
fn a_start_at_the_solution_is_left_alone() {
    let a = dirichlet([8, 8]);
    let mut b = vec![0.0; 64];
    a.multiply(&[2.0; 64], &mut b);
    for (outcome, x) in all(&a, &mut Identity, &b, 2.0, STOPPING) {
        assert_eq!((outcome.iterations, outcome.verdict), (0, Verdict::Converged));
        assert_eq!(x, [2.0; 64]);
    }
}

#[test]
fn the_absolute_tolerance_counts_where_it_is_the_larger() {
    let stopping = Stopping { absolute: 1e-3, ..STOPPING };
    for (outcome, _) in all(&dirichlet([8, 8]), &mut Identity, &rough(64), 0.0, stopping) {
        assert_eq!(outcome.verdict, Verdict::Converged);
        assert!(outcome.residual_norm <= 1e-3 && outcome.residual_norm > 1e-8);
    }
}

#[test]
fn a_nan_anywhere_ends_the_solve_and_leaves_x_finite() {
    let clean = dirichlet([8, 8]);
    let mut dirty = clean.clone();
    dirty.add(5, 5, f64::NAN);
    let mut b = rough(64);
    struct Poison;
    impl Preconditioner for Poison {
        fn apply(&mut self, r: &[f64], z: &mut [f64]) {
            z.copy_from_slice(r);
            z[3] = f64::NAN;
        }
    }
    for (outcome, x) in all(&dirty, &mut Identity, &b, 0.0, STOPPING).into_iter().chain(all(
        &clean,
        &mut Poison,
        &b,
        0.0,
        STOPPING,
    )) {
        assert_eq!(outcome.verdict, Verdict::NonFinite);
        assert!(x.iter().all(|x| x.is_finite()));
    }
    b[9] = f64::INFINITY;
    for (outcome, x) in all(&clean, &mut Identity, &b, 0.0, STOPPING) {
        assert_eq!((outcome.iterations, outcome.verdict), (0, Verdict::NonFinite));
        assert_eq!(x, [0.0; 64]);
    }
    for (outcome, _) in all(&clean, &mut Identity, &rough(64), f64::NAN, STOPPING) {
        assert_eq!(outcome.verdict, Verdict::NonFinite);
    }
}

#[test]
fn the_iteration_limit_is_kept_and_the_error_says_so() {
    let stopping = Stopping { iterations: 3, ..STOPPING };
    for (outcome, _) in all(&dirichlet([20, 20]), &mut Identity, &rough(400), 0.0, stopping) {
        assert_eq!((outcome.iterations, outcome.verdict), (3, Verdict::IterationLimit));
        let error = outcome.accept().unwrap_err();
        assert!(matches!(error, Error::NotConverged { iterations: 3, .. }));
        assert!(error.to_string().contains("iteration limit"));
    }
}

#[test]
fn an_unreachable_tolerance_ends_before_the_limit() {
    let stopping = Stopping { relative: 1e-30, absolute: 0.0, iterations: 100_000 };
    for (outcome, _) in all(&dirichlet([12, 12]), &mut Identity, &rough(144), 0.0, stopping) {
        assert!(outcome.iterations < 100_000 && outcome.residual_norm < 1e-12);
    }
}

#[test]
fn conjugate_gradients_name_an_indefinite_matrix_and_an_indefinite_preconditioner() {
    let mut negative = dirichlet([6, 6]);
    negative.values_mut().iter_mut().for_each(|v| *v = -*v);
    let reason = |outcome: Outcome| match outcome.verdict {
        Verdict::Breakdown(reason) => reason,
        other => panic!("{other:?}"),
    };
    let mut x = vec![0.0; 36];
    let outcome = ConjugateGradient::new(36).solve(&negative, &mut Identity, &rough(36), &mut x, STOPPING);
    assert!(reason(outcome).contains("matrix"));
    let mut m = linear::Jacobi::new(&negative).unwrap();
    let outcome = ConjugateGradient::new(36).solve(&dirichlet([6, 6]), &mut m, &rough(36), &mut x, STOPPING);
    assert!(reason(outcome).contains("preconditioner"));
}

#[test]
fn a_matrix_of_zeros_is_a_breakdown_for_every_method() {
    let zero = Csr::zeros(dirichlet([4, 4]).pattern().clone());
    for (outcome, _) in all(&zero, &mut Identity, &rough(16), 0.0, STOPPING) {
        assert!(matches!(outcome.verdict, Verdict::Breakdown(_)), "{outcome:?}");
    }
}

/// A rotation by 90°: r̂·A p = 0 stops BiCGStab, GMRES needs both unknowns.
#[test]
fn gmres_solves_where_bicgstab_breaks_down() {
    let pattern = linear::Pattern::from_elements(2, [[0, 1]]).unwrap();
    let rotation = Csr::new(std::sync::Arc::new(pattern), vec![0.0, 1.0, -1.0, 0.0]).unwrap();
    let [_, (stab, _), (gmres, x)] = all(&rotation, &mut Identity, &[1.0, 2.0], 0.0, STOPPING);
    assert!(matches!(stab.verdict, Verdict::Breakdown(_)), "{stab:?}");
    assert_eq!((gmres.iterations, gmres.verdict), (2, Verdict::Converged));
    assert!((x[0] + 2.0).abs() < 1e-14 && (x[1] - 1.0).abs() < 1e-14);
}

#[test]
fn huge_and_tiny_systems_converge_like_ordinary_ones() {
    for scale in [1e-120, 1e120] {
        let mut a = convection_diffusion(10, 0.5);
        a.values_mut().iter_mut().for_each(|v| *v *= scale);
        let [_, (stab, _), (gmres, _)] = all(&a, &mut Identity, &rough(100), 0.0, STOPPING);
        assert_eq!(
            (stab.verdict, gmres.verdict),
            (Verdict::Converged, Verdict::Converged),
            "scale {scale:e}"
        );
    }
}
