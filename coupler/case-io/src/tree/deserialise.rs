//! Serde's view of the tree. A fault carries the path of the key it is about, innermost segment first.

use std::fmt;

use serde::de::value::{BorrowedStrDeserializer, StrDeserializer};
use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Error, Expected, MapAccess, SeqAccess, Unexpected, Visitor,
};
use serde::forward_to_deserialize_any;

use super::{Node, Segment, Value};
use crate::nearest::did_you_mean;

/// What is wrong with a value.
#[derive(Debug, Default)]
pub(crate) struct Fault {
    /// Path to the key, innermost first.
    pub path: Vec<Segment>,
    pub found: String,
    pub allowed: String,
    pub advice: String,
    /// The key is not there, and must be.
    pub missing: bool,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.found)
    }
}

impl std::error::Error for Fault {}

impl Fault {
    fn inside(mut self, segment: Segment) -> Self {
        self.path.push(segment);
        self
    }
}

/// Serde names Rust's types; a case's author knows numbers.
fn allowed(expected: &dyn Expected) -> String {
    match expected.to_string().as_str() {
        "f64" => "a number".into(),
        "u32" | "u64" => "a whole number from 0".into(),
        "i64" => "a whole number".into(),
        "a boolean" => "true, false".into(),
        "a sequence" => "an array: [ … ] or [[ ]] tables".into(),
        "a map" => "a table: { … } or [ ]".into(),
        "path string" => "a path".into(),
        other => other.into(),
    }
}

fn found(unexpected: Unexpected) -> String {
    match unexpected {
        Unexpected::Str(text) => format!("found the string \"{text}\""),
        Unexpected::Signed(number) => format!("found {number}"),
        Unexpected::Unsigned(number) => format!("found {number}"),
        Unexpected::Float(number) => format!("found {number:?}"),
        Unexpected::Bool(boolean) => format!("found {boolean}"),
        Unexpected::Seq => "found an array".into(),
        Unexpected::Map => "found a table".into(),
        other => format!("found {other}"),
    }
}

impl Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self { found: message.to_string(), ..Self::default() }
    }

    fn invalid_type(unexpected: Unexpected, expected: &dyn Expected) -> Self {
        Self { found: found(unexpected), allowed: allowed(expected), ..Self::default() }
    }

    fn invalid_value(unexpected: Unexpected, expected: &dyn Expected) -> Self {
        Self::invalid_type(unexpected, expected)
    }

    fn missing_field(field: &'static str) -> Self {
        Self { found: "missing".into(), missing: true, ..Self::default() }.inside(Segment::Key(field.into()))
    }

    fn unknown_field(field: &str, known: &'static [&'static str]) -> Self {
        Self {
            found: "unknown key".into(),
            allowed: known.join(", "),
            advice: did_you_mean(field, known),
            ..Self::default()
        }
        .inside(Segment::Key(field.into()))
    }
}

impl Node {
    fn unexpected(&self) -> Unexpected<'_> {
        match &self.value {
            Value::String(text) => Unexpected::Str(text),
            Value::Integer(number) => Unexpected::Signed(*number),
            Value::Float(number) => Unexpected::Float(*number),
            Value::Boolean(boolean) => Unexpected::Bool(*boolean),
            Value::Datetime => Unexpected::Other("a date"),
            Value::Array(_) => Unexpected::Seq,
            Value::Table(_) => Unexpected::Map,
        }
    }

    fn refuse<T>(&self, allowed: impl Into<String>) -> Result<T, Fault> {
        Err(Fault { found: found(self.unexpected()), allowed: allowed.into(), ..Fault::default() })
    }
}

impl<'de> Deserializer<'de> for &'de Node {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match &self.value {
            Value::String(text) => visitor.visit_borrowed_str(text),
            Value::Integer(number) => visitor.visit_i64(*number),
            Value::Float(number) if !number.is_finite() => Err(Fault {
                found: format!("found {number:?}"),
                allowed: "finite numbers".into(),
                ..Fault::default()
            }),
            Value::Float(number) => visitor.visit_f64(*number),
            Value::Boolean(boolean) => visitor.visit_bool(*boolean),
            Value::Datetime => Err(Fault::invalid_type(self.unexpected(), &visitor)),
            Value::Array(array) => visitor.visit_seq(Elements(array.iter().enumerate())),
            Value::Table(table) => visitor.visit_map(Entries { rest: table.iter(), current: None }),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match self.value {
            Value::Table(_) => self.deserialize_any(visitor),
            _ => self.refuse(format!("a table with the keys {}", fields.join(", "))),
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            Value::Array(_) => self.deserialize_any(visitor),
            _ => Err(Fault::invalid_type(self.unexpected(), &visitor)),
        }
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, Fault> {
        match &self.value {
            Value::Array(array) if array.len() == length => self.deserialize_any(visitor),
            Value::Array(array) => Err(Fault {
                found: format!("found {} entries", array.len()),
                allowed: format!("{length} entries"),
                ..Fault::default()
            }),
            _ => self.refuse(format!("an array of {length} entries")),
        }
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        name: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        match &self.value {
            Value::String(word) if variants.contains(&word.as_str()) => visitor.visit_enum(Word(word)),
            Value::String(word) => Err(Fault {
                found: format!("unknown {} \"{word}\"", last_word(name)),
                allowed: variants.join(", "),
                advice: did_you_mean(word, variants),
                ..Fault::default()
            }),
            _ => self.refuse(variants.iter().map(|v| format!("\"{v}\"")).collect::<Vec<_>>().join(", ")),
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct
        tuple_struct map identifier ignored_any
    }
}

/// `NormalLaw` → `law`
fn last_word(name: &str) -> String {
    name[name.rfind(char::is_uppercase).unwrap_or(0)..].to_lowercase()
}

struct Word<'de>(&'de str);

impl<'de> EnumAccess<'de> for Word<'de> {
    type Error = Fault;
    type Variant = Unit;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Unit), Fault> {
        Ok((seed.deserialize(BorrowedStrDeserializer::<Fault>::new(self.0))?, Unit))
    }
}

/// The content of a variant that is a word: none.
struct Unit;

impl<'de> serde::de::VariantAccess<'de> for Unit {
    type Error = Fault;

    fn unit_variant(self) -> Result<(), Fault> {
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, _: T) -> Result<T::Value, Fault> {
        Err(Fault::custom("a word has no content"))
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, _: V) -> Result<V::Value, Fault> {
        Err(Fault::custom("a word has no content"))
    }

    fn struct_variant<V: Visitor<'de>>(self, _: &'static [&'static str], _: V) -> Result<V::Value, Fault> {
        Err(Fault::custom("a word has no content"))
    }
}

struct Elements<'de>(std::iter::Enumerate<std::slice::Iter<'de, Node>>);

impl<'de> SeqAccess<'de> for Elements<'de> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Fault> {
        let Some((index, node)) = self.0.next() else { return Ok(None) };
        seed.deserialize(node).map(Some).map_err(|fault| fault.inside(Segment::Index(index)))
    }
}

struct Entries<'de> {
    rest: std::collections::btree_map::Iter<'de, String, Node>,
    current: Option<(&'de String, &'de Node)>,
}

impl<'de> MapAccess<'de> for Entries<'de> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Fault> {
        self.current = self.rest.next();
        match self.current {
            Some((key, _)) => seed.deserialize(StrDeserializer::<Fault>::new(key)).map(Some),
            None => Ok(None),
        }
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Fault> {
        match self.current {
            Some((key, node)) => {
                seed.deserialize(node).map_err(|fault| fault.inside(Segment::Key(key.clone())))
            }
            None => Err(Fault::custom("a value without a key")),
        }
    }
}
