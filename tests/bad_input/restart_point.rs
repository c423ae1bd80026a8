//! Restart points that were damaged after they were written, or written by another program.

use crate::ending::{Ending, coupler};
use crate::refusal::run;
use crate::scene::Scene;
use crate::support::assert_same_results;
use case_io::checkpoint::RestartPoint;
use std::fs;
use std::path::PathBuf;

/// A run that a fault ended, with its two restart points, the older first.
fn stopped_run(scene: &Scene) -> [PathBuf; 2] {
    let ended = run(scene, &[]);
    assert_eq!((ended.code, ended.words.as_str()), (0, ""));
    let mut points: Vec<PathBuf> =
        fs::read_dir(scene.folder.join("out/restart")).unwrap().flatten().map(|entry| entry.path()).collect();
    let window = |path: &PathBuf| -> u64 {
        path.file_name().unwrap().to_string_lossy().trim_start_matches("window-").parse().unwrap()
    };
    points.sort_by_key(window);
    points.try_into().unwrap()
}

fn resume(scene: &Scene) -> Ending {
    coupler(&scene.folder, &["resume", "out"])
}

fn flip_a_byte(path: PathBuf) {
    let mut bytes = fs::read(&path).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(path, bytes).unwrap();
}

#[test]
fn of_a_damaged_point_and_a_whole_one_the_whole_one_is_used() {
    for part in ["dem-solver", "fluid-solver", "coupler", "manifest.json"] {
        let scene = Scene::coupled();
        let [_, newer] = stopped_run(&scene);
        let through = Scene::coupled();
        stopped_run(&through);
        flip_a_byte(newer.join(part));
        let resumed = resume(&scene);
        assert_eq!(resumed.code, 0, "{part}: {}", resumed.words);
        assert_same_results(&through.folder.join("out"), &scene.folder.join("out"));
    }
}

#[test]
fn with_no_whole_point_left_it_says_what_is_wrong_with_each() {
    let scene = Scene::coupled();
    let [older, newer] = stopped_run(&scene);
    flip_a_byte(newer.join("dem-solver"));
    fs::remove_file(older.join("fluid-solver")).unwrap();
    let ending = resume(&scene);
    ending.assert_line(
        5,
        &[
            "out: no complete restart point",
            "\"dem-solver\"",
            "checksum",
            "fluid-solver",
            "start again with `coupler run`",
        ],
    );
}

#[test]
fn a_point_that_another_version_has_written_is_refused() {
    let scene = Scene::coupled();
    let [_, newer] = stopped_run(&scene);
    let parts = ["dem-solver", "fluid-solver", "coupler"];
    let foreign = RestartPoint::begin(&scene.folder.join("out/restart"), 1000).unwrap();
    for part in parts {
        fs::copy(newer.join(part), foreign.part(part)).unwrap();
    }
    foreign.commit(0.02, 0.002, "of another time", "0.0.7", &parts).unwrap();
    let own = format!("this program is version {}", env!("CARGO_PKG_VERSION"));
    let found = ["out/restart/window-1000: ", "written by version 0.0.7", &own, "resume with version 0.0.7"];
    resume(&scene).assert_line(2, &found);
}
