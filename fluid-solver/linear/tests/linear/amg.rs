use crate::matrices::{dirichlet, neumann, relative_difference, relative_residual, rough, sheared_triangles};
use linear::{
    Amg, AmgOptions, ConjugateGradient, Csr, Error, NullSpace, Preconditioner, SparseCholesky, Stopping,
    Verdict, vector,
};

fn solve(a: &Csr, m: &mut Amg, b: &[f64], relative: f64) -> (usize, Vec<f64>) {
    let mut x = vec![0.0; a.rows()];
    let outcome = ConjugateGradient::new(a.rows()).solve(a, m, b, &mut x, Stopping::relative(relative, 200));
    assert_eq!(outcome.verdict, Verdict::Converged, "{outcome:?}");
    (outcome.iterations, x)
}

fn iterations(a: &Csr, options: AmgOptions) -> usize {
    let mut m = Amg::new(a, options).unwrap();
    solve(a, &mut m, &rough(a.rows()), 1e-8).0
}

#[test]
fn conjugate_gradients_with_multigrid_meet_the_direct_solution() {
    for a in [dirichlet([64, 64]), dirichlet([16, 16, 16])] {
        let b = rough(a.rows());
        let mut exact = b.clone();
        SparseCholesky::new(&a).unwrap().solve_in_place(&mut exact);
        let (_, x) = solve(&a, &mut Amg::new(&a, AmgOptions::default()).unwrap(), &b, 1e-12);
        assert!(relative_difference(&x, &exact) < 1e-10);
    }
}

#[test]
fn two_d_laplacian_iterations_do_not_grow_with_size() {
    let small = iterations(&dirichlet([32, 32]), AmgOptions::default());
    let large = iterations(&dirichlet([256, 256]), AmgOptions::default());
    assert!(2 * large < 3 * small, "{small} at 32², {large} at 256²");
}

#[test]
fn three_d_laplacian_iterations_hardly_grow_with_size() {
    let small = iterations(&dirichlet([12; 3]), AmgOptions::default());
    let large = iterations(&dirichlet([36; 3]), AmgOptions::default());
    assert!(2 * large < 3 * small, "{small} at 12³, {large} at 36³");
}

#[test]
fn obtuse_triangles_with_couplings_of_both_signs_are_solved() {
    let a = sheared_triangles(80, 1.5);
    assert!(
        (0..a.rows()).any(|i| a.row(i).0.iter().zip(a.row(i).1).any(|(&j, &v)| j as usize != i && v > 0.1))
    );
    let count = iterations(&a, AmgOptions::default());
    assert!(count < 60, "{count}");
}

#[test]
fn strength_of_coupling_tames_anisotropy() {
    let mut a = neumann([96, 96], |_, axis| if axis == 0 { 1.0 } else { 1e-3 });
    (0..a.rows()).for_each(|i| a.add(i, i, 1e-4));
    let blind = iterations(&a, AmgOptions::default());
    let seeing = iterations(&a, AmgOptions { strength: 0.08, ..AmgOptions::default() });
    assert!(2 * seeing < blind, "{seeing} with strength, {blind} without");
}

#[test]
fn a_pure_neumann_problem_converges_to_the_solution_without_mean() {
    let singular = AmgOptions { null_space: NullSpace::Constant, ..AmgOptions::default() };
    for a in [
        neumann([64, 64], |i, _| 1.0 + (i % 5) as f64),
        neumann([9, 9], |_, _| 1.0),
        neumann([16; 3], |_, _| 2.0),
    ] {
        let mut exact = rough(a.rows());
        vector::remove_mean(&mut exact);
        let mut b = vec![0.0; a.rows()];
        a.multiply(&exact, &mut b);
        let (count, x) = solve(&a, &mut Amg::new(&a, singular).unwrap(), &b, 1e-12);
        let error = relative_difference(&x, &exact);
        assert!(count < 40 && error < 1e-9, "{count} iterations, error {error:e}");
    }
}

#[test]
fn two_domains_that_do_not_touch_converge_each_to_its_own_level() {
    let mut a = neumann([40, 40], |i, _| if i / 40 == 19 { 0.0 } else { 1.0 });
    for i in 760..799 {
        for (row, column, value) in [(i, i, 1.0), (i + 1, i + 1, 1.0), (i, i + 1, -1.0), (i + 1, i, -1.0)] {
            a.add(row, column, value);
        }
    }
    let mut b = rough(1600);
    b.chunks_mut(800).for_each(vector::remove_mean);
    for coarse_size in [30, 2000] {
        let options = AmgOptions { null_space: NullSpace::Constant, coarse_size, ..AmgOptions::default() };
        let (count, x) = solve(&a, &mut Amg::new(&a, options).unwrap(), &b, 1e-8);
        assert!(count < 30 && relative_residual(&a, &b, &x) <= 1e-8, "{count}");
    }
}

#[test]
fn a_source_without_sink_is_reported_not_iterated_for_ever() {
    let a = neumann([40, 40], |_, _| 1.0);
    let singular = AmgOptions { null_space: NullSpace::Constant, ..AmgOptions::default() };
    let (b, mut x) = (vec![1.0; 1600], vec![0.0; 1600]);
    let stopping = Stopping::relative(1e-8, 200);
    let outcome =
        ConjugateGradient::new(1600).solve(&a, &mut Amg::new(&a, singular).unwrap(), &b, &mut x, stopping);
    assert_ne!(outcome.verdict, Verdict::Converged);
    assert!(x.iter().all(|x| x.is_finite()));
}

#[test]
fn a_refreshed_hierarchy_has_the_bits_of_a_new_one() {
    let build = |seed: usize| {
        let mut a = neumann([48, 48], |i, _| 1.0 + ((i * seed) % 11) as f64);
        (0..a.rows()).for_each(|i| a.add(i, i, 0.01));
        a
    };
    let (old, new) = (build(3), build(7));
    let r = rough(old.rows());
    for strength in [0.0, 0.25] {
        let options = AmgOptions { strength, ..AmgOptions::default() };
        let mut refreshed = Amg::new(&old, options).unwrap();
        let mut before = vec![0.0; r.len()];
        refreshed.apply(&r, &mut before);
        refreshed.refresh(&new).unwrap();
        let (mut z, mut w) = (vec![0.0; r.len()], vec![0.0; r.len()]);
        refreshed.apply(&r, &mut z);
        Amg::new(&new, options).unwrap().apply(&r, &mut w);
        assert_ne!(z, before);
        assert_eq!(z, w);
    }
}

#[test]
fn the_cycle_is_symmetric() {
    for (a, null_space) in
        [(dirichlet([40, 30]), NullSpace::Empty), (neumann([40, 30], |_, _| 1.0), NullSpace::Constant)]
    {
        let mut m =
            Amg::new(&a, AmgOptions { null_space, coarse_size: 20, ..AmgOptions::default() }).unwrap();
        let (r, s) = (rough(1200), rough(2400)[1200..].to_vec());
        let (mut mr, mut ms) = (vec![0.0; 1200], vec![0.0; 1200]);
        m.apply(&r, &mut mr);
        m.apply(&s, &mut ms);
        let (left, right) = (vector::dot(&s, &mr), vector::dot(&r, &ms));
        assert!((left - right).abs() < 1e-12 * vector::norm(&mr) * vector::norm(&s), "{left} {right}");
    }
}

#[test]
fn rows_that_only_hold_a_diagonal_stay_out_of_the_coarse_levels() {
    let mut a = dirichlet([50, 50]);
    for i in (0..2500).filter(|i| i % 3 == 0) {
        for j in a.pattern().clone().row(i).iter().map(|&j| j as usize) {
            for (row, column) in [(i, j), (j, i)] {
                let slot = a.pattern().slot(row, column).unwrap();
                a.values_mut()[slot] = f64::from(u8::from(i == j));
            }
        }
    }
    let b = rough(2500);
    let (_, x) = solve(&a, &mut Amg::new(&a, AmgOptions::default()).unwrap(), &b, 1e-10);
    assert!(relative_residual(&a, &b, &x) < 1e-10);
    let mut diagonal_only = dirichlet([900]);
    diagonal_only.values_mut().iter_mut().for_each(|v| *v = v.max(0.0));
    let b = rough(900);
    let (count, _) =
        solve(&diagonal_only, &mut Amg::new(&diagonal_only, AmgOptions::default()).unwrap(), &b, 1e-12);
    assert_eq!(count, 1);
}

#[test]
fn coefficients_that_jump_by_a_million_are_solved() {
    let mut a = neumann([80, 80], |i, _| if (i / 800 + i % 80 / 10) % 2 == 0 { 1.0 } else { 1e6 });
    a.add(0, 0, 1.0);
    let mut b = rough(6400);
    vector::remove_mean(&mut b);
    let mut m = Amg::new(&a, AmgOptions { strength: 0.08, ..AmgOptions::default() }).unwrap();
    let (count, x) = solve(&a, &mut m, &b, 1e-8);
    assert!(relative_residual(&a, &b, &x) <= 1e-8 && count < 60, "{count}");
}

#[test]
fn no_unknowns_and_one_unknown_are_solved() {
    Amg::new(&dirichlet([0]), AmgOptions::default()).unwrap().apply(&[], &mut []);
    for coarse_size in [0, 400] {
        let options = AmgOptions { coarse_size, ..AmgOptions::default() };
        let mut z = [0.0];
        Amg::new(&dirichlet([1]), options).unwrap().apply(&[3.0], &mut z);
        assert!((z[0] - 1.5).abs() < 1e-15);
    }
}

#[test]
fn zero_rows_and_nans_are_reported_with_the_row() {
    let mut a = dirichlet([30, 30]);
    let mut m = Amg::new(&a, AmgOptions::default()).unwrap();
    assert!(matches!(m.refresh(&dirichlet([30, 31])), Err(Error::PatternChanged { rows: 930, .. })));
    a.add(20, 21, f64::INFINITY);
    assert!(matches!(m.refresh(&a), Err(Error::NonFinite { row: 20, column: 21, .. })));
    assert!(matches!(Amg::new(&a, AmgOptions::default()), Err(Error::NonFinite { row: 20, column: 21, .. })));
    for slot in a.pattern().clone().slots(20) {
        a.values_mut()[slot] = 0.0;
    }
    let refused = Amg::new(&a, AmgOptions::default()).err();
    assert_eq!(refused, Some(Error::DiagonalNotPositive { row: 20, value: 0.0 }));
}
