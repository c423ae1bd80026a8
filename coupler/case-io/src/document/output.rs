//! `[output]`: what is written, and how often.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserializer, Error, Visitor};
use serde::{Deserialize, Serialize, Serializer};

use super::grain_field::GrainField;
use super::quantity::{QuantityVisitor, Time};

/// `[output]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct OutputTable {
    /// Interval of the rows in `series/`; default end / 200.
    pub series: Option<Time>,
    /// Interval of the pictures in `frames/`, or "none": of the end only; default end / 20.
    pub frames: Option<Interval>,
    /// Interval of the restart points, or "none"; default end / 4.
    pub restart: Option<Interval>,
    /// Fields of the grains in each frame; default id, radius, velocity, angular-velocity, material. Those of contacts are 0
    /// at t = 0, before the first window has found any.
    pub fields: Option<Vec<GrainField>>,
    /// Whether frames are compressed (LZ4).
    #[serde(default = "default_compress")]
    pub compress: bool,
}

fn default_compress() -> bool {
    true
}

impl Default for OutputTable {
    fn default() -> Self {
        Self { series: None, frames: None, restart: None, fields: None, compress: default_compress() }
    }
}

impl OutputTable {
    /// Interval of the series in s, for a run until `end`.
    pub fn series(&self, end: Time) -> f64 {
        self.series.map_or(end.si() / 200.0, Time::si)
    }

    /// Interval of the frames in s, for a run until `end`; nothing if the end is the only one.
    pub fn frames(&self, end: Time) -> Option<f64> {
        self.frames.map_or(Some(end.si() / 20.0), Interval::seconds)
    }

    /// Fields of the grains in each frame.
    pub fn fields(&self) -> &[GrainField] {
        self.fields.as_deref().unwrap_or(&GrainField::DEFAULT)
    }

    /// Whether the initial state is a frame: where there are frames in time.
    pub fn films_start(&self) -> bool {
        self.frames != Some(Interval::None)
    }

    /// Interval of the restart points in s, for a run until `end`; nothing if there are none.
    pub fn restart(&self, end: Time) -> Option<f64> {
        self.restart.map_or(Some(end.si() / 4.0), Interval::seconds)
    }
}

/// An interval of time, or "none".
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interval {
    /// None.
    None,
    /// Once in every such time.
    Every(Time),
}

impl Interval {
    fn seconds(self) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Every(time) => Some(time.si()),
        }
    }
}

impl Serialize for Interval {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::None => serializer.serialize_str("none"),
            Self::Every(time) => time.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Interval {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(IntervalVisitor)
    }
}

struct IntervalVisitor;

fn time<E: Error>(time: Result<Time, E>) -> Result<Interval, E> {
    time.map(Interval::Every).map_err(|error| E::custom(format_args!("{error}, or \"none\"")))
}

impl Visitor<'_> for IntervalVisitor {
    type Value = Interval;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a time with its unit, for example \"100 ms\", or \"none\"")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Interval, E> {
        if text == "none" { Ok(Interval::None) } else { time(QuantityVisitor(PhantomData).visit_str(text)) }
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Interval, E> {
        time(QuantityVisitor(PhantomData).visit_i64(value))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Interval, E> {
        time(QuantityVisitor(PhantomData).visit_f64(value))
    }
}

impl JsonSchema for Interval {
    fn schema_name() -> Cow<'static, str> {
        "Interval".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "string",
            "description": "a time with its unit, or \"none\"",
            "examples": ["100 ms", "none"],
        })
    }
}
