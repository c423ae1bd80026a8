//! Water that sloshes by a tenth of its depth: remeshing has nothing to say in it.

use super::Seeds;
use super::dam_break::run;
use crate::support::tank;
use fluid_solver::backend::pfem::wall::Grip;
use std::f64::consts::PI;

#[test]
fn ten_periods_change_no_volume() {
    let (length, depth, h) = (0.584, 0.292, 0.0292);
    let walls = tank::<2>([length, 1.0], Grip::Slip);
    let mut seeds = Seeds::new(&walls);
    seeds.add_box([length, depth], h, 1, |x| [x[0], x[1] * (1.0 + 0.1 * (PI * x[0] / length).cos())]);
    let mut fluid = seeds.mesh(h, 1.2);
    // ω² = g k tanh(k H), k = π/L.
    let k = PI / length;
    let period = 2.0 * PI / (9.81 * k * (k * depth).tanh()).sqrt();
    let outcome = run(&mut fluid, 10.0 * period, period / 200.0);
    assert!(outcome.volume_error < 1e-3, "{}", outcome.volume_error);
    assert!(outcome.energy < 1.0 + 1e-5, "E/E0 = {}", outcome.energy);
    let books = &fluid.books.volume;
    assert_eq!(books.merging.absolute + books.separation.absolute + books.overlap.absolute.round(), 0.0);
    assert!(books.correction.absolute < 1e-3 * books.target, "{}", books.correction.absolute / books.target);
}
