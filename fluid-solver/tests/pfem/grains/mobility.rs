//! The speed that a force on a node gives to that node, against what the kernel that it is taken for would.

use super::scene::{DEPTH, SIDE, Tank};
use crate::support::newtonian;
use fluid_solver::backend::pfem::flow::{Control, Flow, Fluid};
use fluid_solver::backend::pfem::wall::Grip;
use fluid_solver::grains::Spreading;
use interface::frames::{GrainRow, ReactionRow};
use std::f64::consts::PI;

const VISCOSITY: f64 = 1e3;
const SYRUP: Fluid = newtonian(1000.0, VISCOSITY);
/// Short enough for nothing to move, long enough for inertia to be gone from around the grain.
const LENGTH: f64 = 1e-2;
const FORCE: f64 = 1e-3;
/// The width that a node is taken for, in h.
const TAKEN: [f64; 2] = [0.2, 0.25];

/// u_s/F (s/kg) along an axis, σ (m) and h (m) at a place.
fn mobility<const D: usize, const N: usize>(
    cells: usize,
    spreading: Spreading,
    at: [f64; D],
    axis: usize,
) -> (f64, f64) {
    let mut tank = Tank::<D, N>::of(SYRUP, cells, Grip::NoSlip, spreading);
    tank.flow = Flow::new(SYRUP, Control { tolerance: 1e-10, implicitness: 1.0, ..Control::default() });
    let position = std::array::from_fn(|k| if k < D { at[k] } else { 0.0 });
    let grain = [GrainRow { position, radius: 1e-6 * SIDE, mass: 1e-12, ..GrainRow::default() }];
    tank.grains.populate(&tank.cloud, &grain).unwrap();
    let mut force = [0.0; 3];
    force[axis] = FORCE;
    tank.window(LENGTH, &grain, 1, |_| vec![ReactionRow { force, ..ReactionRow::default() }]);
    let sample = tank.grains.sample(0);
    (sample.velocity[axis] / FORCE, sample.kernel_width)
}

/// Mean and largest deviation over nodes and directions of the width, in h, at which a kernel is as mobile as a node.
///
/// What walls do to the speed is that of both: s − s' = (1/σ − 1/σ')/(6π^{3/2}μ) in space, ln(σ'/σ)/(4πμ) per length in the plane.
fn width<const D: usize, const N: usize>(cells: usize) -> (f64, f64) {
    let depth = if D == 2 { DEPTH } else { 1.0 };
    let inner = |x: &[f64; D]| x.iter().all(|x| (0.4..0.6).contains(&(x / SIDE)));
    let cloud = Tank::<D, N>::new(cells, Grip::NoSlip).cloud;
    let places: Vec<[f64; D]> = cloud.place.iter().filter(|x| inner(x)).copied().take(6).collect();
    let mut widths = Vec::new();
    for at in &places {
        for axis in 0..D {
            let (node, taken) = mobility::<D, N>(cells, Spreading::Nodal, *at, axis);
            let (kernel, sigma) = mobility::<D, N>(cells, Spreading::Kernel, *at, axis);
            let more = node - kernel;
            let found = match D {
                2 => sigma * (-4.0 * PI * VISCOSITY * depth * more).exp(),
                _ => 1.0 / (1.0 / sigma + 6.0 * PI.powf(1.5) * VISCOSITY * more),
            };
            widths.push(found / (taken / TAKEN[D - 2]));
        }
    }
    let mean = widths.iter().sum::<f64>() / widths.len() as f64;
    (mean, widths.iter().map(|width| (width - mean).abs()).fold(0.0, f64::max))
}

#[test]
fn in_creeping_flow_a_node_has_one_width_whatever_the_mesh_and_the_direction() {
    let (mean, spread) = width::<2, 3>(24);
    assert!((mean - 0.073).abs() < 0.004 && spread < 0.01, "{mean} ± {spread}");
    let (finer, spread) = width::<2, 3>(32);
    assert!((finer - 0.073).abs() < 0.004 && spread < 0.01, "{finer} ± {spread}");
    let (mean, spread) = width::<3, 4>(10);
    assert!((mean - 0.155).abs() < 0.005 && spread < 0.01, "{mean} ± {spread}");
}
