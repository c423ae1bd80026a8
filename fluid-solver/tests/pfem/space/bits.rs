//! The same bits in space: a dam that breaks against a wall, restarted and on any number of threads.

use crate::gates::scene::{advance, checkpoint, fluid, grains_beside};
use case_io::checkpoint::Checkpoint;
use fluid_solver::backend::{Attempt, FluidBackend, Step};
use interface::frames::{GrainRow, ReactionRow};
use std::ops::Range;

const DAM: &str = r#"[fluid.mesh.box]
lower = ["0 m", "0 m", "0 m"]
upper = ["0.1 m", "0.05 m", "0.15 m"]
size = "12.5 mm"
[[fluid.boundary]]
on = ["x-min", "y-min", "y-max", "z-min", "far"]
kind = "slip"
[[fluid.boundary]]
on = ["x-max", "z-max"]
kind = "free-surface"
[[wall]]
name = "far"
plane = { point = ["0.2 m", "0 m", "0 m"], normal = [-1, 0, 0] }"#;

fn dam(name: &str) -> Box<dyn FluidBackend> {
    fluid(&format!("bits-{name}"), 3, DAM)
}

/// Length of a window, a power of two so that times add up without rounding (s).
const WINDOW: f64 = 1.0 / 512.0;
/// When the run is stopped, and its end, after the blow on the far wall (s).
const TIMES: [f64; 2] = [75.0 * WINDOW, 150.0 * WINDOW];

/// To the end, in a pool of threads.
fn run(name: &str, threads: usize) -> Vec<u8> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let mut dam = dam(name);
        // A window that was halved would take it past the stop.
        advance(&mut *dam, WINDOW, [0.0, TIMES[0]]);
        advance(&mut *dam, WINDOW, TIMES);
        checkpoint(&*dam, name).1
    })
}

#[test]
fn a_dam_in_space_has_the_same_bits_on_one_two_and_four_threads_and_if_it_is_stopped_and_resumed() {
    let through = run("one", 1);
    assert!(through == run("two", 2), "two threads");
    assert!(through == run("four", 4), "four threads");
    let mut first = dam("first");
    advance(&mut *first, WINDOW, [0.0, TIMES[0]]);
    let mut second = dam("second");
    second.load_checkpoint(&checkpoint(&*first, "stop").0).unwrap();
    advance(&mut *second, WINDOW, TIMES);
    assert!(through == checkpoint(&*second, "resumed").1, "resumed");
}

/// Grains in the dam and above it after some windows; all go with the same speed.
fn grains(windows: u32) -> Vec<GrainRow> {
    let velocity = [0.6, 0.1, -0.3];
    let grain = |n: u32| {
        let start = [
            0.012 + 0.019 * f64::from(n % 5),
            0.011 + 0.013 * f64::from(n / 5 % 3),
            0.02 + 0.031 * f64::from(n / 15),
        ];
        let position = std::array::from_fn(|k| start[k] + velocity[k] * WINDOW * f64::from(windows));
        GrainRow { id: u64::from(n), position, velocity, radius: 3e-3, mass: 3e-4, ..GrainRow::default() }
    };
    (0..75).map(grain).collect()
}

/// Windows of two iterations each, in which the grains drag the fluid that they have sampled before.
fn go_on(dam: &mut dyn FluidBackend, windows: Range<u32>) {
    for n in windows {
        let (step, rows) = (Step { time: WINDOW * f64::from(n), length: WINDOW }, grains(n + 1));
        dam.save();
        for iteration in 0..2 {
            if iteration > 0 {
                dam.restore();
            }
            let reaction = |(row, grain): (usize, &GrainRow)| ReactionRow {
                exchange_coefficient: 0.05 * dam.sample(row).wetted_fraction,
                target_velocity: grain.velocity,
                relayed_volume: 0.5e-7 * dam.sample(row).wetted_fraction,
                inverse_mass: 1.0 / grain.mass,
                ..ReactionRow::default()
            };
            let reactions: Vec<ReactionRow> = rows.iter().enumerate().map(reaction).collect();
            dam.project(step, &rows).unwrap();
            assert!(matches!(dam.solve(step, &reactions), Ok(Attempt::Solved(_))), "window {n}");
            dam.prepare_samples();
        }
        dam.commit(step).unwrap();
    }
}

#[test]
fn a_dam_in_space_with_grains_has_the_same_bits_on_any_number_of_threads_and_if_it_is_stopped_and_resumed() {
    const WINDOWS: [u32; 2] = [6, 12];
    for nodes in ["kernel", "nodal"] {
        let tables = format!("pfem.grains = {nodes:?}\n{DAM}\nmaterial = \"glass\"{}", grains_beside(3));
        let begin = |name: &str, from: u32, stopped: Option<&Checkpoint>| {
            let mut dam = fluid(&format!("bits-{nodes}-{name}"), 3, &tables);
            stopped.into_iter().for_each(|stopped| dam.load_checkpoint(stopped).unwrap());
            dam.populate(WINDOW * f64::from(from), &grains(from)).unwrap();
            dam.prepare_samples();
            dam
        };
        let run = |name: &str, threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let mut dam = begin(name, 0, None);
                go_on(&mut *dam, 0..WINDOWS[1]);
                checkpoint(&*dam, &format!("{nodes}-{name}")).1
            })
        };
        let through = run("one", 1);
        assert!(through == run("two", 2) && through == run("four", 4), "{nodes}");
        let mut first = begin("first", 0, None);
        go_on(&mut *first, 0..WINDOWS[0]);
        let stopped = checkpoint(&*first, &format!("{nodes}-stop")).0;
        let mut second = begin("second", WINDOWS[0], Some(&stopped));
        go_on(&mut *second, WINDOWS[0]..WINDOWS[1]);
        assert!(through == checkpoint(&*second, &format!("{nodes}-resumed")).1, "{nodes} resumed");
    }
}
