//! Tanks that are filled and emptied.

use super::scene::{advance, fluid, value};

#[test]
fn a_tank_rises_by_what_comes_in() {
    let tables = r#"[fluid.mesh.box]
lower = ["0 m", "0 m"]
upper = ["1 m", "0.4 m"]
size = "40 mm"
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min"]
kind = "slip"
[[fluid.boundary]]
on = ["y-max"]
kind = "free-surface"
[[fluid.inlet]]
name = "pipe"
box = { lower = ["0 m", "0.08 m"], upper = ["0 m", "0.24 m"] }
normal = [1, 0]
velocity = { expression = ["0.5*min(t/0.5, 1)", "0"] }"#;
    let mut tank = fluid("filling", 2, tables);
    advance(&mut *tank, 5e-3, [0.0, 2.0]);
    let entered = 0.16 * 0.5 * (0.25 + 1.5);
    let found = value(&*tank, "volume-entered[m^3]");
    let error = value(&*tank, "volume-error[-]");
    println!("a tank that rises: entered to {:.1e} m³, volume {error:.1e}", found - entered);
    assert!((found - entered).abs() <= 1e-12, "{found}");
    assert!(error.abs() <= 1e-7, "{error}");
}

#[test]
fn a_tank_without_a_side_empties_to_the_last_node() {
    let tables = r#"[fluid.mesh.box]
lower = ["0 m", "0 m"]
upper = ["0.5 m", "0.2 m"]
size = "25 mm"
[[fluid.boundary]]
on = ["x-min", "floor"]
kind = "slip"
[[fluid.boundary]]
on = ["x-max"]
kind = "outlet"
[[fluid.boundary]]
on = ["y-min", "y-max"]
kind = "free-surface"
[[wall]]
name = "floor"
plane = { point = ["0 m", "0 m"], normal = [0, 1] }"#;
    let mut tank = fluid("emptying", 2, &format!("body-force = [\"3 m/s^2\", \"0 m/s^2\"]\n{tables}"));
    advance(&mut *tank, 5e-3, [0.0, 3.0]);
    assert_eq!(value(&*tank, "nodes[-]"), 0.0);
    let left = value(&*tank, "volume-left[m^3]") / 0.1;
    println!(
        "an open tank has no node left; of its volume {:.1e} did not leave through the outlet",
        1.0 - left
    );
    assert!((left - 1.0).abs() <= 1.5e-3, "{left}");
}

#[test]
fn a_tank_in_space_without_a_side_empties_to_the_last_node() {
    let tables = r#"[fluid.mesh.box]
lower = ["0 m", "0 m", "0 m"]
upper = ["0.5 m", "0.1 m", "0.2 m"]
size = "40 mm"
[[fluid.boundary]]
on = ["x-min", "y-min", "y-max", "floor"]
kind = "slip"
[[fluid.boundary]]
on = ["x-max"]
kind = "outlet"
[[fluid.boundary]]
on = ["z-min", "z-max"]
kind = "free-surface"
[[wall]]
name = "floor"
plane = { point = ["0 m", "0 m", "0 m"], normal = [0, 0, 1] }"#;
    let mut tank = fluid(
        "emptying-space",
        3,
        &format!("body-force = [\"3 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n{tables}"),
    );
    advance(&mut *tank, 5e-3, [0.0, 3.0]);
    assert_eq!(value(&*tank, "nodes[-]"), 0.0);
    let left = value(&*tank, "volume-left[m^3]") / 0.01;
    println!(
        "an open tank in space has no node left, and of its volume {:+.1e} too much has left",
        left - 1.0
    );
    assert!((left - 1.0).abs() <= 1e-3, "{left}");
}

#[test]
fn a_fountain_comes_from_the_whole_nozzle_when_its_water_runs_back_to_it() {
    let tables = r#"pfem.size = "12 mm"
[[fluid.inlet]]
name = "nozzle"
box = { lower = ["-24 mm", "0 m"], upper = ["24 mm", "0 m"] }
normal = [0, 1]
speed = "1.5 m/s"
[[fluid.boundary]]
on = ["left", "right", "floor"]
kind = "slip"
[[wall]]
name = "floor"
plane = { point = ["0 m", "0 m"], normal = [0, 1] }
[[wall]]
name = "left"
plane = { point = ["-0.15 m", "0 m"], normal = [1, 0] }
[[wall]]
name = "right"
plane = { point = ["0.15 m", "0 m"], normal = [-1, 0] }"#;
    let mut fountain = fluid("fountain", 2, tables);
    for window in 0..12 {
        advance(&mut *fountain, 2e-3, [0.05 * f64::from(window), 0.05 * f64::from(window + 1)]);
        let speed = |x: f64| fountain.at(0.0, [x, 0.0, 0.0]).unwrap().velocity[1];
        for x in [-23.9e-3, -10e-3, 5e-3, 23.9e-3] {
            assert!((speed(x) / speed(0.0) - 1.0).abs() < 1e-9, "{x} m: {} of {}", speed(x), speed(0.0));
        }
    }
    let volume = 0.048 * (0.012 + 1.5 * 0.6);
    println!("a fountain: volume {:+.1e}", value(&*fountain, "volume[m^3]") / volume - 1.0);
    assert!((value(&*fountain, "volume[m^3]") / volume - 1.0).abs() < 7e-4);
}

#[test]
fn a_fountain_in_space_comes_from_the_whole_nozzle_when_its_water_runs_back_to_it() {
    let sides =
        [("left", 0, 1), ("right", 0, -1), ("front", 1, 1), ("back", 1, -1)].map(|(name, axis, sign)| {
            let along = |length: f64| if axis == 0 { [length, 0.0, 0.0] } else { [0.0, length, 0.0] };
            let (point, normal) =
                (along(-0.1 * f64::from(sign)).map(|x| format!("{x} m")), along(f64::from(sign)));
            format!("[[wall]]\nname = {name:?}\nplane = {{ point = {point:?}, normal = {normal:?} }}\n")
        });
    let tables = r#"pfem.size = "20 mm"
[[fluid.inlet]]
name = "nozzle"
disc = { centre = ["0 m", "0 m", "0 m"], radius = "35 mm" }
normal = [0, 0, 1]
speed = "1 m/s"
[[fluid.boundary]]
on = ["left", "right", "front", "back", "floor"]
kind = "slip"
[[wall]]
name = "floor"
plane = { point = ["0 m", "0 m", "0 m"], normal = [0, 0, 1] }
"#;
    let mut fountain = fluid("fountain-space", 3, &format!("{tables}{}", sides.concat()));
    let (mut start, mut below) = (0.0, 0);
    for end in [0.3, 0.35, 0.4, 0.45, 0.5] {
        advance(&mut *fountain, 3e-3, [start, end]);
        start = end;
        let speed = |x: f64, y: f64| fountain.at(0.0, [x, y, 0.0]).unwrap().velocity[2];
        for ray in 0..12 {
            let (y, x) = (f64::from(ray) * std::f64::consts::TAU / 12.0).sin_cos();
            let share = |r: f64| speed(r * x, r * y) / speed(0.0, 0.0);
            for r in [10e-3, 20e-3] {
                assert!((share(r) - 1.0).abs() < 1e-9, "{end} s, {r} m, ray {ray}: {}", share(r));
            }
            below += [10e-3, 20e-3, 28e-3].into_iter().filter(|&r| share(r) < 1.0 - 1e-9).count();
            // A film that ends at the rim has cells that reach over it.
            assert!(share(28e-3) > 0.5, "{end} s, ray {ray}: {}", share(28e-3));
        }
    }
    println!("a fountain in space: at {below} of 180 places below the inlet's velocity");
}
