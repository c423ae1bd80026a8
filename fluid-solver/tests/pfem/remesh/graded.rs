//! Cells that are fine at the surface and coarse below.

use super::dam_break::run;
use super::{Fluid, Seeds};
use crate::gates::scene::{checkpoint, fluid, grains_beside, value};
use crate::support::tank;
use fluid_solver::backend::pfem::remesh::{Grading, Near, Source, TargetSize};
use fluid_solver::backend::pfem::wall::Grip;
use fluid_solver::backend::{Attempt, FluidBackend, Step};
use fluid_solver::element::simplex::distance;
use interface::frames::{GrainRow, ReactionRow};
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
    assert!(outcome.volume_error < 1e-8, "{}", outcome.volume_error);
    assert!(outcome.energy <= 1.0, "E/E0 = {}", outcome.energy);
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
    println!(
        "fine at the surface: volume {:.1e}, highest E/E0 − 1 {:.1e}",
        outcome.volume_error,
        outcome.energy - 1.0
    );
    // Edges are split above 1.4 of their size and collapse below half of it.
    assert!(longest <= 1.4 * FINE * h && edges >= 14, "{edges} edges up to {longest}");
    assert!(shortest_deep > 0.5 * h, "{shortest_deep}");
}

/// A vessel of waves, 1 m × 0.5 m (× 0.5 m), with cells of two sizes: the finer near something.
fn vessel<const D: usize>(near: &str, [h, fine]: [f64; 2]) -> Box<dyn FluidBackend> {
    let corner = |x: [f64; D]| format!("{:?}", x.map(|x| format!("{x} m")));
    let (lower, upper) = (corner([0.0; D]), corner(std::array::from_fn(|k| if k == 0 { 1.0 } else { 0.5 })));
    let up = ["y", "z"][D - 2];
    let sides = if D == 2 { r#""x-min", "x-max""# } else { r#""x-min", "x-max", "y-min", "y-max""# };
    let tables = format!(
        r#"[fluid.mesh]
box = {{ lower = {lower}, upper = {upper}, size = "{h} m", jitter = 0.1, surface = "0.5 + 0.02*cos(pi*x)" }}
[[fluid.pfem.refine]]
near = {near:?}
size = "{fine} m"
[[fluid.boundary]]
on = [{sides}, "{up}-min"]
kind = "slip"
[[fluid.boundary]]
on = ["{up}-max"]
kind = "free-surface"{}"#,
        if near == "grains" { grains_beside(D) } else { String::new() }
    );
    fluid(&format!("refine-{near}-{D}"), D, &tables)
}

/// A grain that goes along the vessel in its middle, after some time (s).
fn grain<const D: usize>(radius: f64, time: f64) -> GrainRow {
    let mut position = [0.25 + 1.0 * time, 0.25, 0.25];
    position[D..].fill(0.0);
    GrainRow { position, velocity: [1.0, 0.0, 0.0], radius, mass: 1.0, ..GrainRow::default() }
}

/// Lengths of the edges whose middles are at places.
fn edges<const D: usize, const N: usize>(
    fluid: &dyn FluidBackend,
    holds: impl Fn(&[f64; D]) -> bool,
) -> Vec<f64> {
    let (state, _) = checkpoint(fluid, &format!("edges-{D}"));
    let (place, cells) = (state.array::<f64>("place").unwrap(), state.array::<u32>("cells").unwrap());
    let place = |node: u32| -> [f64; D] { std::array::from_fn(|k| place[D * node as usize + k]) };
    let mut pairs: Vec<[u32; 2]> = Vec::new();
    for cell in cells.chunks_exact(N) {
        pairs.extend((0..N).flat_map(|i| (0..i).map(move |j| [cell[i].min(cell[j]), cell[i].max(cell[j])])));
    }
    pairs.sort_unstable();
    pairs.dedup();
    let ends = pairs.iter().map(|pair| pair.map(place));
    let middle = |[a, b]: &[[f64; D]; 2]| std::array::from_fn(|k| 0.5 * (a[k] + b[k]));
    ends.filter(|ends| holds(&middle(ends))).map(|[a, b]| distance(&a, &b)).collect()
}

/// Cells that follow a grain or stay at walls while water moves: mean and largest length of edges there, over the size asked
/// for, and mean length far from there, over that of elsewhere; the volume is kept to `allowed`.
fn refined<const D: usize, const N: usize>(near: &str, [h, fine]: [f64; 2], allowed: f64) {
    let (mut tank, radius, length) = (vessel::<D>(near, [h, fine]), 0.4 * h, 1e-2);
    let by_grain = near == "grains";
    if by_grain {
        tank.populate(0.0, &[grain::<D>(radius, 0.0)]).unwrap();
    }
    for n in 0..50 {
        let step = Step { time: length * f64::from(n), length };
        tank.save();
        let mut reactions = Vec::new();
        if by_grain {
            let grain = grain::<D>(radius, step.end());
            tank.project(step, &[grain]).unwrap();
            let target_velocity = grain.velocity;
            reactions.push(ReactionRow {
                exchange_coefficient: 200.0 * h.powi(D as i32),
                target_velocity,
                inverse_mass: 1.0,
                ..ReactionRow::default()
            });
        }
        assert!(matches!(tank.solve(step, &reactions), Ok(Attempt::Solved(_))), "window {n}");
        tank.prepare_samples();
        tank.commit(step).unwrap();
    }
    let centre = grain::<D>(radius, 0.5).position;
    let centre: [f64; D] = std::array::from_fn(|k| centre[k]);
    // The way to the grain or the nearest wall.
    let way = |x: &[f64; D]| {
        let wall = |k: usize| if k == D - 1 { x[k] } else { x[k].min(if k == 0 { 1.0 } else { 0.5 } - x[k]) };
        if by_grain { distance(x, &centre) - radius } else { (0..D).map(wall).fold(f64::INFINITY, f64::min) }
    };
    let close = edges::<D, N>(&*tank, |x| way(x) < 0.25 * h);
    let far = edges::<D, N>(&*tank, |x| way(x) > 2.0 * h);
    let mean = |edges: &[f64]| edges.iter().sum::<f64>() / edges.len() as f64;
    let longest = close.iter().copied().fold(0.0, f64::max) / fine;
    let (close_mean, far_mean) = (mean(&close) / fine, mean(&far) / h);
    let error = value(&*tank, "volume-error-max[-]");
    println!(
        "near {near} in {D}D: {} edges, mean {close_mean:.3} (at most {longest:.3}) of their size; {} far, mean {far_mean:.3}; volume {error:.2e} (at last {:.2e}), nodes {}",
        close.len(),
        far.len(),
        value(&*tank, "volume-error[-]"),
        value(&*tank, "nodes[-]")
    );
    assert!(close.len() >= 10 && far.len() >= 10, "{} {}", close.len(), far.len());
    // Inner edges are split above 1.9 of their size, which grows away from what they are fine at.
    assert!((0.9..1.35).contains(&close_mean) && longest <= 2.5, "{close_mean} {longest}");
    // Where a grain was cells of half the size stay, but for nodes nearer than 0.6.
    assert!((0.8..1.35).contains(&far_mean), "{far_mean}");
    assert!(error <= allowed, "{error}");
}

#[test]
fn cells_are_fine_at_walls_and_coarse_elsewhere() {
    refined::<2, 3>("walls", [0.05, 0.025], 1.5e-10);
    refined::<3, 4>("walls", [0.1, 0.05], 4e-5);
}

#[test]
fn cells_are_fine_around_a_grain_that_goes_along_and_coarse_where_it_was() {
    refined::<2, 3>("grains", [0.05, 0.025], 2e-8);
    refined::<3, 4>("grains", [0.1, 0.05], 3e-5);
}
