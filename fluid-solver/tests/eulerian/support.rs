//! Boxes of fluid, fields and norms.

use fluid_solver::backend::Step;
use fluid_solver::backend::eulerian::{Flow, Properties};
use fluid_solver::boundary::{Boundaries, Condition, VelocityField};
use fluid_solver::element::quadrature::degree_5;
use fluid_solver::grains::Exchange;
use fluid_solver::mesh::Mesh;
use fluid_solver::mesh::generate::{BoxMesh, Jitter};

/// A box from `lower` to `upper`.
pub fn box_mesh<const D: usize, const N: usize>(
    lower: [f64; D],
    upper: [f64; D],
    cells: [usize; D],
    periodic: [bool; D],
    jitter: Option<f64>,
) -> Mesh<D, N> {
    let jitter = jitter.map(|fraction| Jitter { fraction, seed: 7 });
    BoxMesh { lower, upper, cells, periodic, jitter }.generate().expect("a good box")
}

/// The flow in a mesh, with a condition for each boundary by name.
pub fn flow<const D: usize, const N: usize>(
    mesh: Mesh<D, N>,
    properties: Properties<D>,
    condition: impl Fn(&str) -> Condition<D>,
) -> Flow<D, N> {
    let named: Vec<_> = mesh.groups().iter().map(|name| (name.clone(), condition(name))).collect();
    let boundaries = Boundaries::new(&mesh, named).expect("every boundary named once");
    Flow::new(mesh, &boundaries, properties).expect("a good flow")
}

/// A velocity prescribed by place and time.
pub fn given<const D: usize>(
    velocity: impl Fn(&[f64; D], f64) -> [f64; D] + Send + Sync + 'static,
) -> Condition<D> {
    let field: VelocityField<D> = std::sync::Arc::new(velocity);
    Condition::MovingWall(field)
}

/// Advances by `steps` equal steps from `time`, without grains; linear iterations in all.
pub fn advance<const D: usize, const N: usize>(
    flow: &mut Flow<D, N>,
    time: f64,
    length: f64,
    steps: usize,
    mut before: impl FnMut(&mut Flow<D, N>, f64),
) -> u64 {
    let exchange = Exchange::default();
    let mut iterations = 0;
    for n in 0..steps {
        let step = Step { time: time + n as f64 * length, length };
        before(flow, step.end());
        iterations += flow.solve(step, &exchange, None).expect("the step converges");
        flow.commit(step);
    }
    iterations
}

/// ‖f_h − f‖ in L², by quadrature of degree 5.
pub fn l2_error<const D: usize, const N: usize, const K: usize>(
    mesh: &Mesh<D, N>,
    field: &[[f64; K]],
    exact: impl Fn(&[f64; D]) -> [f64; K],
) -> f64 {
    let rule = degree_5::<D, N>();
    let mut sum = 0.0;
    for cell in 0..mesh.cells().len() {
        let (vertices, nodes) = (mesh.vertices(cell), mesh.cell_nodes(cell));
        for (point, weight) in &rule {
            let x = std::array::from_fn(|k| (0..N).map(|i| point[i] * vertices[i][k]).sum());
            let exact = exact(&x);
            for k in 0..K {
                let value: f64 = (0..N).map(|i| point[i] * field[nodes[i] as usize][k]).sum();
                sum += mesh.volumes()[cell] * weight * (value - exact[k]).powi(2);
            }
        }
    }
    sum.sqrt()
}

/// ‖p_h − p‖ in L² less the mean of the difference.
pub fn pressure_error<const D: usize, const N: usize>(
    mesh: &Mesh<D, N>,
    pressure: &[f64],
    exact: impl Fn(&[f64; D]) -> f64,
) -> f64 {
    let total: f64 = mesh.measure().iter().sum();
    let difference = mesh.nodes().iter().zip(pressure).zip(mesh.measure());
    let mean = difference.map(|((x, p), measure)| measure * (p - exact(x))).sum::<f64>() / total;
    let field: Vec<[f64; 1]> = pressure.iter().map(|p| [p - mean]).collect();
    l2_error(mesh, &field, |x| [exact(x)])
}

/// Largest speed at a node.
pub fn largest_speed<const D: usize, const N: usize>(flow: &Flow<D, N>) -> f64 {
    let speed = |u: &[f64; D]| u.iter().map(|c| c * c).sum::<f64>().sqrt();
    flow.state().velocity.iter().map(speed).fold(0.0, f64::max)
}

/// SplitMix64.
pub struct Random(pub u64);

impl Random {
    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
