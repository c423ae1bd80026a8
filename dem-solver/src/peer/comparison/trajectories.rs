//! Grain by grain, where both programs compute the same formulas.

use super::{Comparison, Curves, check};
use crate::peer::results::{State, Trajectories};
use crate::peer::task::Task;
use crate::vector::Vector;

/// Allowed deviation unless the user states another; what is left is the single precision of velocities in frames,
/// 6e-8, and the start of grains that touch, where LIGGGHTS damps with another velocity.
const TOLERANCE: f64 = 1e-5;
/// So many grains are plotted.
const SHOWN: usize = 4;

/// The largest deviations of place, velocity and spin of any grain at any sample: of diameter d, impact speed V and
/// V/r, where V is the largest speed of the peer's run and d = 2 r the smallest diameter.
pub fn compare_trajectories(
    task: &Task,
    peer: &'static str,
    own: &Trajectories,
    theirs: &Trajectories,
    tolerance: Option<f64>,
) -> Comparison {
    let states = || theirs.iter().flatten();
    let speed = states().map(|state| state.velocity.norm()).fold(0.0, f64::max);
    let radius = task.grains.iter().map(|grain| grain.radius).fold(f64::INFINITY, f64::min);
    let tolerance = tolerance.unwrap_or(TOLERANCE);
    let mut deviations = [const { Vec::new() }; 3];
    for (own, theirs) in own.iter().zip(theirs) {
        let of_grains = own.iter().zip(theirs).map(|(own, theirs)| deviation(task, own, theirs));
        let largest = of_grains.fold([0.0; 3], |a: [f64; 3], b| std::array::from_fn(|k| a[k].max(b[k])));
        deviations.iter_mut().zip(largest).for_each(|(all, largest)| all.push(largest));
    }
    let quantities = [
        ("place", 2.0 * radius, "the smallest diameter"),
        ("velocity", speed, "the largest speed V"),
        ("spin", speed / radius, "V over the smallest radius"),
    ];
    let mut relative = Curves { name: "deviation".into(), columns: vec![] };
    let mut checks = Vec::new();
    for ((name, scale, of), values) in quantities.into_iter().zip(&deviations) {
        let largest = values.iter().copied().fold(0.0, f64::max);
        let why = format!("of any grain at any sample, relative to {of}, {scale:.4e} SI");
        checks.push(check(format!("{name}, largest deviation"), largest, scale, tolerance, why));
        let share = values.iter().map(|value| if scale > 0.0 { value / scale } else { *value }).collect();
        relative.columns.push((format!("{name}[1]"), share));
    }
    let mut curves = vec![relative];
    for row in 0..task.grains.len().min(SHOWN) {
        curves.push(of_grain(row, "velocity", "m/s", peer, own, theirs, |state| state.velocity));
        curves.push(of_grain(row, "spin", "rad/s", peer, own, theirs, |state| state.angular_velocity));
    }
    Comparison { checks, curves }
}

/// Distance of the places, over the nearest period, and size of the differences of velocity and spin.
fn deviation(task: &Task, own: &State, theirs: &State) -> [f64; 3] {
    let domain = &task.scene.domain;
    let apart = own.centre - theirs.centre;
    let apart = Vector::<3>::from_fn(|axis, _| match domain.periodic[axis] {
        true => apart[axis] - domain.period(axis) * (apart[axis] / domain.period(axis)).round(),
        false => apart[axis],
    });
    let velocity = own.velocity - theirs.velocity;
    let spin = own.angular_velocity - theirs.angular_velocity;
    [apart.norm(), velocity.norm(), spin.norm()]
}

fn of_grain(
    row: usize,
    quantity: &str,
    unit: &str,
    peer: &str,
    own: &Trajectories,
    theirs: &Trajectories,
    vector: fn(&State) -> Vector<3>,
) -> Curves {
    let mut columns = Vec::new();
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        for (program, run) in [("silt", own), (peer, theirs)] {
            let values = run.iter().map(|states| vector(&states[row])[axis]).collect();
            columns.push((format!("{program} {name}[{unit}]"), values));
        }
    }
    Curves { name: format!("grain-{row}-{quantity}"), columns }
}
