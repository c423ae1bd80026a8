//! LIGGGHTS-PUBLIC 3.8.0.

use case_io::document::Case;
use case_io::error::CaseError;

use super::data_file::{self, numbers};
use super::stl::stl;
use super::task::{Recording, Task};
use super::wall::{Course, PeerWall, WallShape, square};
use super::{File, Peer};
use crate::contact::NormalLaw;
use crate::material::{Materials, PairMaterial};
use crate::wall::{Facet, Plane};

/// The program.
pub struct Liggghts;

impl Peer for Liggghts {
    fn name(&self) -> &'static str {
        "LIGGGHTS"
    }

    fn executable(&self) -> &'static str {
        "liggghts"
    }

    fn install(&self) -> &'static str {
        "on Debian `apt-get install liggghts`"
    }

    fn version(&self) -> &'static str {
        "3.8.0"
    }

    fn version_question(&self) -> (&'static str, [&'static str; 2]) {
        ("-help", ["LIGGGHTS-PUBLIC ", ","])
    }

    fn computes_alike(&self, law: &NormalLaw) -> bool {
        matches!(law, NormalLaw::LiggghtsHertz(_) | NormalLaw::LiggghtsHooke(_))
    }

    fn deck(&self, case: &Case, task: &Task, recording: Option<Recording>) -> Result<Vec<File>, CaseError> {
        refuse_values(case)?;
        let model = model(case, &task.scene.normal_law)?;
        let mut lines = data_file::opening(task, "granular", "communicate single vel yes");
        // Moduli outside of 5 MPa to 1 TPa are refused otherwise.
        lines.extend(["hard_particles yes".into(), "soft_particles yes".into()]);
        lines.extend(properties(task));
        lines.extend([
            format!("pair_style gran {model}"),
            "pair_coeff * *".into(),
            format!("timestep {}", task.step),
        ]);
        let mut files = vec![data_file::grains(task)];
        let (mut on_walls, mut meshes) = (Vec::new(), Vec::new());
        lines.extend(data_file::motion(task));
        for (index, wall) in task.walls.iter().enumerate() {
            let kind = wall.material + 1;
            match as_primitive(wall) {
                Some(primitive) => {
                    let fix =
                        format!("fix wall{index} all wall/gran {model} primitive type {kind} {primitive}");
                    if recording.is_none() {
                        lines.push(fix);
                        continue;
                    }
                    lines.push(fix + " store_force yes");
                    let on_grains = (1..=3).map(|axis| format!("f_force_wall{index}[{axis}]"));
                    let on_grains: Vec<String> = on_grains.collect();
                    lines.push(format!("compute push{index} free reduce sum {}", on_grains.join(" ")));
                    for axis in 1..=3 {
                        lines.push(format!("variable push{index}{axis} equal -c_push{index}[{axis}]"));
                        on_walls.push(format!("v_push{index}{axis}"));
                    }
                }
                None => {
                    let name = format!("wall-{index}.stl");
                    let surface = if recording.is_some() { "mesh/surface/stress" } else { "mesh/surface" };
                    lines.push(format!(
                        "fix mesh{index} all {surface} file {name} type {kind} curvature 1e-5"
                    ));
                    lines.extend(moving(index, &wall.course));
                    meshes.push(format!("mesh{index}"));
                    on_walls.extend((1..=3).map(|axis| format!("f_mesh{index}[{axis}]")));
                    files.push(File::new(name, stl(&facets(task, wall))));
                }
            }
        }
        if !meshes.is_empty() {
            let (count, meshes) = (meshes.len(), meshes.join(" "));
            lines.push(format!("fix meshes all wall/gran {model} mesh n_meshes {count} meshes {meshes}"));
        }
        lines.extend(data_file::run(task, recording, &on_walls));
        files.push(File::new("in.liggghts", lines.join("\n") + "\n"));
        Ok(files)
    }

    fn arguments(&self) -> &'static [&'static str] {
        // It reads a mesh into a crash where it has no screen.
        &["-in", "in.liggghts", "-log", "none"]
    }
}

/// What LIGGGHTS refuses, by the key.
fn refuse_values(case: &Case) -> Result<(), CaseError> {
    let document = &case.document;
    for (name, material) in &document.materials {
        if let Some(ratio) = material.poissons_ratio.filter(|&ratio| ratio < 0.0) {
            let key = format!("materials.{name}.poissons-ratio");
            return Err(case.error(&key, format_args!("found {ratio}"), "0 to 0.5 by LIGGGHTS", ""));
        }
    }
    for (name, pair) in &document.pairs {
        if pair.restitution <= 0.05 {
            let key = format!("pairs.{name}.restitution");
            let found = format!("found {}", pair.restitution);
            return Err(case.error(&key, found, "more than 0.05, at most 1 by LIGGGHTS", ""));
        }
    }
    Ok(())
}

/// The contact model; this program's own laws have in LIGGGHTS a neighbour that pulls at the end of a contact.
fn model(case: &Case, law: &NormalLaw) -> Result<&'static str, CaseError> {
    match law {
        NormalLaw::Hooke(_) | NormalLaw::LiggghtsHooke(_) => Ok("model hooke tangential history"),
        NormalLaw::Hertz(_) | NormalLaw::HertzPartialSlip(_) | NormalLaw::LiggghtsHertz(_) => {
            Ok("model hertz tangential history")
        }
        _ => {
            let allowed = "hertz, hooke, liggghts-hertz, liggghts-hooke";
            Err(case.error("grains.normal-law", "LIGGGHTS has nothing like it", allowed, ""))
        }
    }
}

fn properties(task: &Task) -> Vec<String> {
    let materials = &task.scene.materials;
    let per_type = |value: fn(&crate::Material) -> f64| {
        let values = (0..materials.len() as u32).map(|index| value(materials.get(index)).to_string());
        values.collect::<Vec<_>>().join(" ")
    };
    let mut lines = vec![
        format!("fix E all property/global youngsModulus peratomtype {}", per_type(|m| m.youngs_modulus)),
        format!("fix nu all property/global poissonsRatio peratomtype {}", per_type(|m| m.poissons_ratio)),
        per_pair("e", "coefficientRestitution", materials, |pair| pair.restitution),
        per_pair("mu", "coefficientFriction", materials, |pair| pair.sliding_friction),
    ];
    let velocity = match task.scene.normal_law {
        NormalLaw::Hooke(law) => Some(law.characteristic_velocity),
        NormalLaw::LiggghtsHooke(law) => Some(law.characteristic_velocity),
        _ => None,
    };
    lines.extend(velocity.map(|v| format!("fix V all property/global characteristicVelocity scalar {v}")));
    lines
}

fn per_pair(id: &str, property: &str, materials: &Materials, value: fn(&PairMaterial) -> f64) -> String {
    let count = materials.len() as u32;
    let values = (0..count).flat_map(|a| (0..count).map(move |b| (a, b)));
    let values: Vec<String> = values.map(|(a, b)| value(materials.pair(a, b)).to_string()).collect();
    format!("fix {id} all property/global {property} peratomtypepair {count} {}", values.join(" "))
}

/// A plane across an axis that stays where it is.
fn as_primitive(wall: &PeerWall) -> Option<String> {
    let WallShape::Plane(Plane { point, normal }) = &wall.shape else { return None };
    let axis = (0..3).find(|&axis| normal[axis].abs() == 1.0)?;
    (wall.course == Course::Rest).then(|| format!("{}plane {}", ["x", "y", "z"][axis], point[axis]))
}

/// The triangles of a wall, where it is when the first forces are found.
fn facets(task: &Task, wall: &PeerWall) -> Vec<Facet<3>> {
    let facets = match &wall.shape {
        WallShape::Plane(plane) => square(plane, task.extent()),
        WallShape::Triangles(facets) => facets.clone(),
    };
    // An oscillation starts at its middle, and cannot start elsewhere.
    let time = if matches!(wall.course, Course::Oscillation(..)) { 0.0 } else { 0.5 * task.step };
    facets.iter().map(|facet| wall.moved(facet, time)).collect()
}

fn moving(index: usize, course: &Course) -> Option<String> {
    let motion = match course {
        Course::Rest => return None,
        Course::Translation(velocity) => format!("linear {}", numbers(velocity)),
        Course::Rotation(point, angular_velocity) => {
            let (rate, period) = (angular_velocity.norm(), std::f64::consts::TAU / angular_velocity.norm());
            format!(
                "rotate origin {} axis {} period {period}",
                numbers(point),
                numbers(&(angular_velocity / rate))
            )
        }
        Course::Oscillation(amplitude, frequency) => {
            format!("wiggle amplitude {} period {}", numbers(amplitude), 1.0 / frequency)
        }
    };
    Some(format!("fix move{index} all move/mesh mesh mesh{index} {motion}"))
}
