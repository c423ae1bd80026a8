//! Disk, shared memory, executables.

use crate::ending::{Ending, coupler, ending};
use crate::scene::Scene;
use crate::support::{COUPLER, DEM, FLUID};
use std::fs;
use std::os::unix::fs::symlink;
use std::process::Command;

#[test]
fn an_output_folder_that_cannot_be_made_is_refused() {
    // Permissions do not hold back root: a file stands where a folder should, and /proc takes none.
    let scene = Scene::coupled();
    scene.folder.write("file", "");
    for out in ["file", "file/out", "/proc/silt-out"] {
        coupler(&scene.folder, &["run", "case", "--out", out])
            .assert_line(5, &["cannot create ", out, "check the path, its permissions and the free space"]);
    }
    assert_eq!(fs::read_to_string(scene.folder.join("file")).unwrap(), "");
}

#[test]
fn a_long_path_of_temporary_files_harms_nothing() {
    let scene = Scene::coupled();
    let long = scene.folder.join(&"t".repeat(150));
    fs::create_dir(&long).unwrap();
    for arguments in [&["check", "case"][..], &["run", "case", "--out", "out"]] {
        let mut command = Command::new(COUPLER);
        command.args(arguments).env("TMPDIR", &long);
        let ending = ending(&scene.folder, command);
        assert_eq!((ending.code, ending.words.as_str()), (0, ""));
    }
    assert_eq!(fs::read_dir(long).unwrap().count(), 0);
}

/// `coupler` with a /dev/shm of its own of this size; what is left there afterwards is written to the file `left`.
/// None where the kernel does not permit a private mount.
fn with_shared_memory(scene: &Scene, size: &str, arguments: &str) -> Option<Ending> {
    let unshare = |script: &str| {
        let mut command = Command::new("unshare");
        command.args(["--mount", "--map-root-user", "sh", "-c", script]);
        command
    };
    let mount = format!("mount -t tmpfs -o size={size} tmpfs /dev/shm");
    let is_permitted = unshare(&mount).output().is_ok_and(|output| output.status.success());
    let script = format!("{mount} && {COUPLER} {arguments}; code=$?; ls -A /dev/shm > left; exit $code");
    is_permitted.then(|| ending(&scene.folder, unshare(&script)))
}

#[test]
fn too_little_shared_memory_is_refused_and_enough_is_not() {
    let scene = Scene::coupled();
    for size in ["16k", "64k", "256k", "1m", "1900k"] {
        for arguments in ["check case".to_string(), format!("run case --out out-{size}")] {
            let Some(ending) = with_shared_memory(&scene, size, &arguments) else {
                panic!(
                    "this machine permits no private mount namespace (`unshare --mount --map-root-user`), so that a \
                     full shared memory cannot be tried; run this test as root, or with unprivileged user namespaces"
                );
            };
            ending.assert_line(
                5,
                &["shared memory: ", "bytes are needed", " free in /dev/shm", "enlarge it", "coupler clean"],
            );
            assert_eq!(fs::read_to_string(scene.folder.join("left")).unwrap(), "", "{size}: {arguments}");
        }
    }
    let ending = with_shared_memory(&scene, "2m", "run case --out out").unwrap();
    assert_eq!((ending.code, ending.words.as_str()), (0, ""));
    assert_eq!(fs::read_to_string(scene.folder.join("left")).unwrap(), "");
}

/// Runs the case with the executables of the folder `bin`.
fn run_with_bin(scene: &Scene) -> Ending {
    coupler(&scene.folder, &["run", "case", "--out", "out", "--bin-dir", "bin"])
}

/// Puts an executable of these bytes into the folder `bin`. Another process writes it: what this one holds open for
/// writing when a neighbouring test forks could not be started.
fn install(scene: &Scene, name: &str, bytes: &[u8]) {
    let (source, target) = (scene.folder.join("bytes"), scene.folder.join("bin").join(name));
    fs::write(&source, bytes).unwrap();
    let status = Command::new("install").args(["-D", "-m", "755"]).args([source, target]).status().unwrap();
    assert!(status.success());
}

#[test]
fn a_coupler_without_its_solvers_says_which_is_missing() {
    let scene = Scene::coupled();
    install(&scene, "coupler", &fs::read(COUPLER).unwrap());
    let alone = scene.folder.join("bin/coupler");
    let parts = ["bin/dem-solver: there is no such executable", "cargo build --release", "--bin-dir"];
    for arguments in [&["check", "case"][..], &["run", "case", "--out", "out"]] {
        let mut command = Command::new(&alone);
        command.args(arguments);
        ending(&scene.folder, command).assert_line(5, &parts);
    }
    symlink(DEM, scene.folder.join("bin/dem-solver")).unwrap();
    let mut command = Command::new(&alone);
    command.args(["check", "case"]);
    ending(&scene.folder, command).assert_line(5, &["bin/fluid-solver: there is no such executable"]);
}

#[test]
fn a_solver_that_cannot_be_started_or_is_none_is_told() {
    let scene = Scene::coupled();
    scene.folder.write("bin/dem-solver", "no program");
    symlink(FLUID, scene.folder.join("bin/fluid-solver")).unwrap();
    run_with_bin(&scene).assert_line(5, &["bin/dem-solver: cannot be started: ", "check its permissions"]);

    let scene = Scene::coupled();
    install(&scene, "dem-solver", b"#!/bin/sh\nexit 0\n");
    symlink(FLUID, scene.folder.join("bin/fluid-solver")).unwrap();
    run_with_bin(&scene)
        .assert_line(5, &["dem-solver ended with exit status: 0 before it joined", "out/log.txt"]);
}

#[test]
fn a_solver_of_another_version_is_refused() {
    let scene = Scene::coupled();
    // The same program that thinks it is another version: the first four bytes are one constant of its code.
    let own = env!("CARGO_PKG_VERSION");
    let other = own.replacen(&own[..1], "7", 1);
    let mut bytes = fs::read(DEM).unwrap();
    for at in 0..bytes.len() - 4 {
        if bytes[at..at + 4] == own.as_bytes()[..4] {
            bytes[at..at + 4].copy_from_slice(&other.as_bytes()[..4]);
        }
    }
    install(&scene, "dem-solver", &bytes);
    symlink(FLUID, scene.folder.join("bin/fluid-solver")).unwrap();
    let version = format!("dem-solver: version differs: this program has {other}, the coupler {own}");
    run_with_bin(&scene).assert_line(5, &[&version, "use programs and a case of one version"]);
}

#[test]
fn a_solver_that_reads_another_case_is_refused() {
    let scene = Scene::coupled();
    let script = format!(
        "#!/bin/sh\nexec {FLUID} participate \"$(printf '%s' \"$2\" | sed 's/\"set\":\\[/&\"time.end=1 s\"/')\"\n"
    );
    install(&scene, "fluid-solver", script.as_bytes());
    symlink(DEM, scene.folder.join("bin/dem-solver")).unwrap();
    run_with_bin(&scene).assert_line(5, &["fluid-solver: case differs: this program has ", "the coupler "]);
}
