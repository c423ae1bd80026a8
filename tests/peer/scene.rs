//! Dry cases for comparisons.

use crate::support::{DEM, Folder};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// Grains of 2 mm over a floor.
pub const FLOOR: &str = r#"
[case]
title = "grains and a floor"
dimension = 3
gravity = ["0.5 m/s^2", "0 m/s^2", "-9.81 m/s^2"]

[time]
end = "6 ms"
substep = "2 us"

[output]
series = "0.1 ms"

[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "5 MPa"
poissons-ratio = 0.3

[materials.steel]
density = "7800 kg/m^3"
youngs-modulus = "50 MPa"
poissons-ratio = 0.25

[pairs.glass-glass]
restitution = 0.5
sliding-friction = 0.5

[pairs.glass-steel]
restitution = 0.7
sliding-friction = 0.3

[grains]
normal-law = "liggghts-hertz"
domain = { lower = ["-20 mm", "-20 mm", "-5 mm"], upper = ["50 mm", "50 mm", "50 mm"] }

[[wall]]
name = "floor"
material = "steel"
plane = { point = ["0 mm", "0 mm", "0 mm"], normal = [0, 0, 1] }
"#;

/// Five grains hit the floor at 5 to 80 degrees from its normal, and each is hit by another that spins.
pub fn impacts() -> String {
    let mut grains = String::from("x[m],y[m],z[m],vx[m/s],vy[m/s],vz[m/s],wx[rad/s],wy[rad/s],wz[rad/s]\n");
    for (k, degrees) in [5.0_f64, 20.0, 40.0, 60.0, 80.0].into_iter().enumerate() {
        let (y, (sin, cos)) = (5e-3 * k as f64, degrees.to_radians().sin_cos());
        writeln!(grains, "0,{y},0.00102,{},0,{},0,0,0", sin, -cos).unwrap();
        writeln!(grains, "0.0006,{},0.0032,{},0,-1.1,40,{},-60", y + 4e-4, sin, 100.0 * k as f64).unwrap();
    }
    grains
}

/// A case of the floor with these grains from a file; its folder has a blank in its name.
pub fn with_file(folder: &Folder, grains: &str, spoil: impl FnOnce(String) -> String) -> PathBuf {
    folder.write("a case/grains.csv", grains);
    let insertion = "[[insertion]]\nname = \"grains\"\nmaterial = \"glass\"\ndiameter = \"2 mm\"\nfile = { path = \"grains.csv\" }\n";
    let file = folder.write("a case/case.toml", &spoil(format!("{FLOOR}\n{insertion}")));
    file.parent().unwrap().to_path_buf()
}

/// 150 grains of 1.6 to 2.4 mm settle between four walls, one of which closes in, on a floor of triangles that shakes.
pub fn crowd(folder: &Folder) -> PathBuf {
    let vertex = |x: f64, y: f64| format!("vertex {x} {y} 0\n");
    let triangle = |corners: [(f64, f64); 3]| {
        let vertices: String = corners.into_iter().map(|(x, y)| vertex(x, y)).collect();
        format!("facet normal 0 0 1\nouter loop\n{vertices}endloop\nendfacet\n")
    };
    let [a, b, c, d] = [(-10.0, -10.0), (30.0, -10.0), (30.0, 30.0), (-10.0, 30.0)];
    let floor = format!("solid floor\n{}{}endsolid floor\n", triangle([a, b, c]), triangle([a, c, d]));
    folder.write("a case/floor.stl", &floor);
    let plane = "plane = { point = [\"0 mm\", \"0 mm\", \"0 mm\"], normal = [0, 0, 1] }";
    let shaken = "stl = { path = \"floor.stl\", scale = 0.001, rims = 1 }\nmotion = { oscillation = { direction = [0, 0, 1], amplitude = \"0.3 mm\", frequency = \"25 Hz\" } }";
    let mut text =
        FLOOR.replace(plane, shaken).replace("\"6 ms\"", "\"80 ms\"").replace("\"0.1 ms\"", "\"1 ms\"");
    text = text.replace("\"2 us\"", "\"10 us\"").replace("\"liggghts-hertz\"", "\"hertz\"");
    for (name, point, normal, motion) in [
        ("left", "0 mm", "1, 0, 0", "motion = { translation = [\"0.02 m/s\", \"0 m/s\", \"0 m/s\"] }"),
        ("right", "16 mm", "-1, 0, 0", ""),
        ("front", "0 mm", "0, 1, 0", ""),
        ("back", "16 mm", "0, -1, 0", ""),
    ] {
        writeln!(
            text,
            "[[wall]]\nname = \"{name}\"\nmaterial = \"steel\"\nplane = {{ point = [\"{point}\", \"{point}\", \"0 mm\"], normal = [{normal}] }}\n{motion}"
        )
        .unwrap();
    }
    text += "[[insertion]]\nname = \"grains\"\nmaterial = \"glass\"\ndiameter-range = [\"1.6 mm\", \"2.4 mm\"]\nrandom-box = { lower = [\"0 mm\", \"0 mm\", \"1 mm\"], upper = [\"16 mm\", \"16 mm\", \"30 mm\"], count = 150 }\n";
    folder.write("a case/case.toml", &text).parent().unwrap().to_path_buf()
}

/// [`crowd`] on a floor that is a plane.
pub fn crowd_on_a_plane(folder: &Folder) -> PathBuf {
    let case = crowd(folder);
    let text = std::fs::read_to_string(case.join("case.toml")).unwrap();
    let stl = "stl = { path = \"floor.stl\", scale = 0.001, rims = 1 }";
    assert!(text.contains(stl));
    let plane = "plane = { point = [\"0 mm\", \"0 mm\", \"0 mm\"], normal = [0, 0, 1] }";
    folder.write("a case/case.toml", &text.replace(stl, plane));
    case
}

/// `dem-solver` with these arguments, to its end.
pub fn dem(task: &str, case: &Path, out: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(DEM);
    command.arg(task).arg(case).arg("--out").arg(out).args(arguments).stdin(Stdio::null());
    command.output().unwrap()
}
