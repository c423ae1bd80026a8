//! What LIGGGHTS and LAMMPS share: the data file of the grains, and the commands that both understand.

use std::fmt::Write;

use super::task::{Recording, Task};
use super::{File, results};
use crate::vector::{Spin, Vector};

/// Name of the data file.
const NAME: &str = "grains.data";

/// The grains. A free one has half a kick of gravity already: it starts half a step late, see
/// [`Task::first_place`], and velocity Verlet gives the other half.
pub fn grains(task: &Task) -> File {
    let (lower, upper) = ends(task);
    let mut text = String::from("grains half a step after the start\n\n");
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{} atoms\n{} atom types\n", task.grains.len(), task.scene.materials.len());
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let _ = writeln!(text, "{} {} {name}lo {name}hi", lower[axis], upper[axis]);
    }
    text += "\nAtoms\n\n";
    for (row, grain) in task.grains.iter().enumerate() {
        let (place, number, kind) = (task.first_place(grain), row + 1, grain.material + 1);
        let (diameter, density) = (2.0 * grain.radius, grain.density);
        let _ = writeln!(text, "{number} {kind} {diameter} {density} {}", numbers(&place));
    }
    text += "\nVelocities\n\n";
    let half_kick = task.scene.gravity * (0.5 * task.step);
    for (row, grain) in task.grains.iter().enumerate() {
        let velocity = if grain.frozen { grain.velocity } else { grain.velocity + half_kick };
        let _ = writeln!(text, "{} {} {}", row + 1, numbers(&velocity), numbers(&grain.angular_velocity));
    }
    File::new(NAME, text)
}

/// Units, ends of the box, the grains, and how neighbours are found.
pub fn opening(task: &Task, atom_style: &str, keep_velocities: &str) -> Vec<String> {
    let ends = [0, 1, 2].map(|axis| match task.scene.domain.periodic[axis] {
        true => "p",
        // Grains that leave are lost, as they are to be.
        false if task.removes() => "f",
        // The box grows with the grains.
        false => "m",
    });
    vec![
        "units si".into(),
        format!("atom_style {atom_style}"),
        "atom_modify map array".into(),
        format!("boundary {}", ends.join(" ")),
        "newton off".into(),
        keep_velocities.into(),
        format!("read_data {NAME}"),
        format!("neighbor {} bin", 0.5 * task.largest_radius()),
        "neigh_modify delay 0".into(),
    ]
}

/// Gravity, frozen grains, integration.
pub fn motion(task: &Task) -> Vec<String> {
    let mut lines = Vec::new();
    let gravity = task.scene.gravity;
    if gravity != Spin::zeros() {
        let size = gravity.norm();
        lines.push(format!("fix gravity all gravity {size} vector {}", numbers(&(gravity / size))));
    }
    let frozen = frozen_ranges(task);
    for ranges in frozen.chunks(20) {
        lines.push(format!("group frozen id {}", ranges.join(" ")));
    }
    if frozen.is_empty() {
        lines.push("group free union all".into());
    } else {
        lines.push("fix freeze frozen freeze".into());
        lines.push("group free subtract all frozen".into());
    }
    lines.push("fix integrate free nve/sphere".into());
    lines
}

/// Numbers of the frozen grains, as ranges.
fn frozen_ranges(task: &Task) -> Vec<String> {
    let mut ranges: Vec<(usize, usize)> = Vec::new();
    for (row, _) in task.grains.iter().enumerate().filter(|(_, grain)| grain.frozen) {
        match ranges.last_mut() {
            Some((_, last)) if *last == row => *last = row + 1,
            _ => ranges.push((row + 1, row + 1)),
        }
    }
    ranges.into_iter().map(|(first, last)| format!("{first}:{last}")).collect()
}

/// What is written at the samples, and the run; `on_walls` are three components of the force on each wall, as the
/// program calls them.
pub fn run(task: &Task, recording: Option<Recording>, on_walls: &[String]) -> Vec<String> {
    let every = task.steps_per_sample;
    let mut lines = vec!["thermo 1000000000".into(), "thermo_modify lost ignore norm no".into()];
    match recording {
        None => {}
        Some(Recording::Trajectories) => {
            // So LIGGGHTS takes it, which alone is asked for trajectories.
            let format = ["%d"].into_iter().chain(["%.17g"; 15]).collect::<Vec<_>>().join(" ");
            lines.push(format!(
                "dump grains all custom {every} {} id x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz",
                results::TRAJECTORIES
            ));
            lines.push(format!("dump_modify grains sort id format \"{format}\""));
        }
        Some(Recording::Statistics) => {
            lines.push("compute place all reduce ave x y z".into());
            lines.push("compute linear all ke".into());
            lines.push("compute angular all erotate/sphere".into());
            lines.push("variable count equal count(all)".into());
            lines.push("variable energy equal c_linear+c_angular".into());
            lines.push(format!(
                "fix means all ave/time {every} 1 {every} v_count c_place[1] c_place[2] c_place[3] v_energy file {}",
                results::MEANS
            ));
            if !on_walls.is_empty() {
                lines.push(format!(
                    "fix walls all ave/time 1 {every} {every} {} file {}",
                    on_walls.join(" "),
                    results::WALLS
                ));
            }
        }
    }
    lines.push(format!("run {}", task.steps()));
    lines
}

/// Corners of the box: of the domain where it wraps or ends there, else of all there is, with room.
fn ends(task: &Task) -> (Vector<3>, Vector<3>) {
    let domain = &task.scene.domain;
    let (lower, upper) = task.extent();
    let room = 2.0 * task.largest_radius();
    let is_fixed = |axis: usize| domain.periodic[axis] || task.removes();
    let pick = |axis: usize, fixed: f64, free: f64| if is_fixed(axis) { fixed } else { free };
    (
        Vector::from_fn(|axis, _| pick(axis, domain.lower[axis], lower[axis] - room)),
        Vector::from_fn(|axis, _| pick(axis, domain.upper[axis], upper[axis] + room)),
    )
}

/// The components of a vector, with blanks between.
pub fn numbers(vector: &Vector<3>) -> String {
    format!("{} {} {}", vector.x, vector.y, vector.z)
}
