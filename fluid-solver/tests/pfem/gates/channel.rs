//! A full channel.

use super::scene::{advance, fluid, value};

#[test]
fn a_channel_fed_at_its_left_and_open_at_its_right_stays_full() {
    let tables = r#"[fluid.mesh.box]
lower = ["0 m", "0 m"]
upper = ["1 m", "0.2 m"]
size = "40 mm"
[[fluid.boundary]]
on = ["y-min", "y-max"]
kind = "slip"
[[fluid.boundary]]
on = ["x-min"]
kind = "inlet"
speed = "0.5 m/s"
[[fluid.boundary]]
on = ["x-max"]
kind = "outlet""#;
    let mut channel = fluid("channel", 2, tables);
    advance(&mut *channel, 10e-3, [0.0, 4.0]);
    println!("{:?}", channel.statistics(0.0));
    assert!((value(&*channel, "volume[m^3]") - 0.2).abs() <= 1e-6);
    assert!((value(&*channel, "volume-entered[m^3]") - 0.4).abs() <= 1e-12);
    assert!((value(&*channel, "volume-left[m^3]") - 0.4).abs() <= 1e-6);
    assert!((value(&*channel, "x-max[m]") - 1.0).abs() <= 1e-12);
}
