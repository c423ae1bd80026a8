//! `dem-solver bench` on few grains, `fluid-solver bench` on few cells: what their tables claim to hold is there.

#[path = "../support/mod.rs"]
mod support;

use std::process::Command;

use support::{DEM, FLUID, Folder};

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

#[test]
fn error_falls_with_the_cells_and_the_stages_of_a_step_add_up_to_most_of_its_time() {
    let folder = Folder::new();
    let out = folder.join("bench");
    let mut command = Command::new(FLUID);
    command.args(["bench", "taylor-green", "--cells", "8,16", "--out"]).arg(&out);
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(out.join("bench.csv")).unwrap();
    let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let number = |row: &[&str], column: usize| row[column].parse::<f64>().unwrap();
    for backend in ["eulerian", "pfem"] {
        let rows: Vec<_> = rows.iter().filter(|row| row[1] == backend).collect();
        assert_eq!(rows.len(), 6);
        for (coarse, fine) in rows[..3].iter().zip(&rows[3..]) {
            let order = (number(coarse, 5) / number(fine, 5)).log2();
            assert!(order > 1.5, "{coarse:?} {fine:?}");
        }
        for row in rows {
            let shares: Vec<f64> = (8..13).map(|column| number(row, column)).collect();
            let sum: f64 = shares.iter().sum();
            assert!((0.5..1.05).contains(&sum), "{row:?}");
            assert!(shares.iter().take(3).all(|share| (*share > 0.0) == (backend == "pfem")), "{row:?}");
        }
    }
    assert!(out.join("report.html").exists());
}

#[test]
fn the_map_of_stress_has_a_row_for_each_trial_and_water_at_rest_is_right_in_all_of_them() {
    let folder = Folder::new();
    let out = folder.join("stress");
    let mut command = Command::new(FLUID);
    command.args(["stress", "--quick", "--only", "rest", "--out"]).arg(&out);
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(out.join("stress.csv")).unwrap();
    let rows: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(rows.len(), 12, "{text}");
    for row in rows {
        let fields: Vec<&str> = row.trim_matches('"').split("\",\"").collect();
        assert_eq!(fields[2], "right", "{row}");
        let folder = format!("{}-{}", fields[0], fields[1].replace(' ', "-"));
        assert!(out.join(folder).join("case.toml").exists(), "{row}");
    }
}
