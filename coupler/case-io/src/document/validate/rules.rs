//! The rules that many keys share.

use std::fmt::Display;

use crate::document::quantity::{Kind, Quantity, digits};
use crate::document::{Axis, Dimension, Vector};
use crate::error::CaseError;
use crate::nearest::did_you_mean;
use crate::tree::Source;

type Verdict = Result<(), CaseError>;

pub(super) struct Rules<'a> {
    pub source: &'a Source,
    pub dimension: Dimension,
}

impl Rules<'_> {
    pub(super) fn refuse<T>(
        &self,
        key: &str,
        found: impl Display,
        allowed: impl Display,
        advice: impl Display,
    ) -> Result<T, CaseError> {
        Err(self.source.error(key, found, allowed, advice))
    }

    /// The key must be there, because of `reason`.
    pub(super) fn required(&self, key: &str, reason: impl Display) -> Verdict {
        if self.source.has(key) { Ok(()) } else { self.refuse(key, "missing", "", reason) }
    }

    /// The key must not be there: `reason` says why it would have no effect.
    pub(super) fn no_effect(&self, key: &str, reason: impl Display) -> Verdict {
        if self.source.has(key) {
            self.refuse(key, format_args!("has no effect {reason}"), "", "delete it")
        } else {
            Ok(())
        }
    }

    /// Exactly one of these keys of a table must be there.
    pub(super) fn exactly_one(&self, table: &str, keys: &[&str]) -> Verdict {
        let given: Vec<&str> =
            keys.iter().copied().filter(|key| self.source.has(&format!("{table}.{key}"))).collect();
        let found = match given.as_slice() {
            [_] => return Ok(()),
            [] => "none of these keys is given".to_string(),
            _ => format!("{} exclude each other", given.join(" and ")),
        };
        self.refuse(table, found, format_args!("exactly one of {}", keys.join(", ")), "")
    }

    pub(super) fn positive<K: Kind>(&self, key: &str, value: Quantity<K>) -> Verdict {
        if value.si() > 0.0 {
            return Ok(());
        }
        self.refuse(key, format_args!("found {value}"), format_args!("more than 0 {}", K::SI_UNIT), "")
    }

    pub(super) fn optional_positive<K: Kind>(&self, key: &str, value: Option<Quantity<K>>) -> Verdict {
        value.map_or(Ok(()), |value| self.positive(key, value))
    }

    pub(super) fn optional_not_negative<K: Kind>(&self, key: &str, value: Option<Quantity<K>>) -> Verdict {
        match value {
            Some(value) if value.si() < 0.0 => {
                self.refuse(key, format_args!("found {value}"), format_args!("0 {} or more", K::SI_UNIT), "")
            }
            _ => Ok(()),
        }
    }

    /// A bare number for which `holds`, which `allowed` says in words.
    pub(super) fn number(&self, key: &str, value: f64, holds: bool, allowed: &str) -> Verdict {
        if holds { Ok(()) } else { self.refuse(key, format_args!("found {}", digits(value)), allowed, "") }
    }

    pub(super) fn vector<K: Kind>(&self, key: &str, vector: &Vector<K>) -> Verdict {
        self.components(key, vector.len())
    }

    pub(super) fn optional_vector<K: Kind>(&self, key: &str, vector: Option<&Vector<K>>) -> Verdict {
        vector.map_or(Ok(()), |vector| self.vector(key, vector))
    }

    /// As many components as the case has dimensions.
    pub(super) fn components(&self, key: &str, found: usize) -> Verdict {
        let wanted = self.dimension.count();
        if found == wanted {
            return Ok(());
        }
        self.refuse(
            key,
            format_args!("found {found} components"),
            wanted,
            format_args!("case.dimension is {wanted}"),
        )
    }

    /// The corners `lower` and `upper` of the box in `table`.
    pub(super) fn corners<K: Kind>(&self, table: &str, lower: &Vector<K>, upper: &Vector<K>) -> Verdict {
        self.vector(&format!("{table}.lower"), lower)?;
        self.vector(&format!("{table}.upper"), upper)?;
        let (lower, upper) = (lower.to_array::<3>(), upper.to_array::<3>());
        for axis in 0..self.dimension.count() {
            if lower[axis] >= upper[axis] {
                return self.refuse(
                    &format!("{table}.upper[{axis}]"),
                    format_args!("found {}", Quantity::<K>::from_si(upper[axis])),
                    format_args!("more than lower, {}", Quantity::<K>::from_si(lower[axis])),
                    "",
                );
            }
        }
        Ok(())
    }

    /// Axes of this case, each once.
    pub(super) fn axes(&self, key: &str, axes: &[Axis]) -> Verdict {
        for (index, axis) in axes.iter().enumerate() {
            let key = format!("{key}[{index}]");
            if axis.index() >= self.dimension.count() {
                return self.refuse(&key, "found z in 2D", "x, y", "");
            }
            if axes[..index].contains(axis) {
                return self.refuse(&key, "this axis is named twice", "", "delete one");
            }
        }
        Ok(())
    }

    /// `found` must be one of the `known`; `noun` says what they are.
    pub(super) fn known(&self, key: &str, noun: &str, found: &str, known: &[&str]) -> Verdict {
        if known.contains(&found) {
            return Ok(());
        }
        self.refuse(
            key,
            format_args!("there is no {noun} \"{found}\""),
            known.join(", "),
            did_you_mean(found, known),
        )
    }

    /// Names are well formed, and each is given once; `keys` and names go together.
    pub(super) fn names<'a>(&self, table: &str, names: impl Iterator<Item = &'a str>) -> Verdict {
        let mut earlier = Vec::new();
        for (index, found) in names.enumerate() {
            let key = format!("{table}[{index}].name");
            check_name(self.source, &key, found)?;
            if earlier.contains(&found) {
                return self.refuse(
                    &key,
                    format_args!("\"{found}\" names two of [[{table}]]"),
                    "",
                    "rename one",
                );
            }
            earlier.push(found);
        }
        Ok(())
    }
}

/// Names go into paths, columns and file names.
pub(in crate::document) fn check_name(source: &Source, key: &str, found: &str) -> Result<(), CaseError> {
    if !found.is_empty() && found.chars().all(is_plain) {
        return Ok(());
    }
    Err(source.error(key, format_args!("found the name \"{found}\""), "letters, digits, - and _", ""))
}

/// Names of runs go into paths only: a point may stand inside, as in `h1.5`.
pub(in crate::document) fn check_run_name(source: &Source, key: &str, found: &str) -> Result<(), CaseError> {
    let starts_well = found.starts_with(is_plain);
    if starts_well && found.chars().all(|c| is_plain(c) || c == '.') {
        return Ok(());
    }
    let allowed = "letters, digits, -, _ and, not at the start, .";
    Err(source.error(key, format_args!("found the name \"{found}\""), allowed, ""))
}

fn is_plain(c: char) -> bool {
    c.is_alphanumeric() || c == '-' || c == '_'
}
