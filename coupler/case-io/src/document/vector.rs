//! Vectors of quantities, axes and boxes, with as many components as the case has dimensions.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use super::quantity::{Kind, Quantity, kind};

/// A vector of `case.dimension` components of one kind (the number is checked when the case is loaded).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
#[serde(bound = "K: Kind")]
pub struct Vector<K: Kind>(Vec<Quantity<K>>);

/// A point.
pub type Point = Vector<kind::Length>;
/// A velocity vector.
pub type VelocityVector = Vector<kind::Velocity>;
/// An acceleration vector.
pub type AccelerationVector = Vector<kind::Acceleration>;

impl<K: Kind> Vector<K> {
    /// The vector of these SI values.
    pub fn from_si(components: &[f64]) -> Self {
        Self(components.iter().map(|&si| Quantity::from_si(si)).collect())
    }

    /// Number of components as written.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is no component.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The first `D` components in SI; 0 where the case has fewer (z in 2D).
    pub fn to_array<const D: usize>(&self) -> [f64; D] {
        std::array::from_fn(|axis| self.0.get(axis).map_or(0.0, |component| component.si()))
    }
}

impl<K: Kind> JsonSchema for Vector<K> {
    fn schema_name() -> Cow<'static, str> {
        format!("{}-vector", Quantity::<K>::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "array",
            "description": "as many components as case.dimension",
            "items": generator.subschema_for::<Quantity<K>>(),
            "minItems": 2,
            "maxItems": 3,
        })
    }
}

/// One axis of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// The first axis.
    X,
    /// The second axis.
    Y,
    /// The third axis (3D only).
    Z,
}

impl Axis {
    /// 0, 1 or 2.
    pub fn index(self) -> usize {
        self as usize
    }
}

/// An axis-aligned box.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Bounds {
    /// The corner of smallest coordinates.
    pub lower: Point,
    /// The corner of largest coordinates.
    pub upper: Point,
}

/// Edge lengths of a box between two corners, in m.
pub(super) fn extent(lower: &Point, upper: &Point) -> [f64; 3] {
    let (lower, upper) = (lower.to_array::<3>(), upper.to_array::<3>());
    std::array::from_fn(|axis| upper[axis] - lower[axis])
}

/// The vector of length 1 in a direction stated with bare numbers, its first `D` components.
pub fn unit_vector<const D: usize>(direction: &[f64]) -> [f64; D] {
    let largest = direction.iter().fold(0.0, |largest: f64, n| largest.max(n.abs()));
    let length = largest * direction.iter().map(|n| (n / largest).powi(2)).sum::<f64>().sqrt();
    std::array::from_fn(|axis| direction.get(axis).map_or(0.0, |n| n / length))
}

/// A positive bare factor that turns a file's lengths into metres.
pub(super) fn one() -> f64 {
    1.0
}
