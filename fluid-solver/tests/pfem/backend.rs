//! The backend as the coupling sees it: from the case on.

use case_io::document::{Case, Overrides};
use fluid_solver::backend::{self, Attempt, FluidBackend, Step};
use interface::frames::{GrainRow, ReactionRow};

const DENSITY: f64 = 1000.0;
const GRAVITY: f64 = 9.81;

/// A tank, half a metre deep but for a stated `surface`, between walls that `held` lists.
fn tank(name: &str, surface: &str, held: &str) -> Box<dyn FluidBackend> {
    let text = format!(
        r#"[case]
title = "tank at rest"
dimension = 2
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[time]
end = "1 s"
window = "10 ms"
[fluid]
backend = "pfem"
density = "1000 kg/m^3"
viscosity = "1 mPa s"
solve.tolerance = 1e-12
[fluid.mesh]
box = {{ lower = ["0 m", "0 m"], upper = ["1 m", "0.5 m"], size = "0.1 m", jitter = 0.2{surface} }}
{held}
"#
    );
    let folder = std::env::temp_dir().join(format!("silt-pfem-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("case.toml"), text).unwrap();
    let case = Case::load_run(&folder, &Overrides::default(), None).unwrap();
    let backend = backend::of(&case, true).unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    backend
}

const PLANES: &str = r#"[[fluid.boundary]]
on = ["x-min", "x-max", "y-min"]
kind = "slip"
[[fluid.boundary]]
on = ["y-max"]
kind = "free-surface""#;

const LINE: &str = r#"[[fluid.boundary]]
on = ["basin"]
kind = "no-slip"
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min", "y-max"]
kind = "free-surface"
[[wall]]
name = "basin"
polyline.points = [["0 m", "1 m"], ["0 m", "0 m"], ["1 m", "0 m"], ["1 m", "1 m"]]"#;

fn value(backend: &dyn FluidBackend, name: &str) -> f64 {
    let statistics = backend.statistics(0.0);
    statistics.iter().find(|(found, _)| *found == name).unwrap_or_else(|| panic!("no {name}")).1
}

fn advance(backend: &mut dyn FluidBackend, steps: u32) {
    for n in 0..steps {
        let step = Step { time: f64::from(n) * 1e-2, length: 1e-2 };
        backend.save();
        let solution = backend.solve(step, &[]).unwrap().solved().expect("the step is not too large");
        let books = &solution.ledger;
        for k in 0..2 {
            let defect = books.rate[k] - books.body[k] - books.boundary[k];
            assert!(defect.abs() <= 1e-12 * books.scale, "step {n}: {defect:e} of {:e}", books.scale);
        }
        backend.commit(step).unwrap();
    }
}

#[test]
fn a_tank_at_rest_stays_flat_for_a_thousand_steps_and_probes_read_its_depth() {
    for (name, held) in [("planes", PLANES), ("line", LINE)] {
        let mut tank = tank(name, "", held);
        advance(&mut *tank, 1000);
        assert!((value(&*tank, "y-max[m]") - 0.5).abs() <= 1e-10 * 0.5, "{name}");
        assert!(value(&*tank, "volume-error[-]").abs() <= 1e-12, "{name}");
        assert!(value(&*tank, "speed-max[m/s]") <= 1e-10, "{name}: {:e}", value(&*tank, "speed-max[m/s]"));
        for x in [[0.37, 0.11, 0.0], [0.0, 0.2, 0.0], [1.04, 0.3, 0.0], [0.5, 0.5, 0.0]] {
            let found = tank.at(10.0, x).unwrap().pressure;
            let exact = DENSITY * GRAVITY * (0.5 - x[1]);
            assert!((found - exact).abs() <= 1e-9 * DENSITY * GRAVITY, "{name} {x:?}: {found} {exact}");
        }
        assert!((tank.elevation([0.3, 0.0, 0.0]).unwrap() - 0.5).abs() <= 1e-9);
    }
}

#[test]
fn an_iteration_given_up_leaves_no_trace() {
    let wave = ", surface = \"0.5 + 0.02*cos(pi*x)\"";
    let mut once = tank("once", wave, PLANES);
    let mut twice = tank("twice", wave, PLANES);
    advance(&mut *once, 20);
    for n in 0..20 {
        let step = Step { time: f64::from(n) * 1e-2, length: 1e-2 };
        twice.save();
        twice.solve(Step { length: 2e-2, ..step }, &[]).unwrap();
        twice.restore();
        twice.save();
        twice.solve(step, &[]).unwrap();
        twice.commit(step).unwrap();
    }
    assert!(value(&*once, "speed-max[m/s]") > 0.01, "the wave moves");
    assert_eq!(once.statistics(0.2), twice.statistics(0.2));
}

const BOX: &str = r#"[fluid.mesh]
box = { lower = ["0 m", "0 m"], upper = ["1 m", "0.5 m"], size = "0.1 m" }"#;

const PIPE: &str = r#"[[fluid.inlet]]
name = "pipe"
box = { lower = ["0 m", "0.1 m"], upper = ["0 m", "0.3 m"] }
normal = [1, 0]
velocity = { expression = ["0.2", "0"] }"#;

/// Two grains, one that sinks from above the surface, after `n` windows that went `stray` (m) astray.
fn grains(n: u32, stray: f64) -> [GrainRow; 2] {
    [[0.31, 0.52], [0.62, 0.3]].map(|[x, y]| GrainRow {
        id: (100.0 * x) as u64,
        position: [x + 1e-3 * f64::from(n), y - 4e-3 * f64::from(n) + stray, 0.0],
        velocity: [0.1, -0.4, 0.0],
        radius: 0.02,
        mass: 3.0,
        ..GrainRow::default()
    })
}

/// Drag towards the grains' own velocities.
fn reactions(grains: &[GrainRow], drag: f64) -> Vec<ReactionRow> {
    let reaction = |grain: &GrainRow| ReactionRow {
        exchange_coefficient: drag,
        target_velocity: grain.velocity,
        inverse_mass: 1.0 / grain.mass,
        ..ReactionRow::default()
    };
    grains.iter().map(reaction).collect()
}

#[test]
fn an_iteration_given_up_leaves_no_trace_of_its_grains_and_what_came_in() {
    let run = |name: &str, strays: bool| {
        let mut tank = crate::gates::scene::fluid(name, 2, &[BOX, PLANES, PIPE].join("\n"));
        tank.populate(0.0, &grains(0, 0.0)).unwrap();
        let mut samples = Vec::new();
        for n in 0..20 {
            let step = Step { time: f64::from(n) * 1e-2, length: 1e-2 };
            let mut attempt = |step: Step, stray: f64| {
                let rows = grains(n + 1, stray);
                tank.save();
                tank.project(step, &rows).unwrap();
                assert!(matches!(tank.solve(step, &reactions(&rows, 50.0 + stray)), Ok(Attempt::Solved(_))));
                tank.prepare_samples();
                let found = [0, 1].map(|row| tank.sample(row));
                if stray == 0.0 {
                    tank.commit(step).unwrap()
                } else {
                    tank.restore()
                }
                found
            };
            if strays {
                attempt(Step { length: 1.5e-2, ..step }, 3e-3);
            }
            samples.extend(attempt(step, 0.0));
        }
        (samples, tank.statistics(0.2))
    };
    let (once, twice) = (run("rollback-once", false), run("rollback-twice", true));
    let entered = once.1.iter().find(|(name, _)| *name == "volume-entered[m^3]").unwrap().1;
    assert!((entered / (0.2 * 0.2 * 0.2) - 1.0).abs() < 1e-9, "{entered}");
    assert_eq!(once, twice);
}
