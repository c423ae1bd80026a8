//! Numbers and sections of an MSH file, text or binary, with the place of every error.

use crate::mesh::{MeshError, Place};
use std::path::Path;

/// A cursor over the bytes of a file.
pub struct Source<'a> {
    file: &'a Path,
    bytes: &'a [u8],
    position: usize,
    binary: bool,
}

type Result<T> = std::result::Result<T, MeshError>;

impl<'a> Source<'a> {
    pub fn new(file: &'a Path, bytes: &'a [u8]) -> Self {
        Self { file, bytes, position: 0, binary: false }
    }

    /// From here on `int`, `size` and `real` read little-endian bytes instead of text.
    pub fn set_binary(&mut self) {
        self.binary = true;
    }

    pub fn is_binary(&self) -> bool {
        self.binary
    }

    /// Bytes not yet read: no honest count in the file exceeds it.
    pub fn remaining(&self) -> usize {
        self.bytes.len() - self.position
    }

    pub fn error(
        &self,
        found: impl Into<String>,
        expected: impl Into<String>,
        advice: &'static str,
    ) -> MeshError {
        let place = if self.binary {
            Place::Byte(self.position)
        } else {
            Place::Line(1 + self.bytes[..self.position].iter().filter(|&&byte| byte == b'\n').count())
        };
        MeshError::File {
            file: self.file.to_path_buf(),
            place,
            found: found.into(),
            expected: expected.into(),
            advice,
        }
    }

    fn damaged(&self, found: impl Into<String>, expected: impl Into<String>) -> MeshError {
        self.error(found, expected, "the file is damaged or cut short: export it again")
    }

    /// The next word of text.
    pub fn word(&mut self) -> Result<&'a str> {
        let rest = &self.bytes[self.position..];
        let start = rest.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(rest.len());
        let length = rest[start..].iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len() - start);
        self.position += start;
        if length == 0 {
            return Err(self.damaged("the end of the file", "more text"));
        }
        let word = std::str::from_utf8(&rest[start..start + length])
            .map_err(|_| self.damaged("bytes that are no text", "text"))?;
        self.position += length;
        Ok(word)
    }

    /// A number written as text, even in a binary file.
    pub fn text<T: std::str::FromStr>(&mut self, expected: &str) -> Result<T> {
        let word = self.word()?;
        word.parse().map_err(|_| {
            self.position -= word.len();
            self.damaged(format!("\"{word}\""), expected)
        })
    }

    /// The next text between double quotes.
    pub fn quoted(&mut self) -> Result<&'a str> {
        let rest = &self.bytes[self.position..];
        let line = rest.split(|&byte| byte == b'\n').next().unwrap_or_default();
        let mut parts = line.splitn(3, |&byte| byte == b'"');
        let name =
            parts.nth(1).filter(|_| parts.next().is_some()).and_then(|name| std::str::from_utf8(name).ok());
        let name = name.ok_or_else(|| self.damaged("no name", "a name between double quotes"))?;
        self.position += line.len();
        Ok(name)
    }

    fn little_endian<const BYTES: usize>(&mut self) -> Result<[u8; BYTES]> {
        let Some(bytes) = self.bytes[self.position..].first_chunk() else {
            return Err(self.damaged("the end of the file", format!("{BYTES} more bytes")));
        };
        self.position += BYTES;
        Ok(*bytes)
    }

    pub fn int(&mut self) -> Result<i32> {
        if self.binary { Ok(i32::from_le_bytes(self.little_endian()?)) } else { self.text("an integer") }
    }

    pub fn size(&mut self) -> Result<u64> {
        if self.binary { Ok(u64::from_le_bytes(self.little_endian()?)) } else { self.text("a count or tag") }
    }

    pub fn real(&mut self) -> Result<f64> {
        if self.binary { Ok(f64::from_le_bytes(self.little_endian()?)) } else { self.text("a number") }
    }

    /// Passes the line end after a text line that binary data follow.
    pub fn end_line(&mut self) -> Result<()> {
        match self.bytes[self.position..].iter().position(|&byte| byte == b'\n') {
            Some(length) if self.bytes[self.position..self.position + length].trim_ascii().is_empty() => {
                self.position += length + 1;
                Ok(())
            }
            _ => Err(self.damaged("more on the line", "the end of the line")),
        }
    }

    /// Passes the head of the next section and returns its name; `None` at the end of the file.
    pub fn open_section(&mut self) -> Result<Option<&'a str>> {
        if self.bytes[self.position..].trim_ascii().is_empty() {
            return Ok(None);
        }
        let word = self.word()?;
        let name = word
            .strip_prefix('$')
            .ok_or_else(|| self.damaged(format!("\"{word}\""), "a section, as $Nodes"))?;
        self.end_line()?;
        Ok(Some(name))
    }

    /// Passes the `$End` line of a section.
    pub fn close_section(&mut self, name: &str) -> Result<()> {
        let word = self.word()?;
        if word.strip_prefix("$End") == Some(name) {
            Ok(())
        } else {
            Err(self.damaged(format!("\"{word}\""), format!("$End{name}")))
        }
    }

    /// Passes a section without reading it.
    pub fn skip_section(&mut self, name: &str) -> Result<()> {
        let end = format!("$End{name}");
        let rest = &self.bytes[self.position..];
        let Some(start) = rest.windows(end.len()).position(|window| window == end.as_bytes()) else {
            return Err(self.damaged("the end of the file", end));
        };
        self.position += start + end.len();
        Ok(())
    }
}
