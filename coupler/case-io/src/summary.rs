//! `summary.json`: what a run was, how it ended and what it cost, for people, scripts and the report.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::exit_code::ExitCode;
use crate::output::{OutputError, read_file, replace_file};

/// The version of the layout of `summary.json` written by this crate.
pub const SCHEMA_VERSION: u32 = 1;

/// A run in one page.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Summary {
    /// Title of the case.
    pub case: String,
    /// Hash of the case as it was run.
    pub case_hash: String,
    /// Version of the program.
    pub program_version: String,
    /// How the run ended.
    pub exit: Exit,
    /// Time reached \[s\].
    #[serde(with = "number")]
    pub time: f64,
    /// Time spent, by part of the program.
    pub seconds: BTreeMap<String, Seconds>,
    /// How much work it was.
    pub counts: Counts,
    /// Peak memory of all participants together \[bytes\].
    pub peak_memory: u64,
    /// How often work was saved, by kind.
    pub thrift: BTreeMap<String, u64>,
    /// What that took away, by kind, with the unit in brackets.
    #[serde(default)]
    pub taken: BTreeMap<String, f64>,
    /// What the fluid gained and lost, by what did it, at the end; with the unit in brackets.
    #[serde(default)]
    pub audits: BTreeMap<String, f64>,
    /// The largest residual of every ledger row.
    pub ledger: BTreeMap<String, LedgerMaximum>,
    /// The case's checks.
    pub checks: Vec<Check>,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exit {
    /// The exit code.
    pub code: ExitCode,
    /// The first cause, in words.
    pub reason: String,
}

/// Time spent in one part of the program \[s\].
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Seconds {
    /// By the clock.
    pub wall: f64,
    /// By all threads together.
    pub cpu: f64,
}

/// How much work a run was.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Counts {
    /// Committed coupling windows.
    pub windows: u64,
    /// Windows that were too long for a participant, and were offered anew.
    #[serde(default)]
    pub refused: u64,
    /// Coupling iterations in all windows together.
    pub iterations: u64,
    /// Substeps of the grains.
    pub substeps: u64,
    /// Grains at the end.
    pub grains: u64,
    /// Fluid nodes at the end.
    pub nodes: u64,
}

/// The largest residual of a ledger row during the run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LedgerMaximum {
    /// Largest absolute residual.
    #[serde(with = "number")]
    pub residual: f64,
    /// What the case allows.
    #[serde(with = "number")]
    pub tolerance: f64,
}

/// One check of the case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Check {
    /// Its name.
    pub name: String,
    /// What the run gave.
    #[serde(with = "number")]
    pub value: f64,
    /// What it should have given.
    #[serde(with = "number")]
    pub reference: f64,
    /// Allowed absolute difference.
    #[serde(with = "number")]
    pub tolerance: f64,
    /// The verdict.
    pub pass: bool,
    /// Where the reference comes from, or why the check failed.
    pub why: String,
}

/// The file: the summary and the version of its layout.
#[derive(Serialize)]
struct Versioned<'a> {
    schema_version: u32,
    #[serde(flatten)]
    summary: &'a Summary,
}

impl Summary {
    /// Writes `summary.json`.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), OutputError> {
        let versioned = Versioned { schema_version: SCHEMA_VERSION, summary: self };
        let text = serde_json::to_string_pretty(&versioned).map_err(|fault| OutputError::Inconsistent {
            path: path.to_path_buf(),
            what: "summary".to_owned(),
            found: fault.to_string(),
            expected: "numbers and text".to_owned(),
        })?;
        replace_file(path, &[text.as_bytes(), b"\n"])
    }

    /// Reads `summary.json`.
    ///
    /// # Errors
    /// The file cannot be read, has another schema version, or a field is missing, unknown or of another type.
    pub fn read(path: &Path) -> Result<Self, OutputError> {
        let malformed = |what: &str, found: String, expected: String| OutputError::Malformed {
            place: path.display().to_string(),
            what: what.to_owned(),
            found,
            expected,
            advice: "read it with the program that wrote it",
        };
        let faulty =
            |fault: serde_json::Error| malformed("summary", fault.to_string(), "a whole summary".to_owned());
        let bytes = read_file(path)?;
        let mut fields: serde_json::Map<String, serde_json::Value> =
            serde_json::from_slice(&bytes).map_err(faulty)?;
        let version = fields.remove("schema_version").unwrap_or_default();
        if version != SCHEMA_VERSION {
            return Err(malformed("schema version", version.to_string(), SCHEMA_VERSION.to_string()));
        }
        serde_json::from_value(fields.into()).map_err(faulty)
    }

    /// Coupling iterations per window; 0 without a window.
    pub fn iterations_per_window(&self) -> f64 {
        self.counts.iterations as f64 / self.counts.windows.max(1) as f64
    }
}

/// A number in JSON, which knows no infinity and no NaN: these are the words `"NaN"`, `"inf"` and `"-inf"`.
mod number {
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Number {
        Finite(f64),
        Word(String),
    }

    pub(super) fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        if value.is_finite() { serializer.serialize_f64(*value) } else { serializer.collect_str(value) }
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        match Number::deserialize(deserializer)? {
            Number::Finite(value) => Ok(value),
            Number::Word(word) => {
                word.parse().map_err(|_| D::Error::custom(format!("{word:?} is no number")))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::test_directory::TestDirectory;
    use std::fs;

    fn example() -> Summary {
        Summary {
            case: "settling".to_owned(),
            case_hash: "00ff".to_owned(),
            program_version: "0.1.0".to_owned(),
            exit: Exit { code: ExitCode::CheckFailed, reason: "a check failed: \"v\"".to_owned() },
            time: 0.1 + 0.2,
            seconds: [("dem-solver".to_owned(), Seconds { wall: 1.5, cpu: 2.25 })].into(),
            counts: Counts {
                windows: 100,
                refused: 3,
                iterations: 230,
                substeps: 5000,
                grains: 1,
                nodes: 12_167,
            },
            peak_memory: 1 << 33,
            thrift: [("lists-reused".to_owned(), u64::MAX)].into(),
            taken: [("energy-taken-by-sleep[J]".to_owned(), 1.25e-17)].into(),
            audits: [("volume-error-max[-]".to_owned(), -1.5e-3)].into(),
            ledger: [("momentum".to_owned(), LedgerMaximum { residual: 1e-17, tolerance: 1e-12 })].into(),
            checks: vec![Check {
                name: "terminal velocity".to_owned(),
                value: -0.1234,
                reference: -0.1235,
                tolerance: 1e-3,
                pass: true,
                why: "Stokes 1851".to_owned(),
            }],
        }
    }

    #[test]
    fn a_summary_reads_back_as_it_was() {
        let directory = TestDirectory::new();
        let path = directory.path("summary.json");
        example().write(&path).unwrap();
        assert_eq!(Summary::read(&path).unwrap(), example());
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains("\"schema_version\": 1") && text.contains("\"code\": 4"), "{text}");
        assert_eq!(example().iterations_per_window(), 2.3);
    }

    #[test]
    fn non_finite_values_survive() {
        let directory = TestDirectory::new();
        let path = directory.path("summary.json");
        let mut summary = example();
        summary.checks[0].value = f64::NAN;
        summary.checks[0].reference = f64::NEG_INFINITY;
        summary.ledger.get_mut("momentum").unwrap().residual = f64::INFINITY;
        summary.write(&path).unwrap();
        let read = Summary::read(&path).unwrap();
        assert!(read.checks[0].value.is_nan());
        assert_eq!(read.checks[0].reference, f64::NEG_INFINITY);
        assert_eq!(read.ledger["momentum"].residual, f64::INFINITY);
    }

    #[test]
    fn another_version_and_a_cut_file_are_refused() {
        let directory = TestDirectory::new();
        let path = directory.path("summary.json");
        example().write(&path).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, text.replace("\"schema_version\": 1", "\"schema_version\": 2")).unwrap();
        let error = Summary::read(&path).unwrap_err().to_string();
        assert!(error.contains("schema version: found 2, expected 1"), "{error}");
        for spoilt in [&text[..text.len() / 2], "{}", "", &text.replace("\"windows\"", "\"window\"")] {
            fs::write(&path, spoilt).unwrap();
            assert!(Summary::read(&path).is_err(), "{spoilt}");
        }
    }
}
