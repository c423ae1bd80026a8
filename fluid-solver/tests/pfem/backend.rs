//! The backend as the coupling sees it: from the case on.

use crate::gates::scene::{self, value};
use case_io::document::{Case, Overrides};
use fluid_solver::backend::{self, Attempt, FluidBackend, Step};
use interface::frames::{GrainRow, ReactionRow, SampleRow};

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

const PLANE_BOX: &str = r#"[fluid.mesh]
box = { lower = ["0 m", "0 m"], upper = ["1 m", "0.5 m"], size = "0.1 m" }
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min"]
kind = "slip"
[[fluid.boundary]]
on = ["y-max"]
kind = "free-surface"
[[fluid.inlet]]
name = "pipe"
box = { lower = ["0 m", "0.1 m"], upper = ["0 m", "0.3 m"] }
normal = [1, 0]
velocity = { expression = ["0.2", "0"] }"#;

const SPACE_BOX: &str = r#"[fluid.mesh]
box = { lower = ["0 m", "-0.16 m", "0 m"], upper = ["1 m", "0.24 m", "0.5 m"], size = "0.1 m" }
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min", "y-max", "z-min"]
kind = "slip"
[[fluid.boundary]]
on = ["z-max"]
kind = "free-surface"
[[fluid.inlet]]
name = "pipe"
box = { lower = ["0 m", "-0.06 m", "0.1 m"], upper = ["0 m", "0.14 m", "0.3 m"] }
normal = [1, 0, 0]
velocity = { expression = ["0.2", "0", "0"] }"#;

/// Two grains, one that sinks from above the surface, after `n` windows that went `stray` (m) astray.
fn grains(dimension: usize, n: u32, stray: f64) -> [GrainRow; 2] {
    let upright = |[along, up]: [f64; 2]| if dimension == 2 { [along, up, 0.0] } else { [along, 0.0, up] };
    [[0.31, 0.52], [0.62, 0.3]].map(|[x, y]| GrainRow {
        id: (100.0 * x) as u64,
        position: upright([x + 1e-3 * f64::from(n), y - 4e-3 * f64::from(n) + stray]),
        velocity: upright([0.1, -0.4]),
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

/// Twenty windows of grains in a box that is filled, on nodes by some way; in some runs each window is tried with another
/// length and other grains before. What the grains sampled, what came in, and the state at the end.
fn with_grains(dimension: usize, nodes: &str, strays: bool) -> (Vec<SampleRow>, f64, Vec<u8>) {
    let name = format!("rollback-{dimension}-{nodes}-{strays}");
    let vessel = if dimension == 2 { PLANE_BOX } else { SPACE_BOX };
    let tables = format!("pfem.grains = {nodes:?}\n{vessel}{}", scene::grains_beside(dimension));
    let mut tank = scene::fluid(&name, dimension, &tables);
    tank.populate(0.0, &grains(dimension, 0, 0.0)).unwrap();
    let mut samples = Vec::new();
    for n in 0..20 {
        let step = Step { time: f64::from(n) * 1e-2, length: 1e-2 };
        let mut attempt = |step: Step, stray: f64| {
            let rows = grains(dimension, n + 1, stray);
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
    (samples, value(&*tank, "volume-entered[m^3]"), scene::checkpoint(&*tank, &name).1)
}

#[test]
fn an_iteration_given_up_leaves_no_trace_of_its_grains_and_what_came_in() {
    for (dimension, nodes) in [(2, "kernel"), (2, "nodal"), (3, "kernel"), (3, "nodal")] {
        let [once, twice] = [false, true].map(|strays| with_grains(dimension, nodes, strays));
        let exact = 0.2f64.powi(dimension as i32 + 1);
        assert!((once.1 / exact - 1.0).abs() < 1e-9, "{}", once.1);
        assert!(once == twice, "{dimension}D, {nodes}");
    }
}

/// Why a fluid is refused.
fn refusal(name: &str, dimension: usize, tables: &str, files: &[(&str, &str)]) -> Option<String> {
    scene::stated(name, dimension, ["1000 kg/m^3", "1 mPa s"], tables, files)
        .err()
        .map(|error| error.to_string())
}

#[test]
fn a_wall_in_space_that_ends_above_the_floor_is_refused_with_where_it_does() {
    let tables = r#"[fluid.mesh]
box = { lower = ["0 m", "0 m", "0 m"], upper = ["0.1 m", "0.1 m", "0.1 m"], size = "20 mm" }
[[fluid.boundary]]
on = ["x-min", "y-min", "y-max", "z-min", "weir"]
kind = "slip"
[[fluid.boundary]]
on = ["x-max", "z-max"]
kind = "free-surface"
[[wall]]
name = "weir"
obj = { path = "weir.obj", rims = 1 }"#;
    // A sheet across the tank on a foot of three corners, or two.
    let three = |foot: f64| {
        let corners = [[0.0, 0.0], [0.05, foot], [0.1, 0.0], [0.1, 1.0], [0.0, 1.0]];
        (corners.to_vec(), "f 1 5 2\nf 2 5 4\nf 2 4 3\n")
    };
    let two = |foot: f64| (vec![[0.0, foot], [0.1, foot], [0.1, 1.0], [0.0, 1.0]], "f 1 4 2\nf 2 4 3\n");
    let weir = |(corners, facets): (Vec<[f64; 2]>, &str)| {
        let vertices: String = corners.iter().map(|[y, z]| format!("v 0.2 {y} {z}\n")).collect();
        refusal("weir", 3, tables, &[("weir.obj", &format!("{vertices}{facets}"))])
    };
    assert_eq!([weir(three(0.0)), weir(two(0.0))], [None, None]);
    for refused in [weir(three(0.002)), weir(two(0.002))] {
        let found = refused.unwrap();
        let told =
            r#"a gap of 2.000e-3 m between an end of the wall "weir", at [0.2, 0.05, 0.002] m, and "z-min""#;
        assert!(found.contains(told) && found.contains("close it or widen it"), "{found}");
    }
}

#[test]
fn nodes_as_far_apart_as_an_alpha_shape_has_no_cells_are_refused() {
    // The longest edge of a box's cells is √D of its spacing; that of a regular cell of radius α h is α√(2(D + 1)/D) h.
    for dimension in [2usize, 3] {
        let [lower, upper] = ["0 m", "1 m"].map(|length| vec![length; dimension]);
        let sides: Vec<String> = ["x", "y", "z"][..dimension]
            .iter()
            .flat_map(|axis| [format!("{axis}-min"), format!("{axis}-max")])
            .collect();
        let edge = 0.1 * (dimension as f64).sqrt();
        let largest = 1.25 * (2.0 * (dimension as f64 + 1.0) / dimension as f64).sqrt();
        let refused = |recognition: &str, apart: f64| {
            let tables = format!(
                "pfem = {{ recognition = {recognition:?}, size = \"{} m\" }}\n[fluid.mesh]\nbox = {{ lower = {lower:?}, upper = {upper:?}, size = \"0.1 m\" }}\n[[fluid.boundary]]\non = {sides:?}\nkind = \"free-surface\"",
                edge / apart
            );
            refusal(&format!("sparse-{dimension}"), dimension, &tables, &[])
        };
        assert_eq!(refused("alpha-shape", 0.999 * largest), None);
        let found = refused("alpha-shape", 1.001 * largest).unwrap();
        let least = format!("allowed: {:.3e} m or more", edge / largest);
        assert!(found.contains("fluid.pfem.size") && found.contains(&least), "{found}");
        assert_eq!(refused("moved-domain", 1.001 * largest), None);
        assert!(refused("moved-domain", 2.501).is_some());
    }
}
