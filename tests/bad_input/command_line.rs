//! The command line.

use crate::ending::{coupler, ending};
use crate::refusal::run;
use crate::scene::Scene;
use crate::support::{DEM, FLUID, Folder};
use std::process::Command;

#[test]
fn an_unknown_subcommand_is_refused_with_all_known() {
    let ending = coupler(&Folder::new(), &["rnu", "case"]);
    ending.assert_line(
        2,
        &["unrecognized subcommand 'rnu'", "allowed: run, resume, check, plan, explain, clean"],
    );
}

#[test]
fn an_unknown_or_incomplete_flag_is_refused() {
    let folder = Folder::new();
    for (arguments, parts) in [
        (&["run", "case", "--ot", "x"][..], &["unexpected argument '--ot'", "see --help"][..]),
        (&["run", "case", "--out"], &["--out <DIR>"]),
        (&["run"], &["<CASE>"]),
        (&["run", "case", "--threads", "many"], &["'many'", "--threads", "invalid digit"]),
    ] {
        coupler(&folder, arguments).assert_line(2, parts);
    }
}

#[test]
fn the_solvers_refuse_a_command_line_in_one_line_too() {
    let folder = Folder::new();
    for (solver, tasks) in [
        (DEM, "allowed: run, export, validate, bench, stress; see --help"),
        (FLUID, "allowed: run, bench, stress; see --help"),
    ] {
        for (argument, parts) in [
            ("rnu", ["unrecognized subcommand 'rnu'", tasks]),
            ("--ot", ["unexpected argument '--ot'", "see --help"]),
        ] {
            let mut command = Command::new(solver);
            command.arg(argument);
            ending(&folder, command).assert_line(2, &parts);
        }
    }
}

#[test]
fn an_unknown_word_is_not_explained() {
    coupler(&Folder::new(), &["explain", "di-felic"])
        .assert_line(2, &["unknown word \"di-felic\"", "allowed: drag,", "di-felice", "an exit code"]);
}

#[test]
fn an_unknown_variant_is_refused() {
    let scene = Scene::coupled();
    let case = scene.path().display().to_string();
    let arguments = [vec!["check", &case], vec!["plan", &case], vec!["run", &case, "--out", "out"]];
    let refused = |parts: &[&str]| {
        for arguments in &arguments {
            coupler(&scene.folder, &[arguments, &["--variant", "ful"][..]].concat()).assert_line(2, parts);
        }
    };
    refused(&["--variant ful: ", "has no variants", "leave the flag out"]);
    let scene = scene.with("[grains]", "[variants.full.set]\n\"time.end\" = \"1 s\"\n[grains]");
    for arguments in &arguments {
        coupler(&scene.folder, &[arguments, &["--variant", "ful"][..]].concat())
            .assert_line(2, &["no such variant", "allowed: full", "did you mean \"full\"?"]);
    }
}

#[test]
fn a_wrong_change_of_a_key_is_refused() {
    for (change, code, parts) in [
        (
            "time.ende=\"1 s\"",
            3,
            &["--set time.ende: unknown key", "allowed: end,", "did you mean \"end\"?"][..],
        ),
        ("time.end=1", 3, &["--set time.end: value 1 has no unit", "write \"1 s\""]),
        ("time.end=-1 s", 3, &["--set time.end: found -1 s", "allowed: more than 0 s"]),
        (
            "time.end=\"soon\"",
            3,
            &["--set time.end: \"soon\" does not start with a finite number", "\"2.5 s\""],
        ),
        (
            "insertion[7].diameter=\"1 mm\"",
            3,
            &["--set insertion[7].diameter: there is no such entry", "insertion[1]"],
        ),
        ("time.end", 2, &["--set time.end: no \"=\" found", "write --set key=value"]),
    ] {
        let scene = Scene::coupled();
        run(&scene, &[change]).assert_line(code, parts);
        let case = scene.path().display().to_string();
        coupler(&scene.folder, &["check", &case, "--set", change]).assert_line(code, parts);
    }
}

#[test]
fn an_output_folder_that_is_not_empty_is_refused_and_left_alone() {
    let scene = Scene::coupled();
    let note = scene.folder.write("out/note.txt", "mine");
    run(&scene, &[]).assert_line(2, &["out: the folder is not empty", "name another or remove it"]);
    assert_eq!(std::fs::read_dir(scene.folder.join("out")).unwrap().count(), 1);
    assert_eq!(std::fs::read_to_string(note).unwrap(), "mine");
}

#[test]
fn a_folder_that_is_no_run_is_not_resumed() {
    let folder = Folder::new();
    folder.write("other/origin.json", "{}");
    std::fs::create_dir(folder.join("empty")).unwrap();
    for (name, found) in [("nowhere", "No such file"), ("empty", "No such file"), ("other", "missing field")]
    {
        let origin = format!("{name}/origin.json: ");
        let parts = [&origin, found, "allowed: the output folder of a run", "name one"];
        coupler(&folder, &["resume", name]).assert_line(2, &parts);
    }
}
