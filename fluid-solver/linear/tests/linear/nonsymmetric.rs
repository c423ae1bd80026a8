use crate::matrices::{convection_diffusion, relative_difference, rough, velocity};
use linear::{
    BiCgStab, BlockIncompleteLu, BlockJacobi, DenseLu, FlexibleGmres, Identity, LinearOperator,
    Preconditioner, Stopping, Verdict, vector,
};

#[test]
fn both_methods_meet_the_direct_solution_of_convection_and_diffusion() {
    let a = convection_diffusion(24, 2.0);
    let b = rough(a.rows());
    let mut exact = b.clone();
    DenseLu::new(&a).unwrap().solve_in_place(&mut exact);
    let stopping = Stopping::relative(1e-12, 2000);
    let (mut x, mut y) = (vec![0.0; b.len()], vec![0.0; b.len()]);
    let gmres = FlexibleGmres::new(b.len(), 150).solve(&a, &mut Identity, &b, &mut x, stopping);
    let stab = BiCgStab::new(b.len()).solve(&a, &mut Identity, &b, &mut y, stopping);
    assert_eq!((gmres.verdict, stab.verdict), (Verdict::Converged, Verdict::Converged));
    assert!(relative_difference(&x, &exact) < 1e-10);
    assert!(relative_difference(&y, &exact) < 1e-10);
}

#[test]
fn an_incomplete_factor_needs_a_third_of_the_iterations_of_scaling_even_where_convection_dominates() {
    for (peclet, mass) in [(0.2, 0.3), (1.0, 0.3), (5.0, 3.0)] {
        compare(peclet, mass);
    }
}

fn compare(peclet: f64, mass: f64) {
    let a = velocity(64, peclet, mass);
    let b = rough(a.size());
    let count = |m: &mut dyn Preconditioner| {
        let mut x = vec![0.0; b.len()];
        let stopping = Stopping::relative(1e-8, 500);
        let outcome = FlexibleGmres::new(b.len(), 50).solve(&a, m, &b, &mut x, stopping);
        let mut r = vec![0.0; b.len()];
        a.apply(&x, &mut r);
        assert_eq!(outcome.verdict, Verdict::Converged);
        assert!(relative_difference(&r, &b) <= 1.01e-8);
        outcome.iterations
    };
    let jacobi = count(&mut BlockJacobi::new(&a).unwrap());
    let incomplete = count(&mut BlockIncompleteLu::new(&a).unwrap());
    assert!(3 * incomplete <= jacobi, "{incomplete} against {jacobi} at Peclet number {peclet}");
}

/// The residual of GMRES without restart falls in every iteration and is zero after n of them.
#[test]
fn full_gmres_ends_after_as_many_iterations_as_unknowns() {
    let a = convection_diffusion(5, 1.0);
    let b = rough(25);
    let mut last = vector::norm(&b);
    for limit in 1..=25 {
        let mut x = vec![0.0; 25];
        let stopping = Stopping::relative(1e-13, limit);
        let outcome = FlexibleGmres::new(25, 30).solve(&a, &mut Identity, &b, &mut x, stopping);
        let mut ax = vec![0.0; 25];
        a.multiply(&x, &mut ax);
        let true_norm = relative_difference(&ax, &b) * vector::norm(&b);
        assert!((outcome.residual_norm - true_norm).abs() < 1e-12);
        assert!(outcome.residual_norm <= last);
        last = outcome.residual_norm;
    }
    assert!(last < 1e-12 * vector::norm(&b));
}
