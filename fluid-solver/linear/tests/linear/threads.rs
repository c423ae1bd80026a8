use crate::matrices::{dirichlet, rough, velocity};
use linear::{
    Amg, AmgOptions, BiCgStab, BlockIncompleteLu, ConjugateGradient, FlexibleGmres, LinearOperator, Stopping,
    Verdict,
};

/// Bits of the result in pools of 1, 2 and 4 threads.
fn bits_agree(result: impl Fn() -> Vec<f64> + Sync) {
    let bits = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| result().into_iter().map(f64::to_bits).collect::<Vec<_>>())
    };
    let one = bits(1);
    assert!(one == bits(2) && one == bits(4));
}

const FEW: Stopping = Stopping { relative: 1e-8, absolute: 0.0, iterations: 100 };

#[test]
fn multigrid_with_conjugate_gradients_gives_the_same_bits_for_1_2_and_4_threads() {
    let a = dirichlet([250, 250]);
    let b = rough(a.rows());
    bits_agree(|| {
        let mut x = vec![0.0; a.rows()];
        let mut m = Amg::new(&a, AmgOptions::default()).unwrap();
        let outcome = ConjugateGradient::new(a.rows()).solve(&a, &mut m, &b, &mut x, FEW);
        assert_eq!(outcome.verdict, Verdict::Converged);
        x
    });
}

#[test]
fn nonsymmetric_methods_give_the_same_bits_for_1_2_and_4_threads() {
    let a = velocity(150, 1.0, 0.5);
    let b = rough(a.size());
    bits_agree(|| {
        let (mut x, mut y) = (vec![0.0; b.len()], vec![0.0; b.len()]);
        let mut m = BlockIncompleteLu::new(&a).unwrap();
        let gmres = FlexibleGmres::new(b.len(), 20).solve(&a, &mut m, &b, &mut x, FEW);
        let stab = BiCgStab::new(b.len()).solve(&a, &mut m, &b, &mut y, FEW);
        assert_eq!((gmres.verdict, stab.verdict), (Verdict::Converged, Verdict::Converged));
        x.extend(y);
        x
    });
}
