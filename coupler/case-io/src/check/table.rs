//! The tables of `check.toml` as they are written.

use std::fmt;
use std::path::PathBuf;

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Visitor};

use crate::document::quantity::Time;
use crate::output::series::Title;

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(super) struct CheckFile {
    #[serde(default)]
    pub check: Vec<CheckTable>,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(super) struct CheckTable {
    pub run: Option<String>,
    pub name: String,
    pub quantity: String,
    pub take: Take,
    pub from: Option<Time>,
    pub to: Option<Time>,
    pub reference: ReferenceTable,
    pub tolerance: Option<f64>,
    pub absolute_tolerance: Option<f64>,
    pub why: String,
}

/// What is taken of a quantity over time.
#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Take {
    /// The last value.
    Last,
    /// The largest value.
    Max,
    /// The smallest value.
    Min,
    /// The mean over time.
    Mean,
    /// The largest magnitude.
    AbsMax,
    /// Root mean square over time of the difference from the reference (relative: to the reference's own).
    ErrorL2,
    /// Largest magnitude of the difference from the reference (relative: to the reference's own).
    ErrorMax,
}

pub(super) enum ReferenceTable {
    Number(f64),
    Column(ColumnTable),
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub(super) struct ColumnTable {
    pub file: PathBuf,
    #[serde(deserialize_with = "title")]
    pub column: Title,
    #[serde(deserialize_with = "title")]
    pub time_column: Title,
}

fn title<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Title, D::Error> {
    let text = String::deserialize(deserializer)?;
    text.parse().map_err(|()| {
        D::Error::custom(format_args!("found \"{text}\"; allowed: NAME[UNIT], for example \"t[s]\""))
    })
}

impl<'de> Deserialize<'de> for ReferenceTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ReferenceVisitor)
    }
}

struct ReferenceVisitor;

impl<'de> Visitor<'de> for ReferenceVisitor {
    type Value = ReferenceTable;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a number in the unit of the quantity, or { file, column, time-column }")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<ReferenceTable, E> {
        Ok(ReferenceTable::Number(number))
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<ReferenceTable, E> {
        Ok(ReferenceTable::Number(number as f64))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<ReferenceTable, A::Error> {
        ColumnTable::deserialize(MapAccessDeserializer::new(map)).map(ReferenceTable::Column)
    }
}
