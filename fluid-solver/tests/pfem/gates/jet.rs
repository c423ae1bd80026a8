//! A jet in free flight.

use super::scene::{advance, fluid, value};

const G: f64 = 9.81;

#[test]
fn a_jet_from_a_slot_has_the_volume_that_came_in_and_flies_along_its_parabola() {
    let tables = r#"pfem.size = "20 mm"
[[fluid.inlet]]
name = "slot"
box = { lower = ["0 m", "0 m"], upper = ["0 m", "0.1 m"] }
normal = [1, 0]
speed = "2 m/s""#;
    let mut jet = fluid("slot", 2, tables);
    let start = value(&*jet, "volume[m^3]");
    assert!((start - 0.1 * 0.02).abs() < 1e-15, "a layer of cells: {start}");
    advance(&mut *jet, 2e-3, [0.0, 0.3]);
    let entered = 2.0 * 0.1 * 0.3;
    assert!((value(&*jet, "volume-entered[m^3]") - entered).abs() <= 1e-12 * entered);
    let volume = value(&*jet, "volume[m^3]");
    println!(
        "a jet from a slot: volume less what came in {:.1e} of that",
        (volume - start - entered) / entered
    );
    assert!((volume - start - entered).abs() <= 1e-5 * entered, "{volume}");
    for x in [0.1, 0.2, 0.3, 0.4, 0.5] {
        let top = 0.1 - 0.5 * G * (x / 2.0_f64).powi(2);
        let found = jet.elevation([x, 0.0, 0.0]).unwrap();
        assert!((found - top).abs() <= 0.2 * 20e-3, "{x}: {found}, {top}");
    }
    // Of the stagnation pressure.
    let pressure = value(&*jet, "pressure-max[Pa]").max(-value(&*jet, "pressure-min[Pa]"));
    println!("pressure in it {:.4} of that of stagnation", pressure / 2000.0);
    assert!(pressure <= 0.03 * 0.5 * 1000.0 * 4.0, "{pressure} Pa");
}

#[test]
fn a_jet_from_a_nozzle_falls_faster_and_thinner_to_the_outlet_below() {
    let tables = r#"pfem.size = "10 mm"
[[fluid.inlet]]
name = "nozzle"
disc = { centre = ["0 m", "0 m", "0 m"], radius = "20 mm" }
normal = [0, 0, -1]
speed = "1 m/s"
[[fluid.outlet]]
name = "drain"
beyond = { point = ["0 m", "0 m", "-0.15 m"], normal = [0, 0, 1] }"#;
    let mut jet = fluid("nozzle", 3, tables);
    advance(&mut *jet, 2e-3, [0.0, 0.3]);
    let rate = std::f64::consts::PI * 4e-4;
    let entered = value(&*jet, "volume-entered[m^3]");
    assert!((entered - 0.3 * rate).abs() <= 1e-12 * entered, "{entered}");
    // Four cells across a surface that contracts: each edge that is split or collapsed takes a little; half as much at 6 mm.
    let error = value(&*jet, "volume-error[-]");
    println!("a jet from a nozzle: volume {error:.2e}");
    assert!(error.abs() <= 1.5e-3);
    // v(s) = √(v₀² + 2gs) through the area Q/v: the volume between both planes is Q times the time between them.
    let fall = ((1.0 + 2.0 * G * 0.15_f64).sqrt() - 1.0) / G;
    let volume = value(&*jet, "volume[m^3]");
    assert!((volume - rate * fall).abs() <= 0.05 * rate * fall, "{volume}, {}", rate * fall);
}
