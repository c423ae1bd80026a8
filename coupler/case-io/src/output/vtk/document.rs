//! The XML around the appended data.

use std::fmt::Write;
use std::path::Path;

use super::appended::{Appended, Compression};
use super::field::{Field, Precision};
use crate::output::{OutputError, replace_file};

/// How numbers are stored on disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Format {
    /// Width of real fields.
    pub precision: Precision,
    /// Raw or LZ4.
    pub compression: Compression,
}

/// A VTK file under construction.
pub(super) struct Document {
    kind: &'static str,
    format: Format,
    /// What is inside `<Piece>`.
    piece: String,
    appended: Appended,
}

impl Document {
    pub(super) fn new(kind: &'static str, format: Format) -> Self {
        Self { kind, format, piece: String::new(), appended: Appended::default() }
    }

    /// Opens or closes an element inside the piece.
    pub(super) fn tag(&mut self, tag: &str) {
        let _ = writeln!(self.piece, "<{tag}>");
    }

    /// One array inside the open element.
    pub(super) fn array(&mut self, name: &str, number: &str, components: usize, bytes: &[u8]) {
        let offset = self.appended.push(bytes, self.format.compression);
        let _ = writeln!(
            self.piece,
            "<DataArray type=\"{number}\" Name=\"{}\" NumberOfComponents=\"{components}\" format=\"appended\" offset=\"{offset}\"/>",
            escape(name)
        );
    }

    /// A whole element of fields, `PointData` or `CellData`, with `count` rows each.
    pub(super) fn fields(
        &mut self,
        path: &Path,
        element: &str,
        fields: &[Field],
        count: usize,
    ) -> Result<(), OutputError> {
        self.tag(element);
        for (i, field) in fields.iter().enumerate() {
            if field.len() != count {
                return Err(OutputError::Inconsistent {
                    path: path.to_path_buf(),
                    what: format!("number of rows of the {element} field {:?}", field.name),
                    found: field.len().to_string(),
                    expected: count.to_string(),
                });
            }
            if fields[..i].iter().any(|earlier| earlier.name == field.name) {
                return Err(OutputError::Inconsistent {
                    path: path.to_path_buf(),
                    what: format!("names of the {element} fields"),
                    found: format!("{:?} twice", field.name),
                    expected: "every name once".to_owned(),
                });
            }
            let precision = self.format.precision;
            let bytes = field.bytes(precision);
            self.array(field.name, field.type_on_disk(precision), field.components_on_disk(), &bytes);
        }
        self.tag(&format!("/{element}"));
        Ok(())
    }

    /// Writes the file; `counts` are the attributes of `<Piece>`.
    pub(super) fn write(self, path: &Path, counts: &[(&str, usize)]) -> Result<(), OutputError> {
        let Self { kind, format, piece, appended } = self;
        let compressor = format.compression.attribute();
        let counts: String = counts.iter().map(|(name, count)| format!(" {name}=\"{count}\"")).collect();
        let head = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\"{compressor}>\n<{kind}>\n<Piece{counts}>\n{piece}</Piece>\n</{kind}>\n\
             <AppendedData encoding=\"raw\">\n_"
        );
        replace_file(path, &[head.as_bytes(), &appended.bytes, b"\n</AppendedData>\n</VTKFile>\n"])
    }
}

/// Text made fit for an XML attribute.
pub(super) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The inverse of [`escape`].
pub(super) fn unescape(text: &str) -> String {
    text.replace("&quot;", "\"").replace("&gt;", ">").replace("&lt;", "<").replace("&amp;", "&")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escaping_is_undone_by_unescaping() {
        let awkward = "a<b> & \"c\" &lt;";
        assert_eq!(unescape(&escape(awkward)), awkward);
        assert!(!escape(awkward).contains(['<', '>', '"']));
    }
}
