//! `[[fluid.boundary]]`: what holds on the boundaries of the fluid mesh.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};

use super::quantity::{Pressure, Velocity};
use super::vector::VelocityVector;
use crate::expression::Expression;

/// `[[fluid.boundary]]`
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Boundary {
    /// Names of mesh boundaries, each of which is named exactly once over all tables; with `pfem` also of walls.
    pub on: Vec<String>,
    /// What holds there.
    pub kind: BoundaryKind,
    /// Velocity of the wall (`moving-wall`), or of the fluid (`inlet`): the superficial one, n_f u, where grains are.
    pub velocity: Option<BoundaryVelocity>,
    /// Mean superficial speed n_f u along the inward normal (`inlet`, instead of `velocity`).
    pub speed: Option<Velocity>,
    /// Profile of `speed`; default constant.
    pub profile: Option<Profile>,
    /// Pressure (`outlet`); default 0 Pa.
    pub pressure: Option<Pressure>,
}

/// What holds on a boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BoundaryKind {
    /// The fluid sticks to a wall at rest.
    NoSlip,
    /// The fluid slides along a wall without friction.
    Slip,
    /// The fluid slides along a wall with the friction of a law of the wall, of Werner and Wengle (`pfem` only).
    WallFunction,
    /// The velocity is stated.
    Inlet,
    /// The pressure is stated.
    Outlet,
    /// The fluid sticks to a wall that moves in itself.
    MovingWall,
    /// Nothing holds the fluid (`pfem` only): the boundary is where it begins, and free.
    FreeSurface,
}

/// Profile of an inlet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Profile {
    /// The same everywhere.
    #[default]
    Constant,
    /// Zero at the rim, as in developed laminar flow, with the stated mean.
    Parabolic,
}

/// A velocity: a vector of quantities, or `{ expression = ["…", …] }` of x, y, z, t in SI.
#[derive(Clone, Debug)]
pub enum BoundaryVelocity {
    /// The same everywhere and always.
    Constant(VelocityVector),
    /// One expression in m/s for each dimension.
    Expression(Vec<Expression>),
}

#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Expressions {
    /// One expression in m/s for each dimension.
    expression: Vec<Expression>,
}

impl Serialize for BoundaryVelocity {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Constant(vector) => vector.serialize(serializer),
            Self::Expression(expression) => {
                Expressions { expression: expression.clone() }.serialize(serializer)
            }
        }
    }
}

impl<'de> Deserialize<'de> for BoundaryVelocity {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(BoundaryVelocityVisitor)
    }
}

struct BoundaryVelocityVisitor;

impl<'de> Visitor<'de> for BoundaryVelocityVisitor {
    type Value = BoundaryVelocity;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a vector such as [\"1 m/s\", \"0 m/s\"] or { expression = [\"1-y^2\", \"0\"] }")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, sequence: A) -> Result<Self::Value, A::Error> {
        VelocityVector::deserialize(SeqAccessDeserializer::new(sequence)).map(BoundaryVelocity::Constant)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
        Expressions::deserialize(MapAccessDeserializer::new(map))
            .map(|expressions| BoundaryVelocity::Expression(expressions.expression))
    }
}

impl JsonSchema for BoundaryVelocity {
    fn schema_name() -> Cow<'static, str> {
        "BoundaryVelocity".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A vector of velocities, or expressions of x, y, z, t in SI.",
            "oneOf": [
                generator.subschema_for::<VelocityVector>(),
                generator.subschema_for::<Expressions>(),
            ],
        })
    }
}
