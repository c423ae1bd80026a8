//! A full pipe.

use super::scene::{advance, fluid, value};

#[test]
fn a_pipe_fed_from_below_and_open_above_stays_full_and_holds_its_weight() {
    let tables = r#"[fluid.mesh.box]
lower = ["0 m", "0 m"]
upper = ["0.2 m", "1 m"]
size = "40 mm"
[[fluid.boundary]]
on = ["x-min", "x-max"]
kind = "slip"
[[fluid.boundary]]
on = ["y-min"]
kind = "inlet"
speed = "0.5 m/s"
[[fluid.boundary]]
on = ["y-max"]
kind = "outlet""#;
    let mut pipe = fluid("pipe", 2, tables);
    advance(&mut *pipe, 10e-3, [0.0, 4.0]);
    let of = |name: &str, exact: f64| (value(&*pipe, name) - exact).abs();
    let (volume, entered) = (of("volume[m^3]", 0.2), of("volume-entered[m^3]", 0.4));
    let left = of("volume-left[m^3]", 0.4);
    println!("a full pipe: volume, entered, left to {volume:.1e}, {entered:.1e}, {left:.1e} m³");
    assert!(volume <= 1e-12 && entered <= 1e-14 && left <= 6e-12, "{volume} {entered} {left}");
    assert!((value(&*pipe, "y-max[m]") - 1.0).abs() <= 1e-9);
    // Nodes that come and go shake it.
    for y in [0.0, 0.3, 0.8] {
        let (found, weight) = (pipe.at(4.0, [0.1, y, 0.0]).unwrap().pressure, 1000.0 * 9.81 * (1.0 - y));
        assert!((found - weight).abs() <= 0.01 * 9810.0, "{y}: {found}, {weight}");
    }
}
