//! `[variants.*]` and `[[run]]`: named changes of the case.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

/// `[variants.NAME]`: chosen by `--variant NAME`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Variant {
    /// Keys and their values: `{ "time.end" = "10 s" }`.
    pub set: BTreeMap<String, Value>,
}

/// `[[run]]`: one run of a sweep.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Run {
    /// Name of its folder in the output.
    pub name: String,
    /// Keys and their values: `{ "fluid.mesh.box.size" = "2 mm" }`.
    #[serde(default)]
    pub set: BTreeMap<String, Value>,
}
