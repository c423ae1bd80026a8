//! A number with a physical dimension, written with its unit and held in SI.

use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error, Visitor};
use serde::{Serialize, Serializer};

use super::unit::{Exponents, parse};

/// The fewest digits that read back to the same number.
pub(crate) fn digits(value: f64) -> String {
    let mut digits = format!("{value:?}");
    if digits.ends_with(".0") {
        digits.truncate(digits.len() - 2);
    }
    digits
}

/// What a quantity measures: its name, dimension, SI unit and an example of how it is written.
pub trait Kind: Copy + PartialEq + fmt::Debug + 'static {
    /// Name with its article, as messages use it: `"a length"`.
    const NAME: &'static str;
    /// Exponents of metre, kilogram, second and radian.
    const EXPONENTS: Exponents;
    /// The SI unit, in the case's own notation.
    const SI_UNIT: &'static str;
    /// A usual unit, for examples in messages.
    const USUAL_UNIT: &'static str;
}

/// A finite value in SI whose unit was checked against `K` when it was read.
#[derive(Clone, Copy, PartialEq)]
pub struct Quantity<K> {
    si: f64,
    kind: PhantomData<K>,
}

impl<K> Quantity<K> {
    /// The quantity of `si` SI units.
    pub const fn from_si(si: f64) -> Self {
        Self { si, kind: PhantomData }
    }

    /// The value in SI units.
    pub const fn si(self) -> f64 {
        self.si
    }
}

impl<K: Kind> fmt::Display for Quantity<K> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} {}", digits(self.si), K::SI_UNIT)
    }
}

impl<K: Kind> fmt::Debug for Quantity<K> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<K: Kind> Serialize for Quantity<K> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de, K: Kind> Deserialize<'de> for Quantity<K> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(QuantityVisitor(PhantomData))
    }
}

pub(super) struct QuantityVisitor<K>(pub PhantomData<K>);

impl<K: Kind> QuantityVisitor<K> {
    fn bare<E: Error>(value: impl fmt::Display) -> E {
        E::custom(format_args!(
            "value {value} has no unit; write \"{value} {}\" ({})",
            K::USUAL_UNIT,
            K::NAME
        ))
    }
}

impl<K: Kind> Visitor<'_> for QuantityVisitor<K> {
    type Value = Quantity<K>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} with its unit, for example \"2.5 {}\"", K::NAME, K::USUAL_UNIT)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
        parse::<K>(text).map(Quantity::from_si).map_err(E::custom)
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Self::Value, E> {
        Err(Self::bare(value))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Self::Value, E> {
        Err(Self::bare(value))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Self::Value, E> {
        Err(Self::bare(digits(value)))
    }
}

impl<K: Kind> JsonSchema for Quantity<K> {
    fn inline_schema() -> bool {
        false
    }

    fn schema_name() -> Cow<'static, str> {
        K::NAME.trim_start_matches("an ").trim_start_matches("a ").replace(' ', "-").into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "string",
            "description": format!("{} with its unit; SI unit {}", K::NAME, K::SI_UNIT),
            "examples": [format!("2.5 {}", K::USUAL_UNIT)],
        })
    }
}

macro_rules! kinds {
    ($($name:ident, $words:literal, [$m:literal, $kg:literal, $s:literal, $rad:literal], $si:literal, $usual:literal;)*) => {
        /// The kinds of quantity a case may state.
        pub mod kind {
            use super::{Exponents, Kind};
            $(
                #[doc = concat!("Marks ", $words, ", in ", $si, ".")]
                #[derive(Clone, Copy, Debug, PartialEq)]
                pub enum $name {}

                impl Kind for $name {
                    const NAME: &'static str = $words;
                    const EXPONENTS: Exponents = Exponents([$m, $kg, $s, $rad]);
                    const SI_UNIT: &'static str = $si;
                    const USUAL_UNIT: &'static str = $usual;
                }
            )*
        }
        $(
            #[doc = concat!(stringify!($name), ": ", $words, ", in ", $si, ".")]
            pub type $name = Quantity<kind::$name>;
        )*
        /// Name with article, exponents and usual unit of every kind.
        pub(super) const KINDS: &[(&str, Exponents, &str)] =
            &[$((kind::$name::NAME, kind::$name::EXPONENTS, kind::$name::USUAL_UNIT)),*];
    };
}

kinds! {
    Length, "a length", [1, 0, 0, 0], "m", "mm";
    Time, "a time", [0, 0, 1, 0], "s", "s";
    Velocity, "a velocity", [1, 0, -1, 0], "m/s", "m/s";
    Acceleration, "an acceleration", [1, 0, -2, 0], "m/s^2", "m/s^2";
    Density, "a density", [-3, 1, 0, 0], "kg/m^3", "kg/m^3";
    Pressure, "a pressure", [-1, 1, -2, 0], "Pa", "Pa";
    Viscosity, "a dynamic viscosity", [-1, 1, -1, 0], "Pa s", "mPa s";
    SurfaceEnergy, "a surface energy", [0, 1, -2, 0], "J/m^2", "mJ/m^2";
    Force, "a force", [1, 1, -2, 0], "N", "N";
    Mass, "a mass", [0, 1, 0, 0], "kg", "g";
    Angle, "an angle", [0, 0, 0, 1], "rad", "deg";
    AngularVelocity, "an angular velocity", [0, 0, -1, 1], "rad/s", "rad/s";
    MassRate, "a mass rate", [0, 1, -1, 0], "kg/s", "kg/s";
    NumberRate, "a number rate", [0, 0, -1, 0], "1/s", "1/s";
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::fixture::{SETTLING, assert_refusals};

    #[test]
    fn a_quantity_is_written_as_it_is_read() {
        for si in [0.0, 1.0, -0.0025, 1e-15, 1.0 / 3.0, 6.02e23, f64::MIN_POSITIVE, f64::MAX] {
            let text = serde_json::to_string(&Viscosity::from_si(si)).unwrap();
            let read: Viscosity = serde_json::from_str(&text).unwrap();
            assert_eq!(read.si().to_bits(), si.to_bits(), "{text}");
        }
    }

    #[test]
    fn a_bare_number_is_refused_with_the_way_to_write_it() {
        assert_refusals(
            SETTLING,
            &[
                ("\"2 s\"", "2.5", "case.toml:6: time.end: value 2.5 has no unit; write \"2.5 s\" (a time)"),
                (
                    "\"2 mm\"",
                    "2",
                    "case.toml:20: insertion[0].diameter: value 2 has no unit; write \"2 mm\" (a length)",
                ),
                (
                    "\"2 mm\"",
                    "-2e-3",
                    "case.toml:20: insertion[0].diameter: value -0.002 has no unit; write \"-0.002 mm\" (a length)",
                ),
                (
                    "\"2 mm\"",
                    "nan",
                    "case.toml:20: insertion[0].diameter: found NaN; allowed: finite numbers",
                ),
                (
                    "\"2 mm\"",
                    "true",
                    "case.toml:20: insertion[0].diameter: found true; allowed: a length with its unit, for example \"2.5 mm\"",
                ),
                (
                    "\"2 mm\"",
                    "1979-05-27",
                    "case.toml:20: insertion[0].diameter: found a date; allowed: a length with its unit, for example \"2.5 mm\"",
                ),
                (
                    "\"2 mm\"",
                    "\"2\"",
                    "case.toml:20: insertion[0].diameter: value 2 has no unit; write \"2 mm\" (a length)",
                ),
            ],
        );
    }

    #[test]
    fn every_kind_reads_its_own_units_and_no_two_kinds_are_one() {
        for (index, (name, exponents, _)) in KINDS.iter().enumerate() {
            assert!(KINDS[..index].iter().all(|(_, other, _)| other != exponents), "{name}");
        }
        fn reads<K: Kind>() {
            for unit in [K::SI_UNIT, K::USUAL_UNIT] {
                parse::<K>(&format!("1 {unit}")).unwrap();
            }
            assert_eq!(parse::<K>(&format!("1 {}", K::SI_UNIT)), Ok(1.0));
        }
        reads::<kind::Length>();
        reads::<kind::Time>();
        reads::<kind::Velocity>();
        reads::<kind::Acceleration>();
        reads::<kind::Density>();
        reads::<kind::Pressure>();
        reads::<kind::Viscosity>();
        reads::<kind::SurfaceEnergy>();
        reads::<kind::Force>();
        reads::<kind::Mass>();
        reads::<kind::Angle>();
        reads::<kind::AngularVelocity>();
        reads::<kind::MassRate>();
        reads::<kind::NumberRate>();
    }
}
