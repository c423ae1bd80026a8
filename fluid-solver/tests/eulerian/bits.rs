//! The same bits: restored, resumed, and for any number of threads.

use crate::support::{Random, box_mesh, flow};
use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use fluid_solver::backend::eulerian::{Eulerian, Properties};
use fluid_solver::backend::{FluidBackend, Response, Step};
use fluid_solver::boundary::{Condition, Inflow};
use interface::frames::{GrainRow, ReactionRow};

const LENGTH: f64 = 2e-3;

fn backend() -> Eulerian<3, 4> {
    let properties =
        Properties { density: 1000.0, viscosity: 1e-3, gravity: [0.0, 0.0, -9.81], tolerance: 1e-8 };
    let mesh = box_mesh::<3, 4>([0.0; 3], [0.1; 3], [14, 14, 17], [true, false, false], Some(0.2));
    let flow = flow(mesh, properties, |name| match name {
        "z-min" => {
            Condition::Inlet(Inflow::Speed { mean: 0.1, profile: case_io::document::Profile::Parabolic })
        }
        "z-max" => Condition::Outlet { pressure: 0.0 },
        _ => Condition::NoSlip,
    });
    Eulerian::new(flow, Response::TwoWay, 1.0)
}

fn grains(window: usize) -> Vec<GrainRow> {
    let mut random = Random(11);
    let mut grain = |id: u64| {
        let mut position: [f64; 3] = std::array::from_fn(|_| 0.01 + 0.08 * random.unit());
        position[0] += 1e-3 * window as f64;
        GrainRow { id, position, radius: 2e-3, mass: 1e-4, ..GrainRow::default() }
    };
    (0..400).map(&mut grain).collect()
}

/// A window of two iterations.
fn window(backend: &mut Eulerian<3, 4>, n: usize) {
    let step = Step { time: n as f64 * LENGTH, length: LENGTH };
    backend.save();
    for iteration in 0..2 {
        if iteration > 0 {
            backend.restore();
        }
        backend.project(step, &grains(n + 1)).unwrap();
        let row = ReactionRow {
            exchange_coefficient: 0.02,
            target_velocity: [0.0, 0.01, -0.02],
            ..ReactionRow::default()
        };
        backend.solve(step, &vec![row; 400]).unwrap();
        backend.prepare_samples();
    }
    backend.commit(step).unwrap();
}

fn bits(backend: &Eulerian<3, 4>) -> Vec<u64> {
    let state = backend.flow().state();
    let samples = (0..400).flat_map(|row| {
        let sample = backend.sample(row);
        [sample.velocity, sample.pressure_gradient, sample.acceleration, sample.vorticity]
            .into_iter()
            .flatten()
    });
    let fields = state.velocity.as_flattened().iter().chain(&state.pressure).chain(&state.acceleration[0]);
    fields.copied().chain(samples).map(f64::to_bits).collect()
}

fn run(windows: usize) -> Vec<u64> {
    let mut backend = backend();
    backend.populate(0.0, &grains(0)).unwrap();
    (0..windows).for_each(|n| window(&mut backend, n));
    bits(&backend)
}

#[test]
fn one_two_and_four_threads_give_the_same_bits() {
    let with = |threads: usize| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| run(3))
    };
    let one = with(1);
    assert!(one == with(2) && one == with(4));
}

#[test]
fn a_run_stopped_and_resumed_gives_the_same_bits_as_one_that_runs_through() {
    let folder = std::env::temp_dir().join(format!("silt-eulerian-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("fluid");
    let mut first = backend();
    first.populate(0.0, &grains(0)).unwrap();
    (0..2).for_each(|n| window(&mut first, n));
    first.save_checkpoint(CheckpointWriter::new("test", &())).write(&path).unwrap();
    let mut second = backend();
    second.load_checkpoint(&Checkpoint::read(&path, "test").unwrap()).unwrap();
    second.populate(2.0 * LENGTH, &grains(2)).unwrap();
    for n in 2..4 {
        window(&mut first, n);
        window(&mut second, n);
    }
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(bits(&first) == bits(&second));
}

#[test]
fn a_checkpoint_of_another_mesh_is_refused() {
    let folder = std::env::temp_dir().join(format!("silt-eulerian-mesh-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("fluid");
    backend().save_checkpoint(CheckpointWriter::new("test", &())).write(&path).unwrap();
    let properties = *backend().flow().properties();
    let mesh = box_mesh::<3, 4>([0.0; 3], [0.1; 3], [3, 3, 3], [false; 3], None);
    let mut other = Eulerian::new(flow(mesh, properties, |_| Condition::NoSlip), Response::TwoWay, 1.0);
    let refused = other.load_checkpoint(&Checkpoint::read(&path, "test").unwrap()).unwrap_err();
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(refused.to_string().contains("64 nodes"), "{refused}");
}

#[test]
fn restoring_a_window_brings_its_start_back_to_the_bit() {
    let mut backend = backend();
    backend.populate(0.0, &grains(0)).unwrap();
    window(&mut backend, 0);
    let before = backend.flow().state().clone();
    backend.save();
    let step = Step { time: LENGTH, length: LENGTH };
    backend.project(step, &grains(3)).unwrap();
    backend.solve(step, &[]).unwrap().solved().unwrap();
    assert!(*backend.flow().state() != before);
    backend.restore();
    assert!(*backend.flow().state() == before);
}
