//! YADE 2023.02a.

use std::fmt::Write;

use case_io::document::Case;
use case_io::error::CaseError;

use super::data_file::numbers;
use super::stl::stl;
use super::task::{Recording, Task};
use super::wall::{Course, PeerWall, WallShape, square};
use super::{File, Peer};
use crate::contact::NormalLaw;
use crate::material::PairMaterial;
use crate::vector::Vector;
use crate::wall::Facet;

/// What every script does, behind the values of the case.
const SCRIPT: &str = include_str!("yade.py");

/// The program.
pub struct Yade;

impl Peer for Yade {
    fn name(&self) -> &'static str {
        "YADE"
    }

    fn executable(&self) -> &'static str {
        "yade"
    }

    fn install(&self) -> &'static str {
        "on Debian `apt-get install yade`"
    }

    fn version(&self) -> &'static str {
        "2023.02a"
    }

    fn version_question(&self) -> (&'static str, [&'static str; 2]) {
        ("--version", ["Yade version: ", "\n"])
    }

    /// Its tangential force is incremental, and its contacts never pull.
    fn computes_alike(&self, _: &NormalLaw) -> bool {
        false
    }

    fn deck(&self, case: &Case, task: &Task, recording: Option<Recording>) -> Result<Vec<File>, CaseError> {
        if !matches!(
            task.scene.normal_law,
            NormalLaw::Hertz(_) | NormalLaw::HertzPartialSlip(_) | NormalLaw::LiggghtsHertz(_)
        ) {
            let found = "YADE has no law of this stiffness and restitution";
            return Err(case.error(
                "grains.normal-law",
                found,
                "hertz, liggghts-hertz",
                "compare with liggghts",
            ));
        }
        let scene = &task.scene;
        let mut files = vec![File::new("grains.txt", grains(task))];
        let mut walls = Vec::new();
        for (index, wall) in task.walls.iter().enumerate() {
            let shape = match across_axis(wall) {
                Some((axis, position)) => format!("\"axis\": {axis}, \"position\": {position}"),
                None => {
                    let name = format!("wall-{index}.stl");
                    files.push(File::new(name.clone(), stl(&facets(task, wall))));
                    format!("\"file\": \"{name}\"")
                }
            };
            walls.push(format!(
                "{{\"material\": {}, {shape}, \"motion\": {}}}",
                wall.material,
                motion(&wall.course)
            ));
        }
        let materials = (0..scene.materials.len() as u32).map(|index| {
            let material = scene.materials.get(index);
            tuple(&[material.density, material.youngs_modulus, material.poissons_ratio])
        });
        let values = [
            ("materials", list(materials)),
            ("restitution", pairs(task, |pair| pair.restitution)),
            ("friction", pairs(task, |pair| pair.sliding_friction)),
            ("walls", list(walls)),
            ("gravity", vector(&scene.gravity)),
            ("period", period(case, task)?),
            ("limits", limits(task)),
            ("skin", (0.5 * task.largest_radius()).to_string()),
            ("step", task.step.to_string()),
            ("steps_per_sample", task.steps_per_sample.to_string()),
            ("samples", task.samples.to_string()),
            ("is_timed", if recording.is_none() { "True" } else { "False" }.into()),
        ];
        let values = values.map(|(name, value)| format!("{name} = {value}\n"));
        files.push(File::new("case.py", values.concat() + SCRIPT));
        Ok(files)
    }

    fn arguments(&self) -> &'static [&'static str] {
        &["-n", "-x", "-j1", "case.py"]
    }
}

fn grains(task: &Task) -> String {
    let mut text = String::new();
    for grain in &task.grains {
        let place = task.first_place(grain);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{} {} {} {} {} {}",
            grain.material,
            grain.radius,
            u8::from(grain.frozen),
            numbers(&place),
            numbers(&grain.velocity),
            numbers(&grain.angular_velocity)
        );
    }
    text
}

/// The axis and the place of a plane across an axis that does not turn; where it is at the first forces.
fn across_axis(wall: &PeerWall) -> Option<(usize, f64)> {
    let WallShape::Plane(plane) = &wall.shape else { return None };
    let axis = (0..3).find(|&axis| plane.normal[axis].abs() == 1.0)?;
    (wall.course == Course::Rest).then_some((axis, plane.point[axis]))
}

fn facets(task: &Task, wall: &PeerWall) -> Vec<Facet<3>> {
    let facets = match &wall.shape {
        WallShape::Plane(plane) => square(plane, task.extent()),
        WallShape::Triangles(facets) => facets.clone(),
    };
    facets.iter().map(|facet| wall.moved(facet, 0.5 * task.step)).collect()
}

fn motion(course: &Course) -> String {
    match course {
        Course::Rest => "(\"rest\",)".into(),
        Course::Translation(velocity) => {
            let speed = velocity.norm();
            format!("(\"translation\", {}, {speed})", vector(&(velocity / speed)))
        }
        Course::Rotation(point, angular_velocity) => {
            let rate = angular_velocity.norm();
            format!("(\"rotation\", {}, {}, {rate})", vector(point), vector(&(angular_velocity / rate)))
        }
        Course::Oscillation(amplitude, frequency) => {
            format!("(\"oscillation\", {}, {frequency})", vector(amplitude))
        }
    }
}

/// Lengths of the periodic cell. All its axes wrap: one that does not in the case is too long to.
fn period(case: &Case, task: &Task) -> Result<String, CaseError> {
    let domain = &task.scene.domain;
    if !domain.periodic.contains(&true) {
        return Ok("None".into());
    }
    if !task.walls.is_empty() {
        let found = "YADE's periodic cell holds no walls";
        return Err(case.error("grains.periodic", found, "", "compare with liggghts or lammps"));
    }
    let (lower, upper) = task.extent();
    let length = |axis: usize| match domain.periodic[axis] {
        true => domain.period(axis),
        false => 100.0 * (upper[axis] - lower[axis]),
    };
    Ok(tuple(&[length(0), length(1), length(2)]))
}

fn limits(task: &Task) -> String {
    let domain = &task.scene.domain;
    if task.removes() {
        format!("({}, {})", vector(&domain.lower), vector(&domain.upper))
    } else {
        "None".into()
    }
}

fn pairs(task: &Task, value: fn(&PairMaterial) -> f64) -> String {
    let count = task.scene.materials.len() as u32;
    let each = (0..count).flat_map(|a| (a..count).map(move |b| (a, b)));
    list(each.map(|(a, b)| format!("({a}, {b}, {})", value(task.scene.materials.pair(a, b)))))
}

fn list(items: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", items.into_iter().collect::<Vec<_>>().join(", "))
}

fn vector(vector: &Vector<3>) -> String {
    tuple(vector.as_slice())
}

fn tuple(numbers: &[f64]) -> String {
    format!("({})", numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(", "))
}
