//! `[case]`: what the case is about.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Length;
use super::vector::AccelerationVector;

/// `[case]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct CaseTable {
    /// One line that names the case in reports.
    pub title: String,
    /// Number of space dimensions: 2 (a slab of stated depth, grains are discs) or 3.
    pub dimension: Dimension,
    /// Depth of the slab (2D only); default 1 m.
    pub depth: Option<Length>,
    /// Acceleration of gravity.
    pub gravity: AccelerationVector,
    /// Seed of random insertion and mesh jitter.
    #[serde(default = "default_seed")]
    pub seed: u64,
}

impl CaseTable {
    /// Depth of the slab in m: 1 unless stated (and 1 in 3D, where nothing uses it).
    pub fn depth(&self) -> f64 {
        self.depth.map_or(1.0, Length::si)
    }
}

fn default_seed() -> u64 {
    1
}

/// Number of space dimensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "i64", into = "i64")]
pub enum Dimension {
    /// A slab of stated depth: grains are discs of that length.
    Two,
    /// Space: grains are spheres.
    Three,
}

impl Dimension {
    /// 2 or 3.
    pub fn count(self) -> usize {
        match self {
            Self::Two => 2,
            Self::Three => 3,
        }
    }
}

impl TryFrom<i64> for Dimension {
    type Error = String;

    fn try_from(count: i64) -> Result<Self, String> {
        match count {
            2 => Ok(Self::Two),
            3 => Ok(Self::Three),
            _ => Err(format!("{count} is not a number of dimensions; allowed: 2, 3; write dimension = 3")),
        }
    }
}

impl From<Dimension> for i64 {
    fn from(dimension: Dimension) -> Self {
        dimension.count() as Self
    }
}

impl JsonSchema for Dimension {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Dimension".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({ "type": "integer", "enum": [2, 3], "description": "Number of space dimensions." })
    }
}
