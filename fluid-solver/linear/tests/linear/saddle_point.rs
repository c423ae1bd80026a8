use crate::matrices::{neumann, rough, velocity};
use linear::{
    Amg, AmgOptions, BiCgStab, BlockCsr, BlockIncompleteLu, Csr, FlexibleGmres, LinearOperator,
    Preconditioner, Stopping, Verdict, dense, vector,
};

/// A + Wᵀ diag(β) W: viscosity, inertia and convection assembled, the drag of grains never.
struct Momentum {
    a: BlockCsr<2>,
    /// One grain at each node, felt by that node and two neighbours: (node, weight).
    grains: Vec<[(usize, f64); 3]>,
    beta: f64,
}

impl LinearOperator for Momentum {
    fn size(&self) -> usize {
        self.a.size()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        self.a.apply(x, y);
        let (v, force) = (dense::by_node::<2>(x), dense::by_node_mut::<2>(y));
        for nodes in &self.grains {
            for axis in 0..2 {
                let drag = self.beta * nodes.iter().map(|&(i, w)| w * v[i][axis]).sum::<f64>();
                nodes.iter().for_each(|&(i, w)| force[i][axis] += w * drag);
            }
        }
    }
}

/// [M G; D −C] with G a gradient, D = Gᵀ, and C a pressure Laplacian that stabilises equal order.
struct Flow {
    momentum: Momentum,
    gradient: BlockCsr<2, 1>,
    divergence: BlockCsr<1, 2>,
    c: Csr,
}

impl Flow {
    fn new(n: usize, beta: f64) -> Self {
        let a = velocity(n, 0.5, 0.05);
        let pattern = a.pattern().clone();
        let (mut gradient, mut divergence) =
            (BlockCsr::zeros(pattern.clone()), BlockCsr::zeros(pattern.clone()));
        for i in 0..n * n {
            for (axis, step) in [n, 1].into_iter().enumerate() {
                let g: [f64; 2] = std::array::from_fn(|k| if k == axis { 0.5 } else { 0.0 });
                if pattern.slot(i, i + step).is_some() {
                    for (row, column, sign) in [(i, i + step, 1.0), (i + step, i, -1.0)] {
                        gradient.add(row, column, &g.map(|g| [sign * g]));
                        divergence.add(column, row, &[g.map(|g| sign * g)]);
                    }
                }
            }
        }
        let nodes = n * n;
        let grains = (0..nodes).map(|p| [(p, 0.6), ((p + 1) % nodes, 0.2), ((p + n) % nodes, 0.2)]).collect();
        Self { momentum: Momentum { a, grains, beta }, gradient, divergence, c: neumann([n, n], |_, _| 0.05) }
    }
}

impl LinearOperator for Flow {
    fn size(&self) -> usize {
        self.momentum.size() + self.c.rows()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let (v, p) = x.split_at(self.momentum.size());
        let (momentum, mass) = y.split_at_mut(self.momentum.size());
        self.momentum.apply(v, momentum);
        self.gradient.multiply_add(dense::by_node(p), dense::by_node_mut(momentum));
        self.divergence.multiply(dense::by_node(v), dense::by_node_mut(mass));
        self.c.multiply_subtract(p, mass);
    }
}

/// Upper block triangle: p from the Schur complement, then v from the momentum rows with that p, by an inner iteration.
struct BlockTriangular<'a> {
    flow: &'a Flow,
    velocity: BlockIncompleteLu<2>,
    inner: BiCgStab,
    schur: Amg,
    right: Vec<f64>,
}

impl<'a> BlockTriangular<'a> {
    fn new(flow: &'a Flow) -> Self {
        let Momentum { a, grains, beta } = &flow.momentum;
        let mut lumped = a.clone();
        for (node, weight) in grains.iter().flatten() {
            let drag = weight * beta;
            lumped.add(*node, *node, &[[drag, 0.0], [0.0, drag]]);
        }
        // D M⁻¹ G is a scaled mass where viscosity rules, and fades with the drag.
        let mut schur = flow.c.clone();
        (0..schur.rows()).for_each(|i| schur.add(i, i, 0.6 / (1.0 + beta)));
        Self {
            flow,
            velocity: BlockIncompleteLu::new(&lumped).unwrap(),
            inner: BiCgStab::new(a.size()),
            schur: Amg::new(&schur, AmgOptions { coarse_size: 50, ..AmgOptions::default() }).unwrap(),
            right: vec![0.0; a.size()],
        }
    }
}

impl Preconditioner for BlockTriangular<'_> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let (v, p) = z.split_at_mut(self.right.len());
        let (momentum, mass) = r.split_at(self.right.len());
        self.schur.apply(mass, p);
        vector::scale(-1.0, p);
        self.right.copy_from_slice(momentum);
        self.flow.gradient.multiply_subtract(dense::by_node(p), dense::by_node_mut(&mut self.right));
        v.fill(0.0);
        let rough = Stopping::relative(0.05, 30);
        let _ = self.inner.solve(&self.flow.momentum, &mut self.velocity, &self.right, v, rough);
    }
}

fn iterations(n: usize, beta: f64) -> usize {
    let flow = Flow::new(n, beta);
    let b = rough(flow.size());
    let mut x = vec![0.0; b.len()];
    let mut m = BlockTriangular::new(&flow);
    let outcome =
        FlexibleGmres::new(b.len(), 40).solve(&flow, &mut m, &b, &mut x, Stopping::relative(1e-8, 400));
    assert_eq!(outcome.verdict, Verdict::Converged, "beta {beta}: {outcome:?}");
    let mut r = vec![0.0; b.len()];
    flow.apply(&x, &mut r);
    vector::xpby(&b, -1.0, &mut r);
    assert!(vector::norm(&r) <= 1e-8 * vector::norm(&b));
    outcome.iterations
}

#[test]
fn a_stokes_like_saddle_point_is_solved_with_a_block_preconditioner_of_the_user() {
    let count = iterations(24, 0.0);
    assert!(count < 50, "{count}");
}

#[test]
fn drag_that_is_never_assembled_costs_no_more_iterations_at_any_strength() {
    let without = iterations(24, 0.0);
    for beta in [1.0, 1e3, 1e6] {
        let with = iterations(24, beta);
        assert!(with <= 2 * without, "beta {beta}: {with} against {without}");
    }
}
