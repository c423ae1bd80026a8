//! A window that turns out too long while it is computed is given up by all sides and offered anew, halved: what comes of it
//! is what the shorter window gives, and below the smallest window the run ends and says why.

#[path = "../support/mod.rs"]
mod support;

use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use case_io::document::{Case, Overrides};
use case_io::exit_code::ExitCode;
use case_io::output::series::Series;
use case_io::plan::Plan;
use case_io::summary::Counts;
use coupler::{Clock, CouplerError, Session, Simulation, Watcher};
use fluid_solver::backend::{self, Attempt, FluidBackend, PointValue, Step};
use fluid_solver::{FluidError, FluidParticipant};
use interface::assignment::Assignment;
use interface::frames::{GrainRow, ReactionRow, SampleRow};
use interface::message::{Surface, TooLarge};
use interface::participant::serve;
use interface::run::RunId;
use interface::transport::in_process;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::thread;
use support::Folder;

/// Grains thrown into a box of liquid at rest; the first falls from a feed while the run goes on.
const CASE: &str = r#"
[case]
title = "grains thrown into a box"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[time]
end = "40 ms"
window = "4 ms"
smallest-window = "0.3 ms"
[output]
frames = "none"
restart = "none"
series = "4 ms"
[materials.solid]
density = "2500 kg/m^3"
[grains]
normal-law = "none"
[[insertion]]
name = "cloud"
material = "solid"
diameter = "0.5 mm"
velocity = ["0.01 m/s", "0.003 m/s", "0 m/s"]
lattice = { lower = ["3 mm", "3 mm", "3 mm"], upper = ["7 mm", "7 mm", "7 mm"], spacing = "2 mm" }
[fluid]
backend = "eulerian"
density = "1000 kg/m^3"
viscosity = "0.1 Pa s"
solve.tolerance = 1e-12
[fluid.mesh.box]
lower = ["0 mm", "0 mm", "0 mm"]
upper = ["10 mm", "10 mm", "10 mm"]
cells = [4, 4, 4]
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min", "y-max", "z-min", "z-max"]
kind = "no-slip"
[coupling]
scheme = "serial-implicit"
drag = "di-felice"
acceleration = "none"
"#;

/// A fluid that refuses windows above a length in one of their iterations, when it has computed with it.
struct Fastidious {
    fluid: Box<dyn FluidBackend>,
    longest: f64,
    refuses_in: u32,
    iteration: u32,
}

impl FluidBackend for Fastidious {
    fn solve(&mut self, step: Step, reactions: &[ReactionRow]) -> Result<Attempt, FluidError> {
        self.iteration += 1;
        let attempt = self.fluid.solve(step, reactions)?;
        if step.length > self.longest && self.iteration == self.refuses_in {
            let reason = "cell 7 at (1, 2) turns over".to_string();
            return Ok(Attempt::TooLarge(TooLarge { bound: 0.9 * step.length, reason }));
        }
        Ok(attempt)
    }
    fn save(&mut self) {
        self.iteration = 0;
        self.fluid.save();
    }
    fn nodes(&self) -> u64 {
        self.fluid.nodes()
    }
    fn notes(&self) -> Vec<String> {
        self.fluid.notes()
    }
    fn surface(&self) -> Option<Surface> {
        self.fluid.surface()
    }
    fn largest_step(&self) -> f64 {
        f64::INFINITY
    }
    fn populate(&mut self, time: f64, grains: &[GrainRow]) -> Result<(), FluidError> {
        self.fluid.populate(time, grains)
    }
    fn restore(&mut self) {
        self.fluid.restore();
    }
    fn project(&mut self, step: Step, grains: &[GrainRow]) -> Result<(), FluidError> {
        self.fluid.project(step, grains)
    }
    fn prepare_samples(&mut self) {
        self.fluid.prepare_samples();
    }
    fn sample(&self, row: usize) -> SampleRow {
        self.fluid.sample(row)
    }
    fn commit(&mut self, step: Step) -> Result<(), FluidError> {
        self.fluid.commit(step)
    }
    fn at(&self, time: f64, point: [f64; 3]) -> Option<PointValue> {
        self.fluid.at(time, point)
    }
    fn statistics(&self, time: f64) -> Vec<(&'static str, f64)> {
        self.fluid.statistics(time)
    }
    fn write_frame(&self, stem: &Path, compress: bool) -> Result<Option<PathBuf>, FluidError> {
        self.fluid.write_frame(stem, compress)
    }
    fn save_checkpoint<'a>(&'a self, writer: CheckpointWriter<'a>) -> CheckpointWriter<'a> {
        self.fluid.save_checkpoint(writer)
    }
    fn load_checkpoint(&mut self, checkpoint: &Checkpoint) -> Result<(), FluidError> {
        self.fluid.load_checkpoint(checkpoint)
    }
}

struct Silent;

impl Watcher for Silent {
    fn window(&mut self, _: &Clock, _: &Counts) {}
}

/// Runs the case with a fluid that refuses windows above `longest` (s) in their iteration `refuses_in`.
fn go(
    out: &Path,
    case: &Path,
    window: &str,
    longest: f64,
    refuses_in: u32,
) -> (Counts, Option<CouplerError>) {
    for folder in ["series", "frames", "restart"] {
        std::fs::create_dir_all(out.join(folder)).unwrap();
    }
    let set = vec![format!("time.window=\"{window}\"")];
    let case = Case::load_run(case, &Overrides { set: set.clone(), variant: None }, None).unwrap();
    let (coupler, dem, fluid) = in_process::connect(RunId::new());
    let part = Assignment {
        run: String::new(),
        case: case.folder.clone(),
        set,
        variant: None,
        name: None,
        out: out.to_path_buf(),
        threads: 1,
        resume: None,
        peer_deadline: 10.0,
        hold: None,
    };
    let grains = thread::spawn(move || dem_solver::program::take_part(&part, dem));
    let (liquid_case, liquid_out) = (case.clone(), out.to_path_buf());
    let liquid = thread::spawn(move || {
        let case = liquid_case;
        let mut control = fluid.control;
        let inner = backend::of(&case, true).unwrap();
        let backend = Fastidious { fluid: inner, longest, refuses_in, iteration: 0 };
        let identity = (case.hash.clone(), Plan::of(&case.document).hash());
        let record = fluid_solver::Record::new(&liquid_out, Vec::new(), false, false);
        let frames = (fluid.grains, fluid.samples, fluid.reaction);
        let participant = FluidParticipant::new(Box::new(backend), frames, record, identity, true);
        serve(&mut control, None, |_| Ok(participant))
    });
    let session = Session { ends: coupler, dem: true, fluid: true, waited: 0.0 };
    let mut simulation = Simulation::start(&case, session, out, None).unwrap();
    let error = simulation.run(&AtomicBool::new(false), &mut Silent).err();
    let counts = simulation.counts;
    let mut session = simulation.into_session();
    for who in session.members() {
        session.stop(who, "done").unwrap();
    }
    grains.join().unwrap().unwrap();
    liquid.join().unwrap().unwrap();
    (counts, error)
}

fn column(out: &Path, name: &str) -> Vec<f64> {
    Series::read(&out.join("series/grains.csv")).unwrap().column(name).unwrap().values.to_vec()
}

#[test]
fn a_window_given_up_leaves_nothing_behind() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", CASE);
    let straight = folder.join("straight");
    let (counts, error) = go(&straight, &case, "2 ms", 1.0, 0);
    assert!(error.is_none(), "{error:?}");
    assert_eq!((counts.windows, counts.refused), (20, 0));
    for refuses_in in [1, 2] {
        let out = folder.join(&format!("refused-in-{refuses_in}"));
        let (counts, error) = go(&out, &case, "4 ms", 2.5e-3, refuses_in);
        assert!(error.is_none(), "{error:?}");
        assert_eq!(counts.windows, 20, "each of 4 ms is refused, each of 2 ms is not");
        assert_eq!(counts.refused, 10, "what is left of 4 ms after the first half is offered at once");
        for name in ["vz", "speed-max"] {
            for (a, b) in column(&out, name).iter().zip(&column(&straight, name)) {
                assert!((a - b).abs() <= 1e-10 * b.abs(), "iteration {refuses_in}, {name}: {a} {b}");
            }
        }
    }
}

#[test]
fn a_window_refused_however_short_it_is_ends_the_run_with_the_reason() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", CASE);
    let (counts, error) = go(&folder.join("out"), &case, "4 ms", 0.0, 1);
    let error = error.expect("it cannot go on");
    assert_eq!(error.exit_code(), ExitCode::TimeStepTooSmall);
    let text = error.to_string();
    assert!(
        text.starts_with(
            "time: a window of 2.500e-4 s is wanted by fluid-solver at t = 0 s, because cell 7 at (1, 2) turns over; \
             allowed: time.smallest-window = 3.000e-4 s; "
        ),
        "{text}"
    );
    assert_eq!((counts.windows, counts.refused), (0, 4));
}
