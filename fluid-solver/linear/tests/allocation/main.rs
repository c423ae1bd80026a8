//! Claim: once set up, no product, preconditioner or solve allocates.

use linear::{
    Amg, AmgOptions, BiCgStab, BlockCsr, BlockIncompleteLu, BlockJacobi, ConjugateGradient, Csr, DenseLu,
    FlexibleGmres, IncompleteCholesky, Jacobi, LinearOperator, NullSpace, Pattern, Preconditioner,
    SparseCholesky, Stopping, SymmetricGaussSeidel,
};
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

struct Counting;

static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is passed on to the system allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocations(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.load(Ordering::Relaxed);
    work();
    ALLOCATIONS.load(Ordering::Relaxed) - before
}

/// A chain below the length at which threads share the work.
fn chain(n: usize) -> Csr {
    let edges = (1..n as u32).map(|i| [i - 1, i]);
    let mut a = Csr::zeros(Arc::new(Pattern::from_elements(n, edges).unwrap()));
    for i in 0..n {
        a.add(i, i, 2.0);
        if i > 0 {
            a.add(i, i - 1, -1.0);
            a.add(i - 1, i, -1.0);
        }
    }
    a
}

#[test]
fn nothing_is_allocated_after_the_set_up() {
    assert!(allocations(|| drop(std::hint::black_box(vec![0.0; 8]))) > 0, "the counter counts");
    let a = chain(3000);
    let mut blocks = BlockCsr::<2>::zeros(a.pattern().clone());
    for (block, &value) in blocks.blocks_mut().iter_mut().zip(a.values()) {
        *block = [[value, 0.1], [-0.1, value]];
    }
    let (b, mut x) = (vec![1.0; 3000], vec![0.0; 3000]);
    let (b2, mut x2) = (vec![1.0; 6000], vec![0.0; 6000]);
    let amg = |null_space| Amg::new(&a, AmgOptions { null_space, ..AmgOptions::default() }).unwrap();

    let mut scalar: Vec<Box<dyn Preconditioner + '_>> = vec![
        Box::new(Jacobi::new(&a).unwrap()),
        Box::new(SymmetricGaussSeidel::new(&a).unwrap()),
        Box::new(IncompleteCholesky::new(&a).unwrap()),
        Box::new(amg(NullSpace::Empty)),
        Box::new(amg(NullSpace::Constant)),
    ];
    for m in &mut scalar {
        assert_eq!(allocations(|| m.apply(&b, &mut x)), 0);
    }
    let mut block: [Box<dyn Preconditioner>; 2] =
        [Box::new(BlockJacobi::new(&blocks).unwrap()), Box::new(BlockIncompleteLu::new(&blocks).unwrap())];
    for m in &mut block {
        assert_eq!(allocations(|| m.apply(&b2, &mut x2)), 0);
    }
    assert_eq!(allocations(|| blocks.apply(&b2, &mut x2)), 0);
    let mut factor = SparseCholesky::new(&a).unwrap();
    assert_eq!(allocations(|| factor.solve_in_place(&mut x)), 0);
    assert_eq!(allocations(|| factor.refresh(&a).unwrap()), 0);
    let small = DenseLu::new(&chain(50)).unwrap();
    assert_eq!(allocations(|| small.solve_in_place(&mut x[..50])), 0);

    let few = Stopping::relative(1e-12, 15);
    let (mut cg, mut stab, mut gmres) =
        (ConjugateGradient::new(3000), BiCgStab::new(3000), FlexibleGmres::new(3000, 5));
    let mut m = Jacobi::new(&a).unwrap();
    let _ = gmres.solve(&a, &mut m, &b, &mut x, few); // the bases grow once
    for start in [0.0, 1.0] {
        x.fill(start);
        assert_eq!(allocations(|| drop(cg.solve(&a, &mut m, &b, &mut x, few).accept())), 0);
        assert_eq!(allocations(|| drop(stab.solve(&a, &mut m, &b, &mut x, few).accept())), 0);
        x.fill(start);
        assert_eq!(allocations(|| drop(gmres.solve(&a, &mut m, &b, &mut x, few).accept())), 0);
    }
}
