//! Cells that are fine at the surface and coarse below.

use super::dam_break::run;
use super::{Fluid, Seeds};
use crate::support::tank;
use fluid_solver::backend::pfem::remesh::{Grading, Near, Source, TargetSize};
use fluid_solver::backend::pfem::wall::Grip;
use std::f64::consts::PI;

const FINE: f64 = 0.5;

fn tank_of_waves(h: f64) -> Fluid {
    let (length, depth) = (1.0, 0.5);
    let walls = tank::<2>([length, 1.0], Grip::Slip);
    let mut seeds = Seeds::new(&walls);
    seeds.add_box([length, depth], h, 1, |x| [x[0], x[1] * (1.0 + 0.1 * (PI * x[0] / length).cos())]);
    seeds.mesh(h, 1.2)
}

#[test]
fn the_surface_becomes_fine_and_stays_so_while_volume_and_energy_are_kept() {
    let h = 0.1;
    let mut fluid = tank_of_waves(h);
    let source = Source { near: Near::Surface, size: FINE * h };
    fluid.size =
        TargetSize::Graded(Grading { coarse: h, growth: 0.3, sources: vec![source], by_grains: Vec::new() });
    let outcome = run(&mut fluid, 2.0, 0.005);
    assert!(outcome.volume_error < 1e-3, "{}", outcome.volume_error);
    assert!(outcome.energy < 1.0 + 1e-4, "E/E0 = {}", outcome.energy);
    let cloud = &fluid.cloud;
    let (mut edges, mut longest, mut shortest_deep) = (0, 0.0f64, f64::INFINITY);
    cloud.for_each_free_face(|cell, opposite| {
        let [a, b] = [1, 2].map(|k| cloud.place[cloud.cells[cell][(opposite + k) % 3] as usize]);
        longest = longest.max((a[0] - b[0]).hypot(a[1] - b[1]));
        edges += 1;
    });
    for cell in &cloud.cells {
        let vertices = cloud.vertices(cell);
        if vertices.iter().all(|x| x[1] < 0.15) {
            let [a, b] = [vertices[0], vertices[1]];
            shortest_deep = shortest_deep.min((a[0] - b[0]).hypot(a[1] - b[1]));
        }
    }
    // Edges are split above 1.4 of their size and collapse below half of it.
    assert!(longest <= 1.4 * FINE * h && edges >= 14, "{edges} edges up to {longest}");
    assert!(shortest_deep > 0.5 * h, "{shortest_deep}");
}
