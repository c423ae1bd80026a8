//! The case as this program computes it beside a peer: with all changes applied, and a window, a row and, where
//! trajectories are asked for, a frame for each sample.

use case_io::document::Case;
use case_io::error::CaseError;
use toml::{Table, Value};

use super::task::{Recording, Task};

/// The text of its `case.toml`.
///
/// # Errors
/// A document that cannot be written as TOML.
pub fn own_case(case: &Case, task: &Task) -> Result<String, CaseError> {
    let unwritable =
        |error: String| case.error("case", format_args!("cannot be written as TOML: {error}"), "", "");
    let mut document = Table::try_from(&case.document).map_err(|error| unwritable(error.to_string()))?;
    keep_stated(case, "", &mut document);
    let folder = std::path::absolute(&case.folder).unwrap_or_else(|_| case.folder.clone());
    for (key, path) in case.document.files() {
        let path = folder.join(path).to_string_lossy().into_owned();
        if let Some(value) = at(&mut document, &key) {
            *value = path.into();
        }
    }
    let seconds = |time: f64| Value::from(format!("{time} s"));
    let interval = task.interval();
    let frames = match task.recording {
        Recording::Trajectories => seconds(interval),
        Recording::Statistics => "none".into(),
    };
    let time = [
        ("end", seconds(interval * f64::from(task.samples))),
        ("window", seconds(interval)),
        // A rounding longer, lest a window get one more.
        ("substep", seconds(task.step * (1.0 + 1e-9))),
    ];
    let output = [("series", seconds(interval)), ("frames", frames), ("restart", "none".into())];
    for (name, keys) in [("time", time), ("output", output)] {
        let keys = keys.map(|(key, value)| (key.to_string(), value));
        document.insert(name.into(), Table::from_iter(keys).into());
    }
    Ok(document.to_string())
}

/// The document as the case states it, with all changes applied.
///
/// # Errors
/// A document that cannot be written as TOML.
pub fn stated(case: &Case) -> Result<Table, CaseError> {
    let mut document = Table::try_from(&case.document)
        .map_err(|error| case.error("case", format_args!("cannot be written as TOML: {error}"), "", ""))?;
    keep_stated(case, "", &mut document);
    Ok(document)
}

/// Leaves out what the case leaves to its default: stated, a default without effect would be refused.
fn keep_stated(case: &Case, path: &str, table: &mut Table) {
    let joined = |key: &str| if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
    table.retain(|key, _| case.states(&joined(key)));
    for (key, value) in table.iter_mut() {
        let path = joined(key);
        match value {
            Value::Table(inner) => keep_stated(case, &path, inner),
            Value::Array(items) => {
                let tables =
                    items.iter_mut().enumerate().filter_map(|(k, item)| Some((k, item.as_table_mut()?)));
                tables.for_each(|(k, inner)| keep_stated(case, &format!("{path}[{k}]"), inner));
            }
            _ => {}
        }
    }
}

/// The value at a path such as `wall[0].stl.path`.
fn at<'a>(document: &'a mut Table, path: &str) -> Option<&'a mut Value> {
    let mut parts = path.split(['.', '[']);
    let first = document.get_mut(parts.next()?)?;
    parts.try_fold(first, |value, part| match part.strip_suffix(']') {
        Some(index) => value.get_mut(index.parse::<usize>().ok()?),
        None => value.get_mut(part),
    })
}
