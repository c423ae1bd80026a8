//! What a run gave, and how a peer tells it.
//!
//! - [`TRAJECTORIES`]: a text dump of LAMMPS. Where it has forces and torques it is of velocity Verlet, where
//!   v(t) = v(t - h/2) + F h/2m; the step before is what this program has at the sample.
//! - [`MEANS`]: a row `step count x y z energy` at each sample, means over the grains and the sum of their energies.
//! - [`WALLS`]: a row `step fx fy fz …` at each sample, means over the steps since the last, three columns a wall.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use case_io::output::OutputError;

use super::error::PeerError;
use super::task::{Sphere, Task};
use crate::grains::{inertia, volume};
use crate::vector::{Spin, Vector};

/// Name of the file of trajectories.
pub const TRAJECTORIES: &str = "grains.dump";
/// Name of the file of means over the grains.
pub const MEANS: &str = "means.txt";
/// Name of the file of forces on walls.
pub const WALLS: &str = "walls.txt";

/// A grain at a sample.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Centre \[m\].
    pub centre: Vector<3>,
    /// Velocity \[m/s\].
    pub velocity: Vector<3>,
    /// Angular velocity \[rad/s\].
    pub angular_velocity: Spin,
}

/// The grains, in their order, at each sample after the start.
pub type Trajectories = Vec<Vec<State>>;

/// Sums over the grains at each sample after the start.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Number of grains.
    pub count: Vec<f64>,
    /// Mean of the centres \[m\], by axis.
    pub centre: [Vec<f64>; 3],
    /// Kinetic energy \[J\].
    pub kinetic_energy: Vec<f64>,
    /// Force of the grains \[N\], mean since the last sample, by wall and axis.
    pub on_walls: Vec<[Vec<f64>; 3]>,
}

/// Reads [`TRAJECTORIES`].
///
/// # Errors
/// A file that is missing or is not what the deck asks for.
pub fn trajectories(folder: &Path, task: &Task) -> Result<Trajectories, PeerError> {
    let path = folder.join(TRAJECTORIES);
    let text = read(&path)?;
    let bad = |problem: String| PeerError::BadResult {
        path: path.clone(),
        problem,
        expected: format!("{} grains at each of {} samples", task.grains.len(), task.samples),
    };
    let mut snapshots = BTreeMap::new();
    for block in text.split("ITEM: TIMESTEP\n").skip(1) {
        let step: u64 = block.lines().next().and_then(|line| line.trim().parse().ok()).unwrap_or(u64::MAX);
        let rows = block.split_once("ITEM: ATOMS ").map_or("", |(_, rows)| rows);
        let mut lines = rows.lines();
        let names: Vec<&str> = lines.next().unwrap_or_default().split_whitespace().collect();
        let mut states = vec![None; task.grains.len()];
        for line in lines {
            let values = row(line).filter(|values| values.len() == names.len());
            let values =
                values.ok_or_else(|| bad(format!("step {step}: {line:?} is not a row of finite numbers")))?;
            let cell =
                |name: &str| names.iter().position(|known| *known == name).map(|column| values[column]);
            let number = cell("id").unwrap_or_default() as usize;
            let place =
                number.checked_sub(1).and_then(|row| Some((states.get_mut(row)?, task.grains.get(row)?)));
            let (state, grain) =
                place.ok_or_else(|| bad(format!("step {step}: no grain has the number {number}")))?;
            *state = Some(before_the_kick(grain, task.step, cell));
        }
        let states: Option<Vec<State>> = states.into_iter().collect();
        snapshots.insert(step, states.ok_or_else(|| bad(format!("step {step}: grains are missing")))?);
    }
    (1..=task.samples)
        .map(|sample| {
            let step = u64::from(sample) * u64::from(task.steps_per_sample);
            snapshots.remove(&step).ok_or_else(|| bad(format!("step {step} is missing")))
        })
        .collect()
}

/// The state half a flight and, in velocity Verlet, half a kick earlier: that of this program at the sample.
fn before_the_kick(grain: &Sphere, step: f64, cell: impl Fn(&str) -> Option<f64>) -> State {
    let vector = |names: [&str; 3]| names.map(|name| cell(name).unwrap_or_default()).into();
    let mass = grain.density * volume::<3>(grain.radius, 1.0);
    let velocity: Vector<3> = vector(["vx", "vy", "vz"]);
    let force: Vector<3> = vector(["fx", "fy", "fz"]);
    let spin: Spin = vector(["omegax", "omegay", "omegaz"]);
    let torque: Spin = vector(["tqx", "tqy", "tqz"]);
    let place: Vector<3> = vector(["x", "y", "z"]);
    let velocity = velocity - force * (0.5 * step / mass);
    State {
        centre: place - velocity * (0.5 * step),
        velocity,
        angular_velocity: spin - torque * (0.5 * step / inertia::<3>(mass, grain.radius)),
    }
}

/// Reads [`MEANS`], and [`WALLS`] where there are walls.
///
/// # Errors
/// A file that is missing or is not what the deck asks for.
pub fn statistics(folder: &Path, task: &Task) -> Result<Statistics, PeerError> {
    let means = columns(&folder.join(MEANS), 5, task)?;
    let [count, x, y, z, kinetic_energy]: [Vec<f64>; 5] = means.try_into().unwrap_or_default();
    let walls = task.walls.len();
    let forces = if walls > 0 { columns(&folder.join(WALLS), 3 * walls, task)? } else { vec![] };
    let on_walls = forces.chunks_exact(3).map(|force| [force[0].clone(), force[1].clone(), force[2].clone()]);
    Ok(Statistics { count, centre: [x, y, z], kinetic_energy, on_walls: on_walls.collect() })
}

/// The columns behind the step, at the samples after the start.
fn columns(path: &Path, count: usize, task: &Task) -> Result<Vec<Vec<f64>>, PeerError> {
    let bad = |problem: String| PeerError::BadResult {
        path: path.to_path_buf(),
        problem,
        expected: format!("{count} numbers at each of {} samples", task.samples),
    };
    let mut rows = BTreeMap::new();
    for line in read(path)?.lines().filter(|line| !line.starts_with('#')) {
        let values = row(line).filter(|values| values.len() == count + 1);
        let values = values.ok_or_else(|| bad(format!("{line:?} is not a row of finite numbers")))?;
        rows.insert(values[0] as u64, values);
    }
    let mut columns = vec![Vec::new(); count];
    for sample in 1..=task.samples {
        let step = u64::from(sample) * u64::from(task.steps_per_sample);
        let row = rows.get(&step).ok_or_else(|| bad(format!("step {step} is missing")))?;
        columns.iter_mut().zip(&row[1..]).for_each(|(column, value)| column.push(*value));
    }
    Ok(columns)
}

fn read(path: &Path) -> Result<String, PeerError> {
    Ok(fs::read_to_string(path).map_err(OutputError::system("read", path))?)
}

/// The numbers of a line, if all are finite.
fn row(line: &str) -> Option<Vec<f64>> {
    line.split_whitespace().map(|word| word.parse().ok().filter(|value: &f64| value.is_finite())).collect()
}
