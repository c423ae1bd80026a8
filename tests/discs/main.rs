//! Discs in two dimensions, coupled both ways by the drag law of cylinders.

#[path = "../support/mod.rs"]
mod support;

use case_io::output::series::Series;
use coupler::interaction::drag::{Drag, Slip};
use std::f64::consts::PI;
use support::{Folder, run, stderr};

/// A lattice of discs falls from rest through a periodic box; a body force on the fluid carries the weight of all.
const CASE: &str = r#"
[case]
title = "discs falling through their own fluid"
dimension = 2
depth = "10 mm"
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[time]
end = "100 ms"
window = "0.2 ms"
[output]
series = "5 ms"
frames = "none"
restart = "none"
[materials.solid]
density = "2500 kg/m^3"
[grains]
normal-law = "none"
domain = { lower = ["0 mm", "0 mm"], upper = ["16 mm", "16 mm"] }
periodic = ["x", "y"]
[[insertion]]
name = "discs"
material = "solid"
diameter = "1 mm"
lattice = { lower = ["0 mm", "0 mm"], upper = ["16 mm", "16 mm"], spacing = "2 mm" }
[fluid]
backend = "eulerian"
density = "1000 kg/m^3"
viscosity = "10 mPa s"
[fluid.mesh.box]
lower = ["0 mm", "0 mm"]
upper = ["16 mm", "16 mm"]
cells = [8, 8]
periodic = ["x", "y"]
[coupling]
scheme = "serial-implicit"
drag = "di-felice-cylinder"
self-disturbance = false
[[probe]]
name = "centre"
at = ["8 mm", "8 mm"]
"#;

const GRAVITY: f64 = 9.81;
const DEPTH: f64 = 10e-3;
const DIAMETER: f64 = 1e-3;
const DENSITY: f64 = 1000.0;
/// One disc to four square millimetres.
const VOID_FRACTION: f64 = 1.0 - PI / 16.0;

/// Slip v − u \[m/s\] of m dv/dt = −mg − βw, M du/dt = mg + βw, from rest, in steps of 1 µs (midpoint rule).
fn slip_at(time: f64, mass: f64, fluid_mass: f64) -> f64 {
    let rate = |w: f64| {
        let slip = Slip {
            speed: w.abs(),
            diameter: DIAMETER,
            volume: PI / 4.0 * DIAMETER.powi(2) * DEPTH,
            void_fraction: VOID_FRACTION,
            density: DENSITY,
            viscosity: 10e-3,
        };
        let beta = Drag::DiFeliceCylinder.exchange_coefficient(&slip);
        -(mass * GRAVITY + beta * w) * (1.0 / mass + 1.0 / fluid_mass)
    };
    let step = 1e-6;
    (0..(time / step).round() as u64).fold(0.0, |w, _| w + step * rate(w + 0.5 * step * rate(w)))
}

/// A run whose momentum does not close to 1e-12 ends with code 8.
#[test]
fn discs_fall_through_their_own_fluid_as_the_law_of_cylinders_says() {
    let mass = 2500.0 * PI / 4.0 * DIAMETER.powi(2) * DEPTH;
    let fluid_mass = DENSITY * VOID_FRACTION * 4e-6 * DEPTH;
    let folder = Folder::new();
    let case = folder.write("case/case.toml", CASE);
    let out = folder.join("out");
    let lift = GRAVITY * (1.0 + mass / fluid_mass);
    let change = format!("fluid.body-force=[\"0 m/s^2\", \"{lift} m/s^2\"]");
    let output = run(&case, &out, &[&change], &[]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));

    let read = |series: &str, column: &str| {
        Series::read(&out.join(format!("series/{series}.csv")))
            .unwrap()
            .column(column)
            .unwrap()
            .values
            .clone()
    };
    let times = read("grains", "t");
    assert_eq!(times.len(), 21);
    let (grains, fluid) = (read("grains", "vy"), read("probes", "centre.uy"));
    let end = slip_at(0.1, mass, fluid_mass);
    for ((time, v), u) in times.iter().zip(&grains).zip(&fluid) {
        let error = (v - u - slip_at(*time, mass, fluid_mass)) / end;
        assert!(error.abs() < 5e-3, "t = {time} s: {v} m/s through {u} m/s, {error} of the last slip");
    }
    let carried = (grains[20] - fluid[20]) / end - 1.0;
    assert!(carried.abs() < 1e-5, "the law carries the weight at {end} m/s, not at {carried} more");
}
