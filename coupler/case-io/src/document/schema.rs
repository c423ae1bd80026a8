//! The JSON schema of `case.toml`, for editors that complete and check.

use super::Document;

/// The JSON schema of `case.toml`, as it is kept in `docs/case.schema.json`.
pub fn schema() -> String {
    let schema = schemars::schema_for!(Document);
    // `{:#}` of a JSON value: indented, keys as schemars orders them.
    format!("{:#}\n", schema.as_value())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `UPDATE_SCHEMA=1 cargo test -p case-io schema` writes it anew.
    #[test]
    fn the_schema_in_the_documentation_is_current() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/case.schema.json");
        if std::env::var_os("UPDATE_SCHEMA").is_some() {
            std::fs::write(path, schema()).unwrap();
        }
        let kept = std::fs::read_to_string(path).unwrap_or_default();
        assert!(
            kept == schema(),
            "docs/case.schema.json is out of date: UPDATE_SCHEMA=1 cargo test -p case-io schema"
        );
    }

    #[test]
    fn every_table_refuses_unknown_keys_and_every_key_is_described() {
        let value: serde_json::Value = serde_json::from_str(&schema()).unwrap();
        let definitions = value["$defs"].as_object().unwrap();
        let tables: Vec<_> = definitions
            .iter()
            .chain([(&"Document".to_string(), &value)])
            .filter(|(_, definition)| definition.get("properties").is_some())
            .map(|(name, definition)| (name.clone(), definition.clone()))
            .collect();
        assert!(tables.len() > 20);
        for (name, table) in tables {
            assert_eq!(table["additionalProperties"], false, "{name}");
            for (key, property) in table["properties"].as_object().unwrap() {
                assert!(property.get("description").is_some(), "{name}.{key} has no description");
            }
        }
    }
}
