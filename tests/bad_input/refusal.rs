//! Cases that are refused, by `check` and by `run` in the same words.

use crate::ending::{Ending, coupler};
use crate::scene::Scene;

/// The case is refused with code 3, at the line that holds `text`, for this key, in words that hold all parts.
pub fn assert_refused(scene: &Scene, text: &str, key: &str, parts: &[&str]) {
    let line = refusal(scene);
    let place = format!("{}{key}: ", scene.place(text));
    assert!(line.contains(&place), "{place:?} is not in: {line}");
    for part in parts {
        assert!(line.contains(part), "{part:?} is not in: {line}");
    }
}

/// The line with which `check` and `run` refuse the case.
pub fn refusal(scene: &Scene) -> String {
    let checked = coupler(&scene.folder, &["check", &scene.path().display().to_string()]);
    let ran = run(scene, &[]);
    assert_eq!((checked.code, ran.code), (3, 3), "{}{}", checked.words, ran.words);
    assert_eq!(checked.line(), ran.line());
    ran.line().to_string()
}

/// `coupler run` of the case into `out`, with `--set` changes.
pub fn run(scene: &Scene, changes: &[&str]) -> Ending {
    let (case, out) = (scene.path().display().to_string(), scene.folder.join("out").display().to_string());
    let mut arguments = vec!["run", &case, "--out", &out];
    arguments.extend(changes.iter().flat_map(|change| ["--set", change]));
    coupler(&scene.folder, &arguments)
}

mod tests {
    use super::*;

    #[test]
    fn the_sound_cases_are_run() {
        for scene in [Scene::coupled(), Scene::carried()] {
            let checked = coupler(&scene.folder, &["check", &scene.path().display().to_string()]);
            let ran = run(&scene, &[]);
            assert_eq!((checked.code, checked.words.as_str()), (0, ""));
            assert_eq!((ran.code, ran.words.as_str()), (0, ""));
        }
    }
}
