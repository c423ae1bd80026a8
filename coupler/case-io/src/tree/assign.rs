//! Changes of a document by key path: `--set key=value`, and the `set` tables of variants and runs.

use std::collections::BTreeMap;

use toml::de::DeValue;

use super::{KeyPath, Node, Origin, Segment, Source, Value, convert};
use crate::error::CaseError;
use crate::nearest::did_you_mean;

/// Tables whose keys are names: an assignment may change an entry, but not add one, or a slip of the pen would.
const NAMED: [&str; 2] = ["materials", "pairs"];

/// One key and its new value.
pub(crate) struct Assignment {
    key: String,
    node: Node,
}

impl Assignment {
    /// From the command line: `key=value`, the value as in TOML or else a string as it stands.
    pub(crate) fn parse(argument: &str) -> Result<Self, CaseError> {
        let Some((key, text)) = argument.split_once('=') else {
            return Err(CaseError::CommandLine {
                flag: format!("--set {argument}"),
                problem: "no \"=\" found; write --set key=value, for example --set time.end=\"10 s\"".into(),
            });
        };
        let text = text.trim();
        let value = DeValue::parse(text)
            .map_or_else(|_| Value::String(text.into()), |value| convert(value.get_ref(), &|_| Origin::Set));
        Ok(Self { key: key.trim().into(), node: Node { value, origin: Origin::Set } })
    }

    /// All entries of the table at `path` (`variants.full.set`), in the order of their keys.
    pub(crate) fn all(source: &Source, path: &KeyPath) -> Vec<Self> {
        match source.get(path) {
            Some(Node { value: Value::Table(table), .. }) => {
                table.iter().map(|(key, node)| Self { key: key.clone(), node: node.clone() }).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Changes the document. A key that is not in it yet is added: whether there is such a key is found, and
    /// said, when the document is read.
    pub(crate) fn apply(self, source: &mut Source) -> Result<(), CaseError> {
        let origin = self.node.origin;
        match KeyPath::parse(&self.key) {
            None => Err(Refusal::advice("is no key", "write for example time.end or insertion[0].diameter")),
            Some(path) => replace(&mut source.root, &path, self.node),
        }
        .map_err(|refusal| source.error_at(origin, &self.key, refusal.found, refusal.allowed, refusal.advice))
    }
}

#[derive(Default)]
struct Refusal {
    found: String,
    allowed: String,
    advice: String,
}

impl Refusal {
    fn advice(found: impl Into<String>, advice: impl Into<String>) -> Self {
        Self { found: found.into(), advice: advice.into(), ..Self::default() }
    }
}

fn replace(root: &mut Node, path: &KeyPath, new: Node) -> Result<(), Refusal> {
    if matches!(path.0.first(), Some(Segment::Key(key)) if key == "variants" || key == "run") {
        return Err(Refusal::advice("cannot be set", "set a key of the case itself"));
    }
    let mut node = root;
    let mut is_new = false;
    for (depth, segment) in path.0.iter().enumerate() {
        let parent = KeyPath(path.0[..depth].to_vec());
        if is_new && matches!(segment, Segment::Index(_)) {
            return Err(Refusal::advice(
                format!("there is no {parent}"),
                "add it to the case, entries and all",
            ));
        }
        node = match (&mut node.value, segment) {
            (Value::Table(table), Segment::Key(key)) => {
                if NAMED.contains(&parent.to_string().as_str()) && !table.contains_key(key) {
                    let known: Vec<&String> = table.keys().collect();
                    if known.is_empty() {
                        let advice = format!("add [{parent}.{key}] to the case");
                        return Err(Refusal::advice(format!("there is no [{parent}]"), advice));
                    }
                    return Err(Refusal {
                        found: format!("there is no \"{key}\" in [{parent}]"),
                        allowed: known.iter().map(|name| name.as_str()).collect::<Vec<_>>().join(", "),
                        advice: did_you_mean(key, &known),
                    });
                }
                is_new = !table.contains_key(key);
                table
                    .entry(key.clone())
                    .or_insert_with(|| Node { value: Value::Table(BTreeMap::new()), origin: new.origin })
            }
            (Value::Array(array), Segment::Index(index)) => {
                let allowed = match array.len() {
                    0 => format!("none: {parent} is empty"),
                    1 => format!("{parent}[0]"),
                    count => format!("{parent}[0] to {parent}[{}]", count - 1),
                };
                let found = "there is no such entry".into();
                array.get_mut(*index).ok_or(Refusal { found, allowed, advice: String::new() })?
            }
            (Value::Array(_), Segment::Key(_)) => {
                return Err(Refusal::advice(
                    format!("{parent} is an array"),
                    format!("write the number of its entry, from 0: {parent}[0]"),
                ));
            }
            (_, Segment::Index(_)) => return Err(Refusal::advice(format!("{parent} is no array"), "")),
            (_, Segment::Key(_)) => {
                return Err(Refusal::advice(format!("{parent} has no keys"), "set it as a whole"));
            }
        };
    }
    *node = new;
    Ok(())
}
