//! Momentum of grains + fluid + walls closes to 1e-12 in every window, whatever the ratio of densities and however stiff
//! the drag: a run whose ledger is off by more ends with code 8.
#![allow(clippy::print_stdout, reason = "the velocities are figures of the documentation")]

#[path = "../support/mod.rs"]
mod support;

use case_io::output::series::Series;
use std::path::Path;
use support::{Folder, run, stderr};

/// 64 grains thrown through a closed box of fluid under gravity, one pass per window.
const CASE: &str = r#"
[case]
title = "grains thrown through a closed box"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[time]
end = "1 s"
window = "1 ms"
[output]
frames = "none"
restart = "none"
[materials.solid]
density = "1000 kg/m^3"
[grains]
normal-law = "none"
escape = "remove"
[[insertion]]
name = "cloud"
material = "solid"
diameter = "0.5 mm"
velocity = ["0.01 m/s", "0.003 m/s", "0 m/s"]
lattice = { lower = ["3 mm", "3 mm", "3 mm"], upper = ["7 mm", "7 mm", "7 mm"], spacing = "1 mm" }
[fluid]
backend = "eulerian"
density = "1000 kg/m^3"
viscosity = "0.1 Pa s"
[fluid.mesh.box]
lower = ["0 mm", "0 mm", "0 mm"]
upper = ["10 mm", "10 mm", "10 mm"]
cells = [6, 6, 6]
jitter = 0.2
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min", "y-max", "z-min", "z-max"]
kind = "no-slip"
[coupling]
scheme = "serial-explicit"
drag = "di-felice"
"#;

/// Twenty windows; the largest residual of momentum and the largest speed of a grain.
fn throw(folder: &Folder, name: &str, density: f64, window: f64, more: &[&str]) -> (f64, f64) {
    let case = folder.write("case/case.toml", CASE);
    let out = folder.join(name);
    let changes = [
        format!("materials.solid.density=\"{density} kg/m^3\""),
        format!("time.window=\"{window} s\""),
        format!("time.end=\"{} s\"", 20.0 * window),
        format!("output.series=\"{window} s\""),
    ];
    let changes: Vec<&str> = changes.iter().map(String::as_str).chain(more.iter().copied()).collect();
    let output = run(&case, &out, &changes, &[]);
    assert_eq!(output.status.code(), Some(0), "{name}: {}", stderr(&output));
    (largest(&out, "ledger", "momentum"), largest(&out, "grains", "speed-max"))
}

fn largest(out: &Path, series: &str, column: &str) -> f64 {
    let series = Series::read(&out.join(format!("series/{series}.csv"))).unwrap();
    series.column(column).unwrap().values.iter().fold(0.0, |a, b| a.max(b.abs()))
}

#[test]
fn momentum_closes_and_stays_bounded_for_density_ratios_from_a_hundredth_to_ten_thousand() {
    let folder = Folder::new();
    for ratio in [0.01, 0.1, 1.0, 100.0, 1e4] {
        // x = βΔt/m from about 1e-4 (heavy, short) to 1e4 (light, long).
        for window in [1e-5, 1e-3, 1.4e-2] {
            let (momentum, speed) = throw(&folder, &format!("{ratio}-{window}"), 1000.0 * ratio, window, &[]);
            assert!(momentum <= 1e-12, "ratio {ratio}, window {window}: {momentum:e}");
            // No faster than thrown, fallen or risen without drag, or at Stokes' terminal speed; a fifth for the start.
            let fallen = 9.81 * (1.0 / ratio - 1.0).abs() * 20.0 * window;
            let terminal = 9.81 * 1000.0 * (ratio - 1.0).abs() * 0.5e-3_f64.powi(2) / (18.0 * 0.1);
            let bound = 1.2 * (0.0105 + fallen.min(terminal));
            assert!(speed < bound, "ratio {ratio}, window {window}: {speed} m/s");
        }
    }
}

#[test]
fn momentum_closes_with_added_mass_and_iterations() {
    let folder = Folder::new();
    let more = ["coupling.added-mass=0.5", "coupling.scheme=\"serial-implicit\""];
    for ratio in [0.01, 2.5] {
        let (momentum, _) = throw(&folder, &format!("{ratio}"), 1000.0 * ratio, 1e-3, &more);
        assert!(momentum <= 1e-12, "ratio {ratio}: {momentum:e}");
    }
}

/// 216 grains on a lattice, φ = 0.05, thrown into fluid at rest in a periodic box.
const SUSPENSION: &str = r#"
[case]
title = "a suspension thrown into fluid at rest"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[time]
end = "1 s"
window = "1 ms"
[output]
frames = "none"
restart = "none"
[materials.solid]
density = "2500 kg/m^3"
[grains]
normal-law = "none"
domain = { lower = ["0 mm", "0 mm", "0 mm"], upper = ["6.56342904 mm", "6.56342904 mm", "6.56342904 mm"] }
periodic = ["x", "y", "z"]
[[insertion]]
name = "suspension"
material = "solid"
diameter = "0.5 mm"
velocity = ["0.1 m/s", "0 m/s", "0 m/s"]
lattice = { lower = ["0 mm", "0 mm", "0 mm"], upper = ["6.56342904 mm", "6.56342904 mm", "6.56342904 mm"], spacing = "1.09390484 mm" }
[fluid]
backend = "eulerian"
density = "1000 kg/m^3"
viscosity = "1 mPa s"
[fluid.mesh.box]
lower = ["0 mm", "0 mm", "0 mm"]
upper = ["6.56342904 mm", "6.56342904 mm", "6.56342904 mm"]
cells = [5, 5, 5]
periodic = ["x", "y", "z"]
[coupling]
scheme = "serial-explicit"
drag = "stokes"
self-disturbance = false
[[probe]]
name = "centre"
at = ["3 mm", "3 mm", "3 mm"]
"#;

/// The ledger closes on the momentum that the time rule conserves; this is the momentum itself. The first window takes
/// up to all of the slip.
#[test]
fn a_thrown_suspension_ends_at_the_velocity_of_the_mixture_however_long_the_window() {
    let folder = Folder::new();
    let case = folder.write("suspension/case.toml", SUSPENSION);
    let solids = std::f64::consts::PI / 6.0 * (0.5_f64 / 1.09390484).powi(3);
    let mixture = 0.1 * 2500.0 * solids / (2500.0 * solids + 1000.0 * (1.0 - solids));
    for window in [2e-3_f64, 2e-2, 2e-1] {
        let out = folder.join(&format!("suspension-{window}"));
        // Twenty windows, and at least half a second: fourteen relaxation times.
        let end = (20.0 * window).max(0.5);
        let changes = [
            format!("time.window=\"{window} s\""),
            format!("time.end=\"{end} s\""),
            format!("output.series=\"{end} s\""),
        ];
        let changes: Vec<&str> = changes.iter().map(String::as_str).collect();
        let output = run(&case, &out, &changes, &[]);
        assert_eq!(output.status.code(), Some(0), "{window}: {}", stderr(&output));
        let last = |series: &str, column: &str| {
            *Series::read(&out.join(format!("series/{series}.csv")))
                .unwrap()
                .column(column)
                .unwrap()
                .values
                .last()
                .unwrap()
        };
        let (grains, fluid) = (last("grains", "vx"), last("probes", "centre.ux"));
        println!("window {window} s: grains {grains}, fluid {fluid}, mixture {mixture} m/s");
        assert!(
            (grains - mixture).abs() < 1e-6 && (fluid - mixture).abs() < 1e-5,
            "{window}: {grains} {fluid} {mixture}"
        );
    }
}
