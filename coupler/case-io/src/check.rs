//! `check.toml`: what the run of a case must give, and how near.

mod plan;
mod table;
mod trace;
mod verdict;

use std::fs;
use std::path::Path;

use crate::document::Case;
use crate::error::CaseError;
use crate::nearest::did_you_mean;
use crate::output::series::{Series, Title};
use crate::summary::Check;
use crate::tree::{KeyPath, Source};

pub use trace::Trace;

use plan::{Planned, plan};
use table::CheckFile;
use verdict::verdict;

/// The checks of a case, with their references read.
#[derive(Clone, Debug)]
pub struct Checks {
    planned: Vec<Planned>,
    source: Source,
}

/// A column of a series file of the run: `grains.vz[m/s]` is the column `vz[m/s]` of `series/grains.csv`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Measured {
    /// Name of the file, without `.csv`.
    pub file: String,
    /// Title of the column.
    pub title: Title,
}

impl Checks {
    /// Reads `check.toml` in the case's folder, and the references it names; nothing if there is no such file.
    ///
    /// # Errors
    /// The first thing wrong, in one line: a file without a check is an error too.
    pub fn load(folder: &Path) -> Result<Option<Self>, CaseError> {
        let path = folder.join("check.toml");
        if !path.exists() {
            return Ok(None);
        }
        let unreadable =
            |error: std::io::Error| CaseError::Unreadable { path: path.clone(), problem: error.to_string() };
        let source = Source::parse(&path, &fs::read_to_string(&path).map_err(unreadable)?)?;
        let file: CheckFile = source.deserialise(KeyPath::default())?;
        if file.check.is_empty() {
            return Err(source.error(
                "check",
                "there is no check in it",
                "",
                "add a [[check]], or delete the file",
            ));
        }
        for (k, check) in file.check.iter().enumerate() {
            if file.check[..k].iter().any(|other| other.name == check.name) {
                let found = format!("\"{}\" names two checks", check.name);
                return Err(source.error(&format!("check[{k}].name"), found, "", "rename one"));
            }
        }
        let planned: Result<_, _> =
            file.check.into_iter().enumerate().map(|(k, check)| plan(check, k, folder, &source)).collect();
        Ok(Some(Self { planned: planned?, source }))
    }

    /// The checks of one run of a sweep: those that name it, and those that name none.
    ///
    /// # Errors
    /// A check that names a run which the case does not have, and so would never be held.
    pub fn of(mut self, case: &Case) -> Result<Self, CaseError> {
        let runs: Vec<&str> = case.document.run.iter().map(|run| run.name.as_str()).collect();
        for (k, check) in self.planned.iter().enumerate() {
            if let Some(run) = check.run.as_deref().filter(|run| !runs.contains(run)) {
                let found = format!("there is no run \"{run}\" in {}", case.name);
                let near = did_you_mean(run, &runs);
                return Err(self.source.error(&format!("check[{k}].run"), found, runs.join(", "), near));
            }
        }
        self.planned.retain(|check| check.run.is_none() || check.run == case.run);
        Ok(self)
    }

    /// Holds what was `measured` against every reference. A check whose quantity is not there, or is not finite,
    /// fails and says why.
    pub fn evaluate(&self, measured: impl Fn(&Measured) -> Result<Trace, String>) -> Vec<Check> {
        self.planned.iter().map(|check| verdict(check, measured(&check.measured))).collect()
    }

    /// As [`Checks::evaluate`], with what a run left in `directory`.
    pub fn evaluate_run(&self, directory: &Path) -> Vec<Check> {
        self.evaluate(|measured| {
            let path = directory.join("series").join(format!("{}.csv", measured.file));
            let series = Series::read_of_run(&path).map_err(|error| error.to_string())?;
            Trace::of(&series, &measured.title).map_err(|problem| format!("{}: {problem}", path.display()))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::fixture::{Folder, SETTLING};
    use crate::output::test_directory::TestDirectory;

    const CHECK: &str = r#"[[check]]
name = "terminal velocity"
quantity = "grains.vz[m/s]"
take = "last"
reference = -0.5
tolerance = 1e-2
why = "Stokes 1851"
"#;

    /// The checks of this text; the folder holds `reference.csv` (v = 1 − t) and a run (v = −t).
    fn load(text: &str) -> (TestDirectory, Result<Option<Checks>, CaseError>) {
        let folder = TestDirectory::new();
        fs::write(folder.path("check.toml"), text).unwrap();
        fs::write(folder.path("reference.csv"), "t[s],vz[m/s],x[m]\n0,0,1\n0.25,-0.25,2\n0.5,-0.5,3\n")
            .unwrap();
        fs::create_dir(folder.path("series")).unwrap();
        fs::write(folder.path("series/grains.csv"), "time[s],vz[m/s]\n0,0\n0.5,-0.5\n1,-1.1\n").unwrap();
        let checks = Checks::load(folder.root());
        (folder, checks)
    }

    fn refusal(from: &str, to: &str) -> String {
        assert!(CHECK.contains(from), "{from}");
        let (folder, checks) = load(&CHECK.replacen(from, to, 1));
        checks.unwrap_err().to_string().replace(&format!("{}/", folder.root().display()), "")
    }

    fn held(from: &str, to: &str) -> Check {
        assert!(CHECK.contains(from), "{from}");
        let (folder, checks) = load(&CHECK.replacen(from, to, 1));
        checks.unwrap().unwrap().evaluate_run(folder.root()).remove(0)
    }

    #[test]
    fn a_case_without_the_file_has_no_checks_and_an_empty_file_is_refused() {
        assert!(Checks::load(TestDirectory::new().root()).unwrap().is_none());
        for text in ["", "# nothing yet\n", "check = []\n"] {
            let (_folder, checks) = load(text);
            assert!(checks.unwrap_err().to_string().ends_with(
                "check.toml:1: check: there is no check in it; add a [[check]], or delete the file"
            ));
        }
    }

    #[test]
    fn a_check_that_cannot_be_held_is_refused() {
        let column = |column: &str, time: &str| {
            format!(
                "reference = {{ file = \"reference.csv\", column = \"{column}\", time-column = \"{time}\" }}"
            )
        };
        let absent = "reference = { file = \"absent.csv\", column = \"v[m/s]\", time-column = \"t[s]\" }";
        for (from, to, message) in [
            (
                "take = \"last\"",
                "take = \"lats\"",
                "check.toml:4: check[0].take: unknown take \"lats\"; allowed: last, max, min, mean, abs-max, error-l2, error-max; did you mean \"last\"?",
            ),
            (
                "take = \"last\"",
                "takes = \"last\"",
                "check.toml:4: check[0].takes: unknown key; allowed: run, name, quantity, take, from, to, reference, tolerance, absolute-tolerance, why; did you mean \"take\"?",
            ),
            (
                "\"grains.vz[m/s]\"",
                "\"vz\"",
                "check.toml:3: check[0].quantity: found \"vz\"; allowed: FILE.NAME[UNIT], for example \"grains.vz[m/s]\"",
            ),
            (
                "\"grains.vz[m/s]\"",
                "\"../x.vz[m/s]\"",
                "check.toml:3: check[0].quantity: found \"../x.vz[m/s]\"; allowed: FILE.NAME[UNIT], for example \"grains.vz[m/s]\"",
            ),
            (
                "why = \"Stokes 1851\"",
                "why = \" \"",
                "check.toml:7: check[0].why: is empty; allowed: the source of the reference",
            ),
            ("why = \"Stokes 1851\"", "", "check.toml:1: check[0].why: missing; add it to check[0]"),
            (
                "reference = -0.5",
                "reference = \"-0.5 m/s\"",
                "check.toml:5: check[0].reference: found the string \"-0.5 m/s\"; allowed: a number in the unit of the quantity, or { file, column, time-column }",
            ),
            (
                "reference = -0.5",
                "reference = nan",
                "check.toml:5: check[0].reference: found NaN; allowed: finite numbers",
            ),
            (
                "reference = -0.5",
                "reference = 0",
                "check.toml:6: check[0].tolerance: a fraction of the reference 0 allows nothing; allowed: absolute-tolerance",
            ),
            (
                "tolerance = 1e-2",
                "",
                "check.toml:1: check[0]: how near is not stated once; allowed: exactly one of tolerance, absolute-tolerance",
            ),
            (
                "tolerance = 1e-2",
                "tolerance = 1\nabsolute-tolerance = 1",
                "check.toml:1: check[0]: how near is not stated once; allowed: exactly one of tolerance, absolute-tolerance",
            ),
            (
                "tolerance = 1e-2",
                "tolerance = -1e-2",
                "check.toml:6: check[0].tolerance: found -0.01; allowed: 0 or more",
            ),
            (
                "take = \"last\"",
                "take = \"error-l2\"",
                "check.toml:5: check[0].reference: an error over time needs a column; allowed: { file, column, time-column }",
            ),
            (
                "take =",
                "from = \"2 s\"\nto = \"1 s\"\ntake =",
                "check.toml:5: check[0].to: found 1 s; allowed: from 2 s on",
            ),
            (
                "reference = -0.5",
                absent,
                "check.toml:5: check[0].reference.file: cannot read absent.csv: No such file or directory (os error 2); check the path, its permissions and the free space",
            ),
            (
                "reference = -0.5",
                &column("x[m]", "t[s]"),
                "check.toml:5: check[0].reference.column: found the unit m, not m/s",
            ),
            (
                "reference = -0.5",
                &column("vx[m/s]", "t[s]"),
                "check.toml:5: check[0].reference.column: there is no column vx[m/s]; allowed: t[s], vz[m/s], x[m]; did you mean \"vz[m/s]\"?",
            ),
            (
                "reference = -0.5",
                &column("vz[m/s]", "time[s]"),
                "check.toml:5: check[0].reference.time-column: there is no column time[s]; allowed: t[s], vz[m/s], x[m]",
            ),
            (
                "reference = -0.5",
                &column("vz", "t[s]"),
                "check.toml:5: check[0].reference.column: found \"vz\"; allowed: NAME[UNIT], for example \"t[s]\"",
            ),
        ] {
            assert_eq!(refusal(from, to), message);
        }
        let (_folder, twice) = load(&format!("{CHECK}{CHECK}"));
        assert!(
            twice
                .unwrap_err()
                .to_string()
                .ends_with("check.toml:9: check[1].name: \"terminal velocity\" names two checks; rename one")
        );
    }

    #[test]
    fn a_check_passes_within_its_tolerance_and_not_beyond() {
        let last = held("", "");
        assert_eq!((last.value, last.reference, last.tolerance, last.pass), (-1.1, -0.5, 0.005, false));
        assert_eq!(last.why, "Stokes 1851");
        let at_half = held("take =", "to = \"0.5 s\"\ntake =");
        assert_eq!((at_half.value, at_half.pass), (-0.5, true));
        assert!(held("tolerance = 1e-2", "absolute-tolerance = 0.61").pass);
        assert!(!held("tolerance = 1e-2", "absolute-tolerance = 0.59").pass);
        assert!(held("reference = -0.5\ntolerance = 1e-2", "reference = -1.1\ntolerance = 0").pass);
    }

    #[test]
    fn every_take_takes_what_it_says() {
        let value = |take: &str| held("\"last\"", &format!("\"{take}\"")).value;
        assert_eq!((value("last"), value("max"), value("min"), value("abs-max")), (-1.1, 0.0, -1.1, 1.1));
        assert!((value("mean") - -0.525).abs() < 1e-15);
    }

    #[test]
    fn an_error_is_relative_to_the_reference() {
        let column = |file: &str| {
            format!("reference = {{ file = \"{file}\", column = \"vz[m/s]\", time-column = \"t[s]\" }}")
        };
        let error = |take: &str, run: &str| {
            let text = CHECK
                .replace("reference = -0.5", &column("reference.csv"))
                .replace("\"last\"", &format!("\"{take}\""));
            let (folder, checks) = load(&text);
            fs::write(folder.path("series/grains.csv"), run).unwrap();
            checks.unwrap().unwrap().evaluate_run(folder.root()).remove(0)
        };
        let exact = "time[s],vz[m/s]\n0,0\n1,-1\n";
        for take in ["error-l2", "error-max"] {
            let check = error(take, exact);
            assert_eq!((check.value, check.reference, check.pass), (0.0, 0.0, true));
            // 2 % too fast everywhere: the bound is 1 % of the reference's own norm.
            let check = error(take, "time[s],vz[m/s]\n0,0\n1,-1.02\n");
            assert!((check.value / check.tolerance - 2.0).abs() < 1e-12 && !check.pass);
            assert!(error(take, "time[s],vz[m/s]\n0,0\n1,-1.009\n").pass);
        }
        let infinite = error("error-max", "time[s],vz[m/s]\n0,0\n1,-inf\n");
        assert!(!infinite.pass);
        let reduced = error("min", exact);
        assert_eq!((reduced.value, reduced.reference), (-1.0, -0.5));
        let early = error("error-max", "time[s],vz[m/s]\n0,0\n0.3,-0.3\n");
        assert!(!early.pass && early.value.is_nan());
        assert_eq!(early.why, "the reference has a row at 0.5 s, the run goes from 0 s to 0.3 s");
    }

    #[test]
    fn a_check_of_one_run_is_held_against_that_run() {
        let sweep = format!("{SETTLING}[[run]]\nname = \"coarse\"\n[[run]]\nname = \"fine\"\n");
        let cases = Folder::new(&sweep).load(&[], None).unwrap();
        let text = format!(
            "{CHECK}{}",
            CHECK.replace("name = \"terminal velocity\"", "name = \"other\"\nrun = \"fine\"")
        );
        let (folder, checks) = load(&text);
        let checks = checks.unwrap().unwrap();
        let names = |case| {
            let verdicts = checks.clone().of(case).unwrap().evaluate_run(folder.root());
            verdicts.into_iter().map(|check| check.name).collect::<Vec<_>>()
        };
        assert_eq!(names(&cases[0]), ["terminal velocity"]);
        assert_eq!(names(&cases[1]), ["terminal velocity", "other"]);
        let (_folder, checks) = load(&text.replace("\"fine\"", "\"fin\""));
        let message = checks.unwrap().unwrap().of(&cases[0]).unwrap_err().to_string();
        assert!(
            message.ends_with("check.toml:10: check[1].run: there is no run \"fin\" in settling; allowed: coarse, fine; did you mean \"fine\"?"),
            "{message}"
        );
    }

    #[test]
    fn what_was_not_measured_fails_and_says_why() {
        let (folder, checks) = load(CHECK);
        let checks = checks.unwrap().unwrap();
        let why = |content: Option<&str>| {
            let path = folder.path("series/grains.csv");
            content.map_or_else(
                || fs::remove_file(&path).unwrap(),
                |content| fs::write(&path, content).unwrap(),
            );
            let check = checks.evaluate_run(folder.root()).remove(0);
            assert!(!check.pass);
            check.why.replace(&format!("{}/", folder.root().display()), "")
        };
        assert_eq!(
            why(Some("time[s],vx[m/s]\n0,1\n")),
            "series/grains.csv: there is no column vz[m/s]; allowed: time[s], vx[m/s]; did you mean \"vx[m/s]\"?"
        );
        assert_eq!(why(Some("time[s],vz[m/s]\n")), "series/grains.csv: there are no rows");
        assert_eq!(why(Some("time[s],vz[m/s]\n0,NaN\n")), "Stokes 1851");
        assert!(why(None).contains("cannot read series/grains.csv"));
    }
}
