//! Writing a checkpoint.

use std::borrow::Cow;
use std::path::Path;

use serde::Serialize;

use super::element::ElementType;
use super::{Element, Header, MAGIC, METADATA, Section, VERSION, checksum, padding};
use crate::output::{OutputError, replace_file_durably};

/// Collects the sections of a checkpoint; the arrays are borrowed and go to disk without a copy.
///
/// ```
/// # use case_io::checkpoint::{Checkpoint, CheckpointWriter};
/// # let path = std::env::temp_dir().join(format!("example-{}.checkpoint", std::process::id()));
/// let x = [0.5, 1.5];
/// CheckpointWriter::new("dem-solver", &("step", 7u64)).array("x", &x).write(&path)?;
/// let checkpoint = Checkpoint::read(&path, "dem-solver")?;
/// assert_eq!(checkpoint.array::<f64>("x")?, x);
/// # std::fs::remove_file(&path).unwrap();
/// # Ok::<(), case_io::output::OutputError>(())
/// ```
pub struct CheckpointWriter<'a> {
    kind: &'a str,
    metadata: Result<Vec<u8>, String>,
    arrays: Vec<Array<'a>>,
}

struct Array<'a> {
    name: &'a str,
    element: ElementType,
    count: usize,
    bytes: Cow<'a, [u8]>,
}

impl<'a> CheckpointWriter<'a> {
    /// A checkpoint of one kind of participant with its scalars, counters and settings.
    pub fn new<M: Serialize>(kind: &'a str, metadata: &M) -> Self {
        Self { kind, metadata: encode(metadata), arrays: Vec::new() }
    }

    /// Adds a bulk array.
    #[must_use]
    pub fn array<T: Element>(mut self, name: &'a str, values: &'a [T]) -> Self {
        let bytes = Cow::Borrowed(bytemuck::cast_slice(values));
        self.arrays.push(Array { name, element: T::TYPE, count: values.len(), bytes });
        self
    }

    /// Adds an array made for the checkpoint.
    #[must_use]
    pub fn made<T: Element>(mut self, name: &'a str, values: &[T]) -> Self {
        let bytes = Cow::Owned(bytemuck::cast_slice(values).to_vec());
        self.arrays.push(Array { name, element: T::TYPE, count: values.len(), bytes });
        self
    }

    /// Writes the file under a temporary name, syncs and renames it.
    ///
    /// # Errors
    /// Metadata that bincode cannot hold, a name twice, or a file that cannot be written.
    pub fn write(self, path: &Path) -> Result<(), OutputError> {
        let inconsistent = |what: &str, found: String, expected: &str| OutputError::Inconsistent {
            path: path.to_path_buf(),
            what: what.to_owned(),
            found,
            expected: expected.to_owned(),
        };
        let metadata =
            self.metadata.map_err(|fault| inconsistent("metadata", fault, "what bincode can encode"))?;
        let head = Array {
            name: METADATA,
            element: ElementType::U8,
            count: metadata.len(),
            bytes: Cow::Owned(metadata),
        };
        let parts: Vec<Array> = std::iter::once(head).chain(self.arrays).collect();
        for (i, part) in parts.iter().enumerate() {
            if parts[..i].iter().any(|earlier| earlier.name == part.name) {
                return Err(inconsistent(
                    "section names",
                    format!("{:?} twice", part.name),
                    "every name once",
                ));
            }
        }

        let sections = parts
            .iter()
            .map(|part| Section {
                name: part.name.to_owned(),
                element: part.element,
                count: part.count as u64,
                checksum: checksum(&part.bytes),
            })
            .collect();
        let header = encode(&Header { kind: self.kind.to_owned(), sections })
            .map_err(|fault| inconsistent("header", fault, "what bincode can encode"))?;
        let length = u32::try_from(header.len())
            .map_err(|_| inconsistent("header", format!("{} bytes", header.len()), "below 4 GiB"))?;

        const ZEROS: [u8; 8] = [0; 8];
        let pad = |length: usize| &ZEROS[..padding(length as u64) as usize];
        let version = VERSION.to_le_bytes();
        let length = length.to_le_bytes();
        let seal = checksum(&header).to_le_bytes();
        let mut pieces: Vec<&[u8]> = vec![&MAGIC, &version, &length, &seal, &header, pad(header.len())];
        for part in &parts {
            pieces.extend([&*part.bytes, pad(part.bytes.len())]);
        }
        replace_file_durably(path, &pieces)
    }
}

fn encode<T: Serialize>(value: &T) -> Result<Vec<u8>, String> {
    bincode::serde::encode_to_vec(value, bincode::config::standard()).map_err(|fault| fault.to_string())
}
