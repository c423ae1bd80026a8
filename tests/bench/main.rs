//! `dem-solver bench` on few grains: what its table claims to hold is there.

#[path = "../support/mod.rs"]
mod support;

use std::process::Command;

use support::{DEM, Folder};

#[test]
fn every_scene_asked_for_has_a_row_of_positive_rates() {
    let folder = Folder::new();
    let out = folder.join("bench.csv");
    let mut command = Command::new(DEM);
    command.args(["bench", "gas", "dense", "loose", "--grains", "300", "--runs", "1", "--out"]).arg(&out);
    // States that others keep are left alone.
    let output = command.env("TMPDIR", folder.join("")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(&out).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    let starts: Vec<&[&str]> = rows.iter().map(|row| &row[..3]).collect();
    assert_eq!(
        starts,
        [
            ["scene", "grains", "steps"],
            ["gas", "300", "800"],
            ["dense", "300", "2000"],
            ["loose", "300", "400"]
        ]
    );
    for row in &rows[1..] {
        assert_eq!(row.len(), rows[0].len());
        assert!(row[9].parse::<f64>().unwrap() > 300.0, "a step moves places, motions and loads: {row:?}");
        assert!(row[4..8].iter().all(|rate| rate.parse::<f64>().unwrap() > 0.0), "{row:?}");
    }
}
