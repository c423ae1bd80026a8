//! Mud that flows round a stone.

use crate::gates::scene::liquid;
use fluid_solver::backend::{Attempt, Step};

#[test]
fn mud_comes_to_a_stone_and_under_it_without_a_step_refused() {
    let tables = r#"[fluid.mesh.box]
lower = ["0 m", "0 m"]
upper = ["0.15 m", "0.15 m"]
size = "8 mm"
[fluid.rheology]
law = "bingham"
yield-stress = "20 Pa"
[[fluid.boundary]]
on = ["left"]
kind = "slip"
[[fluid.boundary]]
on = ["floor", "stone"]
kind = "no-slip"
[[fluid.boundary]]
on = ["x-min", "x-max", "y-min", "y-max"]
kind = "free-surface"
[[wall]]
name = "floor"
plane = { point = ["0 m", "0 m"], normal = [0, 1] }
[[wall]]
name = "left"
plane = { point = ["0 m", "0 m"], normal = [1, 0] }
[[wall]]
name = "stone"
sphere = { centre = ["0.25 m", "0.03 m"], radius = "0.025 m", grains = "outside" }"#;
    let mut mud = liquid("stone", 2, ["1500 kg/m^3", "1 Pa s"], tables);
    let (window, mut most) = (2e-3, 0);
    for number in 0..80 {
        let step = Step { time: window * f64::from(number), length: window };
        mud.save();
        match mud.solve(step, &[]).unwrap() {
            Attempt::Solved(solution) => most = most.max(solution.iterations),
            Attempt::TooLarge(too_large) => panic!("{} s: {}", step.time, too_large.reason),
        }
        mud.commit(step).unwrap();
    }
    println!("mud that comes to a stone: {most} linear iterations in a window at most");
    assert!(most <= 1000, "{most} linear iterations in a window");
}
