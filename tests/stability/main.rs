//! One pass per window is stable where grains and fluid share a closed vessel: neither can move without the other.
#![allow(clippy::print_stdout, reason = "the speeds are figures of the documentation")]

#[path = "../support/mod.rs"]
mod support;

use case_io::output::series::Series;
use std::path::Path;
use support::{Folder, run, stderr};

/// 320 grains of diameter `d` (mm) settle in a closed column of fluid of 5.512 d × 5.512 d × 27.56 d; `window` in ms.
fn column(d: f64, density: f64, window: f64, end: f64) -> String {
    let [side, height, first, spacing] = [5.512, 27.56, 0.689, 1.378].map(|length| length * d);
    let wall = |name: &str, point: [f64; 3], normal: [i32; 3]| {
        let [x, y, z] = point;
        format!(
            "[[wall]]\nname = \"{name}\"\nmaterial = \"grain\"\n\
             plane = {{ point = [\"{x} mm\", \"{y} mm\", \"{z} mm\"], normal = {normal:?} }}\n"
        )
    };
    let walls = [
        wall("floor", [0.0; 3], [0, 0, 1]),
        wall("lid", [0.0, 0.0, height], [0, 0, -1]),
        wall("left", [0.0; 3], [1, 0, 0]),
        wall("right", [side, 0.0, 0.0], [-1, 0, 0]),
        wall("front", [0.0; 3], [0, 1, 0]),
        wall("back", [0.0, side, 0.0], [0, -1, 0]),
    ]
    .concat();
    format!(
        r#"
[case]
title = "a closed column"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[time]
end = "{end} s"
window = "{window} ms"
[output]
series = "{} s"
frames = "none"
restart = "none"
[materials.grain]
density = "{density} kg/m^3"
youngs-modulus = "0.2 MPa"
poissons-ratio = 0.3
[pairs.grain-grain]
restitution = 0.6
sliding-friction = 0.3
[grains]
normal-law = "hertz"
[[insertion]]
name = "bed"
material = "grain"
diameter = "{d} mm"
lattice = {{ lower = ["{first} mm", "{first} mm", "{first} mm"], upper = ["{side} mm", "{side} mm", "{height} mm"], spacing = "{spacing} mm" }}
{walls}
[fluid]
backend = "eulerian"
density = "1000 kg/m^3"
viscosity = "1 mPa s"
[fluid.mesh.box]
lower = ["0 mm", "0 mm", "0 mm"]
upper = ["{side} mm", "{side} mm", "{height} mm"]
cells = [3, 3, 13]
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min", "y-max", "z-min", "z-max"]
kind = "slip"
[coupling]
scheme = "serial-explicit"
drag = "gidaspow"
added-mass = {}
"#,
        end / 20.0,
        if density < 1000.0 { 0.5 } else { 0.0 },
    )
}

fn values(out: &Path, series: &str, column: &str) -> Vec<f64> {
    Series::read(&out.join(format!("series/{series}.csv"))).unwrap().column(column).unwrap().values.clone()
}

/// Light drag and stiff drag, grains heavier and lighter than the fluid: without the answer of the grains in the fluid's
/// solution the first ends after 0.3 s with grains outside the vessel.
#[test]
fn a_bed_settles_in_a_closed_column_with_one_pass_per_window() {
    let folder = Folder::new();
    for (name, d, density, window, end) in
        [("sand", 1.0, 2500.0, 2.0, 0.8), ("silt", 0.1, 2500.0, 2.0, 1.6), ("beads", 1.0, 200.0, 1.0, 0.8)]
    {
        let case = folder.write(&format!("{name}/case.toml"), &column(d, density, window, end));
        let out = folder.join(&format!("{name}-out"));
        let output = run(&case, &out, &[], &[]);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", stderr(&output));
        let momentum = values(&out, "ledger", "momentum").into_iter().fold(0.0, f64::max);
        assert!(momentum <= 1e-12, "{name}: {momentum:e}");
        let (height, speed) = (values(&out, "grains", "z"), values(&out, "grains", "speed-max"));
        // Stokes' speed bounds the fall of a crowd, √(4/3 d g Δρ/ρ / 0.44) that of a lone grain in fast flow.
        let excess = (density / 1000.0 - 1.0).abs();
        let bound = (4.0 / 3.0 * d * 1e-3 * 9.81 * excess / 0.44_f64).sqrt();
        let fastest = speed.iter().fold(0.0, |a: f64, b| a.max(*b));
        println!(
            "{name}: fastest {fastest} m/s (lone {bound}), mean height {:?} → {:?} m",
            height[0],
            height.last()
        );
        assert!(fastest < bound, "{name}: {fastest} m/s");
        let fallen = (height.last().unwrap() - height[0]) * if density > 1000.0 { -1.0 } else { 1.0 };
        assert!(fallen > 4.0 * d * 1e-3, "{name}: {fallen} m");
    }
}
