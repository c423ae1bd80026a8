//! The speed that a force on a node gives to that node, against what the kernel that it is taken for would.

use super::scene::{SIDE, Tank};
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

/// Mean and largest deviation, relative, over nodes and directions, of the width at which a kernel is as mobile as a node
/// from that which a node is taken for.
///
/// What walls do to the speed is that of both: s − s' = (1/σ − 1/σ')/(6π^{3/2}μ) in space, ln(σ'/σ)/(4πμ) per length in the plane.
fn width<const D: usize, const N: usize>(cells: usize) -> (f64, f64) {
    let depth = if D == 2 { super::scene::DEPTH } else { 1.0 };
    let inner = |x: &[f64; D]| x.iter().all(|x| (0.4..0.6).contains(&(x / SIDE)));
    let cloud = Tank::<D, N>::new(cells, Grip::NoSlip).cloud;
    let places: Vec<[f64; D]> = cloud.place.iter().filter(|x| inner(x)).copied().take(6).collect();
    let mut ratios = Vec::new();
    for at in &places {
        for axis in 0..D {
            let (node, taken) = mobility::<D, N>(cells, Spreading::Nodal, *at, axis);
            let (kernel, sigma) = mobility::<D, N>(cells, Spreading::Kernel, *at, axis);
            let found = match D {
                2 => sigma * (-4.0 * PI * VISCOSITY * depth * (node - kernel)).exp(),
                _ => 1.0 / (1.0 / sigma + 6.0 * PI.powf(1.5) * VISCOSITY * (node - kernel)),
            };
            eprintln!("{at:?} {axis}: {node} {kernel} sigma {sigma} taken {taken} found {found}");
            ratios.push(found / taken);
        }
    }
    let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
    (mean, ratios.iter().map(|ratio| (ratio - mean).abs()).fold(0.0, f64::max))
}

#[test]
fn a_node_is_as_mobile_as_the_kernel_that_it_is_taken_for() {
    for cells in [12, 16] {
        let (plane, spread) = width::<2, 3>(2 * cells);
        eprintln!("2D {cells}: {plane} {spread}");
        assert!((plane - 1.0).abs() < 0.1 && spread < 0.3, "{cells}: {plane} ± {spread}");
    }
    let (space, spread) = width::<3, 4>(10);
    eprintln!("3D: {space} {spread}");
    assert!((space - 1.0).abs() < 0.1 && spread < 0.3, "{space} ± {spread}");
}
