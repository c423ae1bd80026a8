//! Reading a checkpoint, and telling exactly what is wrong with a damaged one.

use std::ops::Range;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;

use super::{Element, Header, MAGIC, METADATA, PREFIX, Section, VERSION, checksum, padding};
use crate::output::{OutputError, read_file};

/// A checkpoint in memory, every section verified.
#[derive(Debug)]
pub struct Checkpoint {
    path: PathBuf,
    bytes: Vec<u8>,
    sections: Vec<(Section, Range<usize>)>,
}

impl Checkpoint {
    /// Reads a checkpoint of the given kind and verifies every byte of it.
    ///
    /// # Errors
    /// No checkpoint, another format version, another kind, a file that ends too early or too late, a checksum that
    /// does not fit; each names file, section, what was found and what was expected.
    pub fn read(path: &Path, kind: &str) -> Result<Self, OutputError> {
        Self::parse(path, read_file(path)?, kind)
    }

    fn parse(path: &Path, bytes: Vec<u8>, kind: &str) -> Result<Self, OutputError> {
        let begin = &bytes[..bytes.len().min(MAGIC.len())];
        if begin != MAGIC {
            let found = begin.to_vec();
            return Err(OutputError::NotCheckpoint { path: path.to_path_buf(), found, expected: MAGIC });
        }
        let header_section = "header".to_owned();
        let short = |section: &str, expected: u64| OutputError::OtherLength {
            path: path.to_path_buf(),
            section: section.to_owned(),
            found: bytes.len() as u64,
            expected,
        };
        let damaged = |section: &str, found: u64, expected: u64| OutputError::Damaged {
            path: path.to_path_buf(),
            section: section.to_owned(),
            found,
            expected,
        };

        let prefix = bytes.get(..PREFIX).ok_or_else(|| short(&header_section, PREFIX as u64))?;
        let word =
            |at: usize| u32::from_le_bytes([prefix[at], prefix[at + 1], prefix[at + 2], prefix[at + 3]]);
        let (version, length) = (word(8), word(12) as usize);
        let seal = u64::from(word(16)) | u64::from(word(20)) << 32;
        if version != VERSION {
            return Err(OutputError::OtherVersion {
                path: path.to_path_buf(),
                found: version,
                expected: VERSION,
            });
        }
        let encoded = bytes
            .get(PREFIX..PREFIX + length)
            .ok_or_else(|| short(&header_section, (PREFIX + length) as u64))?;
        let found = checksum(encoded);
        if found != seal {
            return Err(damaged(&header_section, found, seal));
        }
        let header: Header = decode(encoded).map_err(|fault| OutputError::OtherSection {
            path: path.to_path_buf(),
            section: header_section,
            found: fault,
            expected: "kind and sections".to_owned(),
        })?;
        if header.kind != kind {
            return Err(OutputError::OtherKind {
                path: path.to_path_buf(),
                found: header.kind,
                expected: kind.to_owned(),
            });
        }

        let mut sections = Vec::with_capacity(header.sections.len());
        let mut begin = (PREFIX + length) as u64 + padding(length as u64);
        for section in header.sections {
            let size = section.bytes().unwrap_or(u64::MAX);
            let end = begin.saturating_add(size);
            let padded_end = end.saturating_add(padding(size));
            if padded_end > bytes.len() as u64 {
                return Err(short(&section.name, padded_end));
            }
            let range = begin as usize..end as usize;
            let found = checksum(&bytes[range.clone()]);
            if found != section.checksum {
                return Err(damaged(&section.name, found, section.checksum));
            }
            sections.push((section, range));
            begin = padded_end;
        }
        if begin != bytes.len() as u64 {
            return Err(short("after the last", begin));
        }
        Ok(Self { path: path.to_path_buf(), bytes, sections })
    }

    /// The metadata given to [`super::CheckpointWriter::new`].
    ///
    /// # Errors
    /// The metadata are of another type.
    pub fn metadata<M: DeserializeOwned>(&self) -> Result<M, OutputError> {
        let bytes = self.section::<u8>(METADATA)?;
        decode(bytes).map_err(|fault| self.other(METADATA, fault, std::any::type_name::<M>()))
    }

    /// A bulk array.
    ///
    /// # Errors
    /// There is no array of that name, or it holds another type.
    pub fn array<T: Element>(&self, name: &str) -> Result<Vec<T>, OutputError> {
        let bytes = self.section::<T>(name)?;
        let mut values = vec![T::zeroed(); bytes.len() / size_of::<T>()];
        bytemuck::cast_slice_mut::<T, u8>(&mut values).copy_from_slice(bytes);
        Ok(values)
    }

    fn section<T: Element>(&self, name: &str) -> Result<&[u8], OutputError> {
        let expected = format!("an array of {:?}", T::TYPE);
        let (section, range) = self
            .sections
            .iter()
            .find(|(section, _)| section.name == name)
            .ok_or_else(|| self.other(name, "no such section".to_owned(), &expected))?;
        if section.element != T::TYPE {
            return Err(self.other(name, format!("an array of {:?}", section.element), &expected));
        }
        Ok(&self.bytes[range.clone()])
    }

    fn other(&self, section: &str, found: String, expected: &str) -> OutputError {
        OutputError::OtherSection {
            path: self.path.clone(),
            section: section.to_owned(),
            found,
            expected: expected.to_owned(),
        }
    }
}

/// The value in `bytes`, all of them.
fn decode<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, String> {
    let (value, used) = bincode::serde::decode_from_slice(bytes, bincode::config::standard())
        .map_err(|fault| fault.to_string())?;
    if used == bytes.len() {
        Ok(value)
    } else {
        Err(format!("{} bytes of which {used} were used", bytes.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::super::CheckpointWriter;
    use super::*;
    use crate::output::test_directory::TestDirectory;
    use serde::{Deserialize, Serialize};
    use std::fs;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Clock {
        t: f64,
        step: u64,
        law: String,
        relaxation: Option<f64>,
    }

    fn clock() -> Clock {
        Clock { t: 0.1 + 0.2, step: 42, law: "hertz".to_owned(), relaxation: Some(-0.0) }
    }

    /// Arrays of awkward lengths, so that padding is exercised.
    fn write(path: &Path) {
        CheckpointWriter::new("dem-solver", &clock())
            .array("x", &[0.1, f64::NAN, f64::NEG_INFINITY, 5e-324])
            .array("id", &[u64::MAX, 0])
            .array("cell", &[7u32, 8, 9])
            .array("flag", &[1u8, 0, 1, 1, 0])
            .array("none", &[0.0f64; 0])
            .write(path)
            .unwrap();
    }

    #[test]
    fn every_bit_of_metadata_and_arrays_survives() {
        let directory = TestDirectory::new();
        let path = directory.path("part");
        write(&path);
        let checkpoint = Checkpoint::read(&path, "dem-solver").unwrap();
        let read: Clock = checkpoint.metadata().unwrap();
        assert_eq!(read, clock());
        assert!(read.relaxation.unwrap().is_sign_negative());
        let x: Vec<u64> = checkpoint.array::<f64>("x").unwrap().iter().map(|x| x.to_bits()).collect();
        assert_eq!(x, [0.1, f64::NAN, f64::NEG_INFINITY, 5e-324].map(f64::to_bits));
        assert_eq!(checkpoint.array::<u64>("id").unwrap(), [u64::MAX, 0]);
        assert_eq!(checkpoint.array::<u32>("cell").unwrap(), [7, 8, 9]);
        assert_eq!(checkpoint.array::<u8>("flag").unwrap(), [1, 0, 1, 1, 0]);
        assert!(checkpoint.array::<f64>("none").unwrap().is_empty());
        assert!(checkpoint.sections.iter().all(|(_, range)| range.start % 8 == 0));
        assert_eq!(fs::read_dir(directory.root()).unwrap().count(), 1, "a temporary file was left");
    }

    #[test]
    fn the_same_state_makes_the_same_file() {
        let directory = TestDirectory::new();
        let (one, two) = (directory.path("one"), directory.path("two"));
        write(&one);
        write(&two);
        assert_eq!(fs::read(one).unwrap(), fs::read(two).unwrap());
    }

    #[test]
    fn a_file_cut_anywhere_is_refused() {
        let directory = TestDirectory::new();
        let path = directory.path("part");
        write(&path);
        let whole = fs::read(&path).unwrap();
        for length in 0..whole.len() {
            match Checkpoint::parse(&path, whole[..length].to_vec(), "dem-solver").unwrap_err() {
                OutputError::NotCheckpoint { .. } => assert!(length < 8),
                OutputError::OtherLength { found, expected, .. } => {
                    assert!(found == length as u64 && found < expected);
                }
                other => panic!("{length} bytes: {other}"),
            }
        }
        fs::write(&path, [&whole[..], b"12345678"].concat()).unwrap();
        let error = Checkpoint::read(&path, "dem-solver").unwrap_err();
        assert!(matches!(error, OutputError::OtherLength { found, expected, .. } if found == expected + 8));
    }

    #[test]
    fn a_flipped_bit_in_anything_but_padding_is_found() {
        let directory = TestDirectory::new();
        let path = directory.path("part");
        write(&path);
        let whole = fs::read(&path).unwrap();
        let mut unnoticed = 0;
        for bit in 0..whole.len() * 8 {
            let mut damaged = whole.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            unnoticed += usize::from(Checkpoint::parse(&path, damaged, "dem-solver").is_ok());
        }
        let sections = Checkpoint::read(&path, "dem-solver").unwrap().sections;
        let data: usize = sections.iter().map(|(_, range)| range.len()).sum();
        let header = u32::from_le_bytes(whole[12..16].try_into().unwrap()) as usize;
        assert_eq!(unnoticed, 8 * (whole.len() - PREFIX - header - data), "only padding may go unnoticed");
    }

    #[test]
    fn a_flipped_bit_names_its_section() {
        let directory = TestDirectory::new();
        let path = directory.path("part");
        write(&path);
        let whole = fs::read(&path).unwrap();
        let begin = Checkpoint::read(&path, "dem-solver").unwrap().sections[3].1.start;
        for (byte, section) in [(begin, "cell"), (PREFIX, "header")] {
            let mut damaged = whole.clone();
            damaged[byte] ^= 4;
            fs::write(&path, damaged).unwrap();
            let error = Checkpoint::read(&path, "dem-solver").unwrap_err();
            assert!(error.to_string().contains(&format!("section {section:?} is damaged")), "{error}");
        }
    }

    #[test]
    fn another_version_another_kind_and_another_format_are_told_apart() {
        let directory = TestDirectory::new();
        let path = directory.path("part");
        write(&path);
        let error = Checkpoint::read(&path, "fluid-solver").unwrap_err().to_string();
        assert!(error.contains("\"dem-solver\"") && error.contains("\"fluid-solver\""), "{error}");
        let mut other = fs::read(&path).unwrap();
        other[8] = 9;
        fs::write(&path, &other).unwrap();
        let error = Checkpoint::read(&path, "dem-solver").unwrap_err().to_string();
        assert!(error.contains("version 9, expected 1"), "{error}");
        fs::write(&path, "t[s],vz[m/s]\n").unwrap();
        let error = Checkpoint::read(&path, "dem-solver").unwrap_err();
        assert!(matches!(error, OutputError::NotCheckpoint { .. }));
        assert!(matches!(
            Checkpoint::read(&directory.path("absent"), "dem-solver").unwrap_err(),
            OutputError::System { .. }
        ));
    }

    #[test]
    fn an_array_is_asked_for_by_name_and_type() {
        let directory = TestDirectory::new();
        let path = directory.path("part");
        write(&path);
        let checkpoint = Checkpoint::read(&path, "dem-solver").unwrap();
        let error = checkpoint.array::<f64>("y").unwrap_err().to_string();
        assert!(error.contains("\"y\"") && error.contains("no such section"), "{error}");
        let error = checkpoint.array::<f64>("id").unwrap_err().to_string();
        assert!(error.contains("U64") && error.contains("F64"), "{error}");
        assert!(checkpoint.metadata::<(u8,)>().is_err());
        let twice = CheckpointWriter::new("k", &()).array("x", &[1.0]).array("x", &[1.0]).write(&path);
        assert!(twice.unwrap_err().to_string().contains("twice"));
    }
}
