//! Beds that resist the flow more than its inertia does.
#![allow(clippy::print_stdout, reason = "the iterations are figures of the documentation")]

use crate::support::{Random, box_mesh, flow, given};
use fluid_solver::backend::eulerian::{Eulerian, Properties};
use fluid_solver::backend::{FluidBackend, Response, Step};
use fluid_solver::boundary::Condition;
use interface::frames::{GrainRow, ReactionRow};

const DENSITY: f64 = 1000.0;

/// Held grains on a disturbed lattice below `top` in a channel of 1 m that fluid is pushed up through.
fn bed<const D: usize>(per_axis: usize, top: f64) -> Vec<GrainRow> {
    let mut random = Random(11);
    let pitch = 1.0 / per_axis as f64;
    let mut grains = Vec::new();
    for index in 0..per_axis.pow(D as u32) {
        let position: [f64; 3] = std::array::from_fn(|k| {
            let along = index / per_axis.pow(k as u32) % per_axis;
            if k < D { (along as f64 + 0.4 + 0.2 * random.unit()) * pitch } else { 0.0 }
        });
        if position[D - 1] < top {
            let id = grains.len() as u64;
            let row =
                GrainRow { id, position, radius: 0.4 * pitch, mass: f64::INFINITY, ..Default::default() };
            grains.push(row);
        }
    }
    grains
}

/// Linear iterations of the first step through a bed with drag `ratio` times ρ/Δt per volume.
fn iterations<const D: usize, const N: usize>(cells: usize, per_axis: usize, top: f64, ratio: f64) -> u64 {
    let mesh = box_mesh::<D, N>([0.0; D], [1.0; D], [cells; D], [false; D], Some(0.2));
    let (below, above) = if D == 2 { ("y-min", "y-max") } else { ("z-min", "z-max") };
    let properties = Properties { density: DENSITY, viscosity: 1e-3, gravity: [0.0; D], tolerance: 1e-8 };
    let flow = flow(mesh, properties, |name| match name {
        name if name == below => given(|_, _| std::array::from_fn(|k| if k == D - 1 { 0.05 } else { 0.0 })),
        name if name == above => Condition::Outlet { pressure: 0.0 },
        _ => Condition::Slip,
    });
    let grains = bed::<D>(per_axis, top);
    let step = Step { time: 0.0, length: 2.0 / cells as f64 };
    let coefficient = ratio * DENSITY / step.length / (per_axis as f64).powi(D as i32);
    let row = ReactionRow { exchange_coefficient: coefficient, ..ReactionRow::default() };
    let mut backend = Eulerian::new(flow, Response::TwoWay, 1.0);
    backend.populate(0.0, &grains).unwrap();
    backend.save();
    backend.project(step, &grains).unwrap();
    backend.solve(step, &vec![row; grains.len()]).unwrap().solved().unwrap().iterations
}

#[test]
fn iterations_do_not_grow_with_the_resistance_of_a_bed() {
    for ratio in [1.0, 1e2, 1e4, 1e6] {
        let [plane, whole, fine] = [
            iterations::<2, 3>(16, 15, 2.0, ratio),
            iterations::<3, 4>(10, 9, 2.0, ratio),
            iterations::<3, 4>(8, 14, 2.0, ratio),
        ];
        println!("β Δt/ρ = {ratio:e}: {plane} in the plane, {whole} and {fine} in space");
        assert!(plane <= 30 && whole <= 30 && fine <= 30, "{ratio:e}: {plane} {whole} {fine}");
    }
}

/// Drag jumps by its whole size over the width of a kernel.
#[test]
fn the_surface_of_a_resistant_bed_is_no_obstacle() {
    for ratio in [1.0, 1e2, 1e4] {
        let [plane, space] = [iterations::<2, 3>(16, 15, 0.5, ratio), iterations::<3, 4>(10, 9, 0.5, ratio)];
        println!("β Δt/ρ = {ratio:e}: {plane} in the plane, {space} in space");
        assert!(plane <= 60 && space <= 80, "{ratio:e}: {plane} {space}");
    }
}
