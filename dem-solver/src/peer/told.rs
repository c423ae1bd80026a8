//! Which keys of a case the decks tell a peer. What is not listed here is refused: a peer would compute without it.

use case_io::document::Case;
use case_io::error::CaseError;
use toml::{Table, Value};

/// Tables, `*` for any name and `[]` for any index, and their keys; a key that is no table here is told with all it
/// holds.
const TOLD: [(&str, &[&str]); 9] = [
    ("", &["case", "time", "output", "materials", "pairs", "grains", "insertion", "wall"]),
    ("grains", &["normal-law", "characteristic-velocity", "domain", "escape", "periodic", "start-overlap"]),
    ("materials", &["*"]),
    ("materials.*", &["density", "youngs-modulus", "poissons-ratio"]),
    ("pairs", &["*"]),
    ("pairs.*", &["restitution", "sliding-friction"]),
    (
        "insertion[]",
        &[
            "name",
            "material",
            "diameter",
            "diameter-range",
            "diameter-distribution",
            "velocity",
            "frozen",
            "at",
            "lattice",
            "random-box",
            "random-sphere",
            "random-cylinder",
            "random-stl",
            "file",
        ],
    ),
    ("wall[]", &["name", "material", "plane", "stl", "obj", "motion", "torque-about"]),
    ("wall[].motion", &["translation", "rotation", "oscillation"]),
];
/// Refuses the first stated key that is not told.
///
/// # Errors
/// That key, and what is allowed in its place.
pub fn refuse_untold(case: &Case, stated: &Table) -> Result<(), CaseError> {
    check(case, stated, "", "")
}

fn check(case: &Case, table: &Table, path: &str, pattern: &str) -> Result<(), CaseError> {
    let Some((_, keys)) = TOLD.iter().find(|(known, _)| *known == pattern) else { return Ok(()) };
    let join =
        |parent: &str, key: &str| if parent.is_empty() { key.to_string() } else { format!("{parent}.{key}") };
    for (key, value) in table {
        let place = join(path, key);
        let any = keys == &["*"];
        if !any && !keys.contains(&key.as_str()) {
            let advice = "leave it out, or compare another case";
            return Err(case.error(&place, "no peer is told of this", keys.join(", "), advice));
        }
        let pattern = join(pattern, if any { "*" } else { key });
        match value {
            Value::Table(inner) => check(case, inner, &place, &pattern)?,
            Value::Array(items) => {
                for (k, inner) in items.iter().enumerate().filter_map(|(k, item)| Some((k, item.as_table()?)))
                {
                    check(case, inner, &format!("{place}[{k}]"), &format!("{pattern}[]"))?;
                }
            }
            _ => {}
        }
    }
    Ok(())
}
