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
    println!("{} {}", volume / (start + entered) - 1.0, value(&*jet, "volume-moved-by-correction[m^3]"));
    assert!((volume - start - entered).abs() <= 1e-3 * entered, "{volume}");
    for x in [0.1, 0.2, 0.4, 0.55] {
        let top = 0.1 - 0.5 * G * (x / 2.0_f64).powi(2);
        let found = jet.elevation([x, 0.0, 0.0]).unwrap();
        println!("{x} {}", found - top);
        assert!((found - top).abs() <= 2e-3, "{x}: {found}, {top}");
    }
    assert!(value(&*jet, "pressure-max[Pa]") <= 20.0, "{}", value(&*jet, "pressure-max[Pa]"));
}
