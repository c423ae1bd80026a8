//! The runs and variants of a case: which changes are applied.

use std::collections::BTreeMap;

use super::validate::{check_name, check_run_name};
use super::{Run, Variant};
use crate::error::CaseError;
use crate::nearest::did_you_mean;
use crate::tree::{KeyPath, Source};

/// A run: its name and the path of its changes; neither if the case is no sweep.
pub(super) struct Planned {
    pub run: Option<String>,
    pub set: Option<KeyPath>,
}

/// The runs of the case, at least one.
pub(super) fn runs(source: &Source) -> Result<Vec<Planned>, CaseError> {
    if !source.has("run") {
        return Ok(vec![Planned { run: None, set: None }]);
    }
    let runs: Vec<Run> = source.deserialise(key("run"))?;
    if runs.is_empty() {
        return Err(source.error("run", "there is no run in it", "", "delete it, or write [[run]] tables"));
    }
    for (index, run) in runs.iter().enumerate() {
        let name = format!("run[{index}].name");
        check_run_name(source, &name, &run.name)?;
        if runs[..index].iter().any(|other| other.name == run.name) {
            return Err(source.error(
                &name,
                format_args!("\"{}\" names two runs", run.name),
                "",
                "rename one",
            ));
        }
    }
    let planned = |(index, run): (usize, Run)| Planned {
        run: Some(run.name),
        set: Some(key(&format!("run[{index}].set"))),
    };
    Ok(runs.into_iter().enumerate().map(planned).collect())
}

/// Path of the changes of the chosen variant.
pub(super) fn variant(source: &Source, chosen: Option<&str>) -> Result<Option<KeyPath>, CaseError> {
    let variants: BTreeMap<String, Variant> =
        if source.has("variants") { source.deserialise(key("variants"))? } else { BTreeMap::new() };
    for name in variants.keys() {
        check_name(source, &format!("variants.{name}"), name)?;
    }
    let Some(chosen) = chosen else { return Ok(None) };
    if !variants.contains_key(chosen) {
        let known: Vec<&str> = variants.keys().map(String::as_str).collect();
        let near = did_you_mean(chosen, &known);
        return Err(CaseError::CommandLine {
            flag: format!("--variant {chosen}"),
            problem: match known.as_slice() {
                [] => format!("{} has no variants; leave the flag out", source.file.display()),
                known => format!(
                    "{} has no such variant; allowed: {}; {near}",
                    source.file.display(),
                    known.join(", ")
                )
                .trim_end_matches("; ")
                .into(),
            },
        });
    }
    Ok(Some(key(&format!("variants.{chosen}.set"))))
}

fn key(text: &str) -> KeyPath {
    KeyPath::parse(text).expect("a name is checked before it becomes part of a path")
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{Folder, SETTLING};

    #[test]
    fn runs_have_names_of_folders_each_once() {
        for (run, message) in [
            (
                "[[run]]\nname = \"a\"\n[[run]]\nname = \"a\"",
                "settling/case.toml:47: run[1].name: \"a\" names two runs; rename one",
            ),
            (
                "[[run]]\nname = \"../a\"",
                "settling/case.toml:45: run[0].name: found the name \"../a\"; allowed: letters, digits, -, _ and, not at the start, .",
            ),
            (
                "[[run]]\nname = \"a/b\"",
                "settling/case.toml:45: run[0].name: found the name \"a/b\"; allowed: letters, digits, -, _ and, not at the start, .",
            ),
            ("[[run]]\nset = {}", "settling/case.toml:44: run[0].name: missing; add it to run[0]"),
            (
                "[[run]]\nname = \"a\"\nset = 1",
                "settling/case.toml:46: run[0].set: found 1; allowed: a table: { … } or [ ]",
            ),
            (
                "[variants.a]\nsets = {}",
                "settling/case.toml:45: variants.a.sets: unknown key; allowed: set; did you mean \"set\"?",
            ),
        ] {
            assert_eq!(Folder::new(&format!("{SETTLING}{run}\n")).refusal(&[], None), message);
        }
        let sound = Folder::new(&format!("{SETTLING}[[run]]\nname = \"h1.5\"\n"));
        assert_eq!(sound.load(&[], None).unwrap()[0].run.as_deref(), Some("h1.5"));
        let empty = format!("run = []\n{SETTLING}");
        assert_eq!(
            Folder::new(&empty).refusal(&[], None),
            "settling/case.toml:1: run: there is no run in it; delete it, or write [[run]] tables"
        );
    }
}
