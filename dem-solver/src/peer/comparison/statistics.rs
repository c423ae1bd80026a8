//! Sums over the grains, where the trajectories of single grains mean nothing.

use super::{Comparison, Curves, check};
use crate::peer::results::Statistics;
use crate::peer::task::Task;

/// Allowed deviation unless the user states another.
const TOLERANCE: f64 = 0.05;
/// Chance explains a deviation from the peer that is so many times that of this program from its own twin.
const CHANCE: f64 = 3.0;

/// A number or a vector over time.
struct Quantity {
    name: String,
    unit: &'static str,
    /// Values at the samples, by component.
    components: Vec<Vec<f64>>,
    /// What deviations are relative to, and its name.
    scale: f64,
    of: &'static str,
}

/// Root mean square over time of the deviation of the mean place, the kinetic energy and the impulse that each wall
/// has received (a force over a short time is a matter of single impacts).
///
/// `own` are two runs of this program, of slightly other steps. In a crowd that is enough for other trajectories,
/// and what it changes in a sum is chance: [`CHANCE`] times the most of its kind is allowed beside the tolerance.
pub fn compare_statistics(
    task: &Task,
    peer: &'static str,
    own: [&Statistics; 2],
    theirs: &Statistics,
    tolerance: Option<f64>,
) -> Comparison {
    let tolerance = tolerance.unwrap_or(TOLERANCE);
    let forces = task.walls.iter().zip(own[0].on_walls.iter().zip(&theirs.on_walls));
    let forces = forces
        .map(|(wall, (own, theirs))| curves(peer, &format!("force on {}", wall.name), "N", own, theirs));
    let forces: Vec<Curves> = forces.collect();
    let [own, twin, theirs] = [own[0], own[1], theirs].map(|run| quantities(task, run));
    // One twin says little of one quantity; its likes, the walls or the axes, say more.
    let chance = |unit: &str| {
        let alike = own.iter().zip(&twin).filter(|(own, _)| own.unit == unit);
        alike.map(|(own, twin)| deviation(own, twin)).fold(0.0, f64::max)
    };
    let mut comparison = Comparison { checks: vec![], curves: vec![] };
    for (own, theirs) in own.iter().zip(&theirs) {
        let scale = own.scale.max(theirs.scale);
        let chance = if scale > 0.0 { CHANCE * chance(own.unit) / scale } else { 0.0 };
        let why = format!(
            "root mean square over time, relative to {}, {scale:.4e} {}; allowed: {tolerance} and {chance:.1e} for chance",
            own.of, own.unit
        );
        comparison.curves.push(curves(peer, &own.name, own.unit, &own.components, &theirs.components));
        comparison.checks.push(check(
            own.name.clone(),
            deviation(own, theirs),
            scale,
            tolerance + chance,
            why,
        ));
    }
    comparison.curves.extend(forces);
    comparison
}

fn quantities(task: &Task, run: &Statistics) -> Vec<Quantity> {
    let mut quantities = Vec::new();
    let diameter = task.grains.iter().map(|grain| 2.0 * grain.radius).sum::<f64>() / task.grains.len() as f64;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        // Along an axis that wraps, a mean place depends on where it wraps.
        if !task.scene.domain.periodic[axis] {
            let values = run.centre[axis].clone();
            let (scale, of) = (range(&values).max(diameter), "its way, at least a mean diameter");
            quantities.push(Quantity {
                name: format!("mean {name}"),
                unit: "m",
                components: vec![values],
                scale,
                of,
            });
        }
    }
    let mut add = |name: String, unit, components: Vec<Vec<f64>>, of| {
        let scale = components.iter().flatten().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        quantities.push(Quantity { name, unit, components, scale, of });
    };
    add("kinetic energy".into(), "J", vec![run.kinetic_energy.clone()], "the largest");
    if task.removes() {
        add("number of grains".into(), "1", vec![run.count.clone()], "the largest");
    }
    for (wall, forces) in task.walls.iter().zip(&run.on_walls) {
        let impulses = forces.iter().map(|forces| sums(forces, task.interval())).collect();
        add(format!("impulse on {}", wall.name), "N s", impulses, "its largest component");
    }
    quantities
}

/// What forces, means over intervals \[s\], add up to.
fn sums(forces: &[f64], interval: f64) -> Vec<f64> {
    let mut sum = 0.0;
    let mut add = |force: &f64| {
        sum += force * interval;
        sum
    };
    forces.iter().map(&mut add).collect()
}

/// √(mean over time of |a - b|²).
fn deviation(one: &Quantity, other: &Quantity) -> f64 {
    let both = one.components.iter().flatten().zip(other.components.iter().flatten());
    let squares: f64 = both.map(|(a, b)| (a - b).powi(2)).sum();
    (squares / one.components[0].len() as f64).sqrt()
}

/// Both programs' values over time, by component.
fn curves(peer: &str, name: &str, unit: &str, own: &[Vec<f64>], theirs: &[Vec<f64>]) -> Curves {
    let axes: &[&str] = if own.len() == 3 { &[" x", " y", " z"] } else { &[""] };
    let columns = axes.iter().zip(own.iter().zip(theirs)).flat_map(|(axis, (own, theirs))| {
        [("silt", own), (peer, theirs)]
            .map(|(program, values)| (format!("{program}{axis}[{unit}]"), values.clone()))
    });
    Curves { name: name.replace(' ', "-"), columns: columns.collect() }
}

fn range(values: &[f64]) -> f64 {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = values.iter().fold(ends, |(low, high), &value| (value.min(low), value.max(high)));
    (high - low).max(0.0)
}
