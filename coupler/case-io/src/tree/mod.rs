//! A TOML document as a tree that remembers where every value was written.

mod assign;
mod deserialise;
mod path;

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use toml::de::{DeTable, DeValue};

pub(crate) use assign::Assignment;
pub(crate) use path::{KeyPath, Segment};

use crate::error::{CaseError, Place};
use deserialise::Fault;

/// Where a value was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// This line of the file, from 1.
    Line(usize),
    /// A `--set` on the command line.
    Set,
}

/// A value and where it was written (a table's entry: where its key is).
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub value: Value,
    pub origin: Origin,
}

/// A TOML value.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    String(String),
    Integer(i64),
    Float(f64),
    Boolean(bool),
    Datetime,
    Array(Vec<Node>),
    Table(BTreeMap<String, Node>),
}

/// A TOML file: its name and its values, whose origins make every message point at the right line.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    pub file: PathBuf,
    pub root: Node,
}

impl Source {
    /// Parses the text of `file`.
    pub(crate) fn parse(file: &Path, text: &str) -> Result<Self, CaseError> {
        let lines = Lines::of(text);
        let table = DeTable::parse(text).map_err(|error| {
            let (line, column) = lines.place(error.span().map_or(0, |span| span.start), text);
            CaseError::Syntax {
                path: file.into(),
                line,
                column,
                problem: error.message().lines().collect::<Vec<_>>().join(", "),
            }
        })?;
        let value = convert_table(table.get_ref(), &|span| Origin::Line(lines.place(span.start, text).0));
        Ok(Self { file: file.into(), root: Node { value, origin: Origin::Line(1) } })
    }

    /// The value at a path.
    pub(crate) fn get(&self, path: &KeyPath) -> Option<&Node> {
        path.0.iter().try_fold(&self.root, |node, segment| node.child(segment))
    }

    /// Whether the case states this key.
    pub(crate) fn has(&self, key: &str) -> bool {
        KeyPath::parse(key).is_some_and(|path| self.get(&path).is_some())
    }

    /// Reads the value at `path` (the root: an empty path).
    pub(crate) fn deserialise<T: DeserializeOwned>(&self, path: KeyPath) -> Result<T, CaseError> {
        let node = self.get(&path).unwrap_or(&self.root);
        T::deserialize(node).map_err(|fault| self.refuse(path, fault))
    }

    fn refuse(&self, mut path: KeyPath, fault: Fault) -> CaseError {
        path.0.extend(fault.path.into_iter().rev());
        let advice = match (fault.missing, path.0.split_last()) {
            (true, Some((Segment::Key(table), []))) => format!("add the table [{table}]"),
            (true, Some((_, parents)))
                if parents.iter().all(|segment| matches!(segment, Segment::Key(_))) =>
            {
                format!("add it to [{}]", KeyPath(parents.to_vec()))
            }
            (true, Some((_, parents))) => format!("add it to {}", KeyPath(parents.to_vec())),
            _ => fault.advice,
        };
        self.error(&path.to_string(), fault.found, fault.allowed, advice)
    }

    /// The error that this key is wrong: what was found, what is allowed, what to do (any may be empty).
    pub(crate) fn error(
        &self,
        key: &str,
        found: impl fmt::Display,
        allowed: impl fmt::Display,
        advice: impl fmt::Display,
    ) -> CaseError {
        let mut node = &self.root;
        for segment in KeyPath::parse(key).unwrap_or_default().0 {
            match node.child(&segment) {
                Some(child) => node = child,
                None => break,
            }
        }
        self.error_at(node.origin, key, found, allowed, advice)
    }

    /// The error that this key, written at `origin`, is wrong.
    fn error_at(
        &self,
        origin: Origin,
        key: &str,
        found: impl fmt::Display,
        allowed: impl fmt::Display,
        advice: impl fmt::Display,
    ) -> CaseError {
        CaseError::Refused {
            place: match origin {
                Origin::Line(line) => Place::File { path: self.file.clone(), line },
                Origin::Set => Place::Set,
            },
            key: key.into(),
            found: one_line(found),
            allowed: one_line(allowed),
            advice: one_line(advice),
        }
    }
}

/// A message is one line, whatever the value it shows.
fn one_line(text: impl fmt::Display) -> String {
    text.to_string().replace('\n', "\\n").replace('\r', "\\r")
}

impl Node {
    fn child(&self, segment: &Segment) -> Option<&Self> {
        match (&self.value, segment) {
            (Value::Table(table), Segment::Key(key)) => table.get(key),
            (Value::Array(array), Segment::Index(index)) => array.get(*index),
            _ => None,
        }
    }
}

/// Offsets at which the lines of a text begin.
struct Lines(Vec<usize>);

impl Lines {
    fn of(text: &str) -> Self {
        Self(std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect())
    }

    /// Line and column, from 1, of a byte offset.
    fn place(&self, offset: usize, text: &str) -> (usize, usize) {
        let line = self.0.partition_point(|&start| start <= offset);
        let head = text.get(self.0[line - 1]..offset).unwrap_or_default();
        (line, head.chars().count() + 1)
    }
}

fn convert_table(table: &DeTable, origin: &dyn Fn(Range<usize>) -> Origin) -> Value {
    let entry = |key: &toml::Spanned<_>, value: &toml::Spanned<DeValue>| Node {
        value: convert(value.get_ref(), origin),
        origin: origin(key.span()),
    };
    Value::Table(table.iter().map(|(key, value)| (key.get_ref().to_string(), entry(key, value))).collect())
}

fn convert(value: &DeValue, origin: &dyn Fn(Range<usize>) -> Origin) -> Value {
    match value {
        DeValue::String(text) => Value::String(text.to_string()),
        // Beyond i64 it is no whole number a case could mean; as a float it is refused where one is due.
        DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
            .map_or_else(|_| Value::Float(integer.as_str().parse().unwrap_or(f64::INFINITY)), Value::Integer),
        DeValue::Float(float) => Value::Float(float.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(boolean) => Value::Boolean(*boolean),
        DeValue::Datetime(_) => Value::Datetime,
        DeValue::Array(array) => Value::Array(
            array
                .iter()
                .map(|element| Node {
                    value: convert(element.get_ref(), origin),
                    origin: origin(element.span()),
                })
                .collect(),
        ),
        DeValue::Table(table) => convert_table(table, origin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::fixture::{CHANNEL, SETTLING, assert_refusals, resolve};

    #[test]
    fn a_text_that_is_no_toml_is_refused_where_it_breaks() {
        assert_refusals(
            CHANNEL,
            &[
                (
                    "dimension = 2",
                    "dimension = ",
                    "case.toml:3:13: not TOML: string values must be quoted, expected literal string",
                ),
                ("dimension = 2", "dimension = 2\ndimension = 3", "case.toml:4:1: not TOML: duplicate key"),
                ("[time]", "[time", "case.toml:5:6: not TOML: unclosed table, expected `]`"),
            ],
        );
    }

    #[test]
    fn a_wrong_form_is_refused_with_the_right_one() {
        assert_refusals(
            SETTLING,
            &[
                (
                    "normal-law",
                    "normal-lw",
                    "case.toml:16: grains.normal-lw: unknown key; allowed: normal-law, characteristic-velocity, tangential-law, area-factor, rolling-law, twisting-law, lubrication, cohesion-law, domain, escape, periodic, start-overlap, sleep; did you mean \"normal-law\"?",
                ),
                (
                    "[time]",
                    "[tme]",
                    "case.toml:5: tme: unknown key; allowed: case, time, output, materials, pairs, grains, clump, insertion, bond, deletion, wall, fluid, coupling, probe, variants, run; did you mean \"time\"?",
                ),
                ("title = \"settling\"", "", "case.toml:1: case.title: missing; add it to [case]"),
                (
                    "[materials.glass]\ndensity = \"2500 kg/m^3\"",
                    "[materials.glass]",
                    "case.toml:8: materials.glass.density: missing; add it to [materials.glass]",
                ),
                (
                    "dimension = 3",
                    "dimension = 4",
                    "case.toml:3: case.dimension: 4 is not a number of dimensions; allowed: 2, 3; write dimension = 3",
                ),
                (
                    "dimension = 3",
                    "dimension = 3.0",
                    "case.toml:3: case.dimension: found 3.0; allowed: a whole number",
                ),
                ("title = \"settling\"", "title = 5", "case.toml:2: case.title: found 5; allowed: a string"),
                (
                    "gravity = [",
                    "gravity = \"down\" #",
                    "case.toml:4: case.gravity: found the string \"down\"; allowed: an array: [ … ] or [[ ]] tables",
                ),
                (
                    "[grains]\nnormal-law = \"hertz\"",
                    "grains = 1",
                    "case.toml:15: pairs.glass-glass.grains: unknown key; allowed: restitution, sliding-friction, rolling-friction, rolling-damping-ratio, cohesion-energy-density, work-of-adhesion, surface-tension, contact-angle, bridge-volume-ratio",
                ),
                (
                    "normal-law = \"hertz\"",
                    "normal-law = true",
                    "case.toml:16: grains.normal-law: found true; allowed: \"hooke\", \"hertz\", \"onate\", \"liggghts-hooke\", \"liggghts-hertz\", \"none\"",
                ),
                (
                    "plane = {",
                    "plane = 1 #",
                    "case.toml:25: wall[0].plane: found 1; allowed: a table with the keys point, normal",
                ),
                (
                    "[[wall]]",
                    "[wall]",
                    "case.toml:22: wall: found a table; allowed: an array: [ … ] or [[ ]] tables",
                ),
                (
                    "restitution = 0.9",
                    "restitution = \"0.9\"",
                    "case.toml:13: pairs.glass-glass.restitution: found the string \"0.9\"; allowed: a number",
                ),
            ],
        );
    }

    #[test]
    fn a_value_of_many_lines_is_shown_in_one() {
        assert_refusals(
            CHANNEL,
            &[(
                "\"eulerian\"",
                "\"\"\"a\nb\"\"\"",
                "case.toml:8: fluid.backend: unknown backend \"a\\nb\"; allowed: imposed, eulerian, pfem",
            )],
        );
    }

    /// Lines of a sound case are dropped, doubled, swapped and cut, the same way in every run of this test.
    #[test]
    fn a_spoilt_case_ends_in_one_line_and_not_in_a_panic() {
        let mut state = 1_u64;
        let mut draw = |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % below
        };
        let mut refused = 0;
        for _ in 0..2000 {
            let mut lines: Vec<String> = SETTLING.lines().map(String::from).collect();
            for _ in 0..1 + draw(3) {
                let (k, other) = (draw(lines.len()), draw(lines.len()));
                match draw(5) {
                    0 => drop(lines.remove(k)),
                    1 => lines.insert(k, lines[other].clone()),
                    2 => lines.swap(k, other),
                    3 => {
                        let cut = draw(lines[k].len() + 1);
                        lines[k].truncate(cut);
                    }
                    _ => {
                        let junk = ["-", "1e999", "\"\"", "nan", "[", "{}", "0", "\u{fffd}", "'"][draw(9)];
                        let at = draw(lines[k].len() + 1);
                        lines[k].insert_str(at, junk);
                    }
                }
            }
            let text = lines.join("\n");
            if let Err(error) =
                Source::parse(Path::new("case.toml"), &text).and_then(|source| resolve(&source))
            {
                refused += 1;
                let message = error.to_string();
                assert!(
                    message.starts_with("case.toml:") && message.lines().count() == 1,
                    "{message}\n{text}"
                );
            }
        }
        assert!(refused > 1500);
    }

    #[test]
    fn a_value_on_a_line_of_its_own_is_found_there() {
        let at = "at = [[\"0 m\", \"0 m\", \"0.5 m\"], [\"0 m\", \"0 m\", \"0.6 m\"]]";
        assert_refusals(
            SETTLING,
            &[(
                at,
                "at = [\n  [\"0 m\", \"0 m\", \"0.5 m\"],\n  [\"0 m\",\n \"0 m\", \"0.6 mn\"]]",
                "case.toml:24: insertion[0].at[1][2]: unit \"mn\" has an unknown part \"mn\"; write for example \"2.5 mm\" (a length)",
            )],
        );
    }
}
