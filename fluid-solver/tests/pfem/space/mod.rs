//! Remeshing in space.

mod bits;
mod robust;

use crate::support::{G, WATER, block, flow, gravity, largest_speed, momentum, tank, touch};
use fluid_solver::backend::Step;
use fluid_solver::backend::pfem::Renewal;
use fluid_solver::backend::pfem::cloud::{Cloud, OUTSIDE};
use fluid_solver::backend::pfem::flow::{Flow, FlowFault};
use fluid_solver::backend::pfem::remesh::{Books, Recognition, SpaceRemesher, TargetSize, energy};
use fluid_solver::backend::pfem::wall::{Grip, Wall};
use fluid_solver::element::simplex::volume_and_areas;

/// One step of flow and remeshing, shorter where it would turn a cell over; returns its length and how often it was halved.
/// Remeshing moves no momentum.
fn step(
    (flow, remesher): (&mut Flow<3, 4>, &mut SpaceRemesher),
    cloud: &mut Cloud<3, 4>,
    walls: &[Wall<3>],
    size: f64,
    mut step: Step,
    books: &mut Books<3>,
) -> (f64, usize) {
    for halved in 0..12 {
        match flow.solve(cloud, walls, step, &gravity()) {
            Ok(solution) => {
                solution.advance(cloud, step);
                let (end, before) = (step.time + step.length, momentum(cloud));
                remesher.remesh(cloud, walls, end, &TargetSize::Constant(size), books).unwrap();
                for (now, before) in momentum(cloud).into_iter().zip(before) {
                    let change = (now - before).abs() / books.volume.target;
                    assert!(change <= 1e-13, "{end} s: {change:e} m/s");
                }
                return (step.length, halved);
            }
            Err(FlowFault::Inverted { bound, .. }) => step.length = bound.min(0.5 * step.length),
            Err(fault) => panic!("{fault}"),
        }
    }
    panic!("no step is short enough at t = {} s", step.time)
}

#[test]
fn a_tank_in_space_stays_flat_for_a_thousand_steps_of_remeshing() {
    const DEPTH: f64 = 0.3;
    let walls = tank([DEPTH; 3], Grip::Slip);
    let mut cloud: Cloud<3, 4> = block([DEPTH; 3], [5, 4, 6], 0.0);
    touch(&mut cloud, &walls);
    cloud.pressure = cloud.place.iter().map(|x| WATER.density * G * (DEPTH - x[2])).collect();
    let (start, mut books) = (cloud.clone(), Books::start(&cloud));
    let mut flow = flow(WATER, 1e-6);
    let mut remesher = SpaceRemesher::default().under([0.0, 0.0, -G]);
    for n in 0..1000 {
        let at = Step { time: n as f64 * 1e-3, length: 1e-3 };
        assert_eq!(step((&mut flow, &mut remesher), &mut cloud, &walls, 0.06, at, &mut books), (1e-3, 0));
        assert!(largest_speed(&cloud) <= 1e-10);
    }
    for (x, start) in cloud.place.iter().zip(&start.place) {
        assert!((0..3).all(|k| (x[k] - start[k]).abs() <= 1e-10 * DEPTH));
    }
    assert!(books.volume.missing().abs() <= 1e-12 * books.volume.target);
}

#[test]
fn a_dam_that_breaks_in_space_and_hits_the_wall_keeps_its_volume_and_loses_energy() {
    const SIDE: f64 = 0.1;
    const CELLS: usize = 6;
    let walls = tank([2.5 * SIDE, 0.5 * SIDE, 3.0 * SIDE], Grip::Slip);
    let mut cloud: Cloud<3, 4> = block([SIDE, 0.5 * SIDE, SIDE], [CELLS, CELLS / 2, CELLS], 0.0);
    touch(&mut cloud, &walls);
    let mut books = Books::start(&cloud);
    let mechanical = |cloud: &Cloud<3, 4>| {
        let energy = energy(cloud);
        energy.kinetic + G * energy.moment[2]
    };
    let (volume, mut highest) = (books.volume.target, mechanical(&cloud));
    let start = highest;
    let mut flow = flow(WATER, 1e-6);
    let mut remesher = SpaceRemesher::default().under([0.0, 0.0, -G]);
    let (mut time, mut steps, mut halved, mut worst) = (0.0, 0, 0, 0.0f64);
    while time < 0.25 {
        let at = Step { time, length: 1e-3 };
        let size = SIDE / CELLS as f64;
        let (length, halves) = step((&mut flow, &mut remesher), &mut cloud, &walls, size, at, &mut books);
        (time, steps, halved) = (time + length, steps + 1, halved + halves);
        worst = worst.max(books.volume.missing().abs() / volume);
        highest = highest.max(mechanical(&cloud));
        assert!(cloud.cells.iter().all(|cell| volume_and_areas(&cloud.vertices(cell)).0 > 0.0));
    }
    let front = cloud.place.iter().map(|x| x[0]).fold(0.0, f64::max);
    println!(
        "dam break in space: volume {worst:.2e}, highest E/E0 − 1 {:.1e}, {halved} of {steps} halved",
        highest / start - 1.0
    );
    assert!((front - 2.5 * SIDE).abs() < 1e-9, "{front}");
    assert!(worst <= 2.5e-3, "{worst}");
    assert!(highest <= start * (1.0 + 1e-9) && mechanical(&cloud) < 0.99 * start, "{highest} {start}");
    assert!(halved * 10 <= steps, "{halved} of {steps}");
}

#[test]
fn a_block_that_is_stretched_and_sheared_keeps_its_volume() {
    let flows: [fn([f64; 3]) -> [f64; 3]; 2] =
        [|[x, y, z]| [0.5 * x, -0.25 * y, -0.25 * z], |[_, _, z]| [0.8 * z, 0.0, 0.0]];
    for (velocity, allowed) in flows.into_iter().zip([2.5e-4, 1e-13]) {
        let mut cloud: Cloud<3, 4> = block([1.0; 3], [8; 3], 0.0);
        let (mut books, mut remesher) = (Books::start(&cloud), SpaceRemesher::default());
        let mut worst = 0.0f64;
        for n in 0..100 {
            for x in &mut cloud.place {
                let v = velocity(*x);
                (0..3).for_each(|k| x[k] += 0.02 * v[k]);
            }
            let size = TargetSize::Constant(0.125);
            remesher.remesh(&mut cloud, &[], 0.02 * n as f64, &size, &mut books).unwrap();
            worst = worst.max(books.volume.missing().abs());
        }
        println!("a block that is stretched or sheared: volume {worst:.2e}");
        assert!(worst <= allowed, "{worst}");
    }
}

#[test]
fn bare_nodes_on_a_grid_become_the_box_they_fill() {
    let mut cloud: Cloud<3, 4> = block([1.0, 0.5, 0.75], [8, 4, 6], 0.0);
    cloud.cells.clear();
    cloud.neighbours.clear();
    let mut remesher = SpaceRemesher::new(Recognition::AlphaShape { alpha: 1.2 });
    let mut books = Books::start(&cloud);
    remesher.remesh(&mut cloud, &[], 0.0, &TargetSize::Constant(0.125), &mut books).unwrap();
    assert!((books.volume.cells - 0.375).abs() < 1e-12 && books.volume.drops == 0.0);
    let surface = cloud.neighbours.iter().flatten().filter(|next| **next == OUTSIDE).count();
    assert_eq!(surface, 4 * (8 * 4 + 8 * 6 + 4 * 6));
}
