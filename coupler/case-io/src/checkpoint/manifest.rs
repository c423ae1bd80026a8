//! `manifest.json`: what a restart point consists of, so that it can be verified without reading its parts' formats.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::checksum;
use crate::output::{OutputError, read_file, replace_file_durably};

/// The file name inside a restart point.
pub(super) const MANIFEST: &str = "manifest.json";

/// What a restart point consists of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// Number of the committed coupling window.
    pub window: u64,
    /// Time at the end of the window \[s\].
    pub t: f64,
    /// Length of the window \[s\].
    pub dt: f64,
    /// Hash of the case as it was run.
    pub case_hash: String,
    /// Version of the program that wrote it.
    pub program_version: String,
    /// The files beside the manifest.
    pub parts: Vec<Part>,
}

/// One participant's file in a restart point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// File name.
    pub name: String,
    /// Bytes.
    pub size: u64,
    /// XXH64 of the whole file, in hexadecimal.
    pub checksum: String,
}

impl Part {
    /// Size and checksum of a file as it lies on disk.
    ///
    /// # Errors
    /// The file cannot be read.
    pub(super) fn of_file(directory: &Path, name: &str) -> Result<Self, OutputError> {
        let bytes = read_file(&directory.join(name))?;
        let checksum = format!("{:016x}", checksum(&bytes));
        Ok(Self { name: name.to_owned(), size: bytes.len() as u64, checksum })
    }
}

/// The file: the manifest and a checksum of its own.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sealed {
    schema_version: u32,
    checksum: String,
    manifest: Manifest,
}

const SCHEMA_VERSION: u32 = 1;

impl Manifest {
    pub(super) fn write(&self, directory: &Path) -> Result<(), OutputError> {
        let path = directory.join(MANIFEST);
        if !(self.t.is_finite() && self.dt.is_finite()) {
            return Err(OutputError::Inconsistent {
                path,
                what: "t and dt".to_owned(),
                found: format!("{:?} s and {:?} s", self.t, self.dt),
                expected: "finite".to_owned(),
            });
        }
        let sealed = Sealed { schema_version: SCHEMA_VERSION, checksum: self.seal(), manifest: self.clone() };
        replace_file_durably(&path, &[json(&sealed).as_bytes()])
    }

    /// Reads the manifest and compares the size and checksum of every part with the files beside it.
    ///
    /// # Errors
    /// A file that is missing, cut off or altered; another schema version.
    pub fn read_and_verify(directory: &Path) -> Result<Self, OutputError> {
        let path = directory.join(MANIFEST);
        let malformed = |what: String, found: String, expected: String| OutputError::Malformed {
            place: path.display().to_string(),
            what,
            found,
            expected,
            advice: "use an earlier restart point",
        };
        let bytes = read_file(&path)?;
        let sealed: Sealed = serde_json::from_slice(&bytes).map_err(|fault| {
            malformed("manifest".to_owned(), fault.to_string(), "a whole manifest".to_owned())
        })?;
        if sealed.schema_version != SCHEMA_VERSION {
            let found = sealed.schema_version.to_string();
            return Err(malformed("schema version".to_owned(), found, SCHEMA_VERSION.to_string()));
        }
        let manifest = sealed.manifest;
        if manifest.seal() != sealed.checksum {
            return Err(malformed("checksum of the manifest".to_owned(), manifest.seal(), sealed.checksum));
        }
        for part in &manifest.parts {
            let found = Part::of_file(directory, &part.name)?;
            if found != *part {
                let tell = |part: &Part| format!("{} bytes with checksum {}", part.size, part.checksum);
                return Err(malformed(format!("part {:?}", part.name), tell(&found), tell(part)));
            }
        }
        Ok(manifest)
    }

    /// Checksum of the manifest's own JSON.
    fn seal(&self) -> String {
        format!("{:016x}", checksum(json(self).as_bytes()))
    }
}

/// Numbers and strings only: cannot fail.
fn json<T: Serialize>(value: &T) -> String {
    serde_json::to_string_pretty(value).unwrap_or_default()
}
