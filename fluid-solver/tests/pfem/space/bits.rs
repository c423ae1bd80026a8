//! The same bits in space: a dam that breaks against a wall, restarted and on any number of threads.

use crate::gates::scene::{advance, fluid};
use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use fluid_solver::backend::FluidBackend;

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

/// All that the next step depends on, as it is written to disk.
fn bytes(fluid: &dyn FluidBackend, name: &str) -> (std::path::PathBuf, Vec<u8>) {
    let path = std::env::temp_dir().join(format!("silt-space-{name}-{}", std::process::id()));
    fluid.save_checkpoint(CheckpointWriter::new("test", &())).write(&path).unwrap();
    let bytes = std::fs::read(&path).unwrap();
    (path, bytes)
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
        let (path, bytes) = bytes(&*dam, name);
        std::fs::remove_file(path).unwrap();
        bytes
    })
}

#[test]
fn a_dam_in_space_has_the_same_bits_on_one_two_and_four_threads_and_if_it_is_stopped_and_resumed() {
    let through = run("one", 1);
    assert!(through == run("two", 2), "two threads");
    assert!(through == run("four", 4), "four threads");
    let mut first = dam("first");
    advance(&mut *first, WINDOW, [0.0, TIMES[0]]);
    let (path, _) = bytes(&*first, "stop");
    let mut second = dam("second");
    second.load_checkpoint(&Checkpoint::read(&path, "test").unwrap()).unwrap();
    std::fs::remove_file(path).unwrap();
    advance(&mut *second, WINDOW, TIMES);
    let (path, resumed) = bytes(&*second, "resumed");
    std::fs::remove_file(path).unwrap();
    assert!(through == resumed, "resumed");
}
