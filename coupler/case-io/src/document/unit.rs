//! Units: SI prefixes, products, quotients and integer powers, reduced to SI base units.
//!
//! Powers of ten are kept apart from other factors and joined with the number's own exponent before it is
//! converted, so `"2.5 mm"` has the very bits of `0.0025`.

use std::fmt;

use super::quantity::{KINDS, Kind};

/// Exponents of metre, kilogram, second and radian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exponents(pub [i8; 4]);

impl Exponents {
    /// The name of this dimension where it has one, else its base units.
    fn describe(self) -> String {
        match KINDS.iter().find(|(_, exponents, _)| *exponents == self) {
            Some((name, ..)) => format!("{name} ({self})"),
            None if self.0 == [0; 4] => "a number without unit".into(),
            None => format!("in {self}"),
        }
    }
}

impl fmt::Display for Exponents {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let mut separator = "";
        for (symbol, exponent) in ["m", "kg", "s", "rad"].iter().zip(self.0) {
            match exponent {
                0 => continue,
                1 => write!(f, "{separator}{symbol}")?,
                _ => write!(f, "{separator}{symbol}^{exponent}")?,
            }
            separator = " ";
        }
        Ok(())
    }
}

/// A unit: `factor · 10^decade` SI base units.
#[derive(Clone, Copy)]
struct Unit {
    exponents: [i8; 4],
    decade: i32,
    factor: f64,
}

/// Symbol, exponents of m kg s rad, decade, factor, whether it takes prefixes.
const UNITS: &[(&str, [i8; 4], i32, f64, bool)] = &[
    ("m", [1, 0, 0, 0], 0, 1.0, true),
    ("g", [0, 1, 0, 0], -3, 1.0, true),
    ("s", [0, 0, 1, 0], 0, 1.0, true),
    ("min", [0, 0, 1, 0], 0, 60.0, false),
    ("h", [0, 0, 1, 0], 0, 3600.0, false),
    ("rad", [0, 0, 0, 1], 0, 1.0, true),
    ("deg", [0, 0, 0, 1], 0, std::f64::consts::PI / 180.0, false),
    ("°", [0, 0, 0, 1], 0, std::f64::consts::PI / 180.0, false),
    ("Hz", [0, 0, -1, 0], 0, 1.0, true),
    ("N", [1, 1, -2, 0], 0, 1.0, true),
    ("Pa", [-1, 1, -2, 0], 0, 1.0, true),
    ("bar", [-1, 1, -2, 0], 5, 1.0, true),
    ("P", [-1, 1, -1, 0], -1, 1.0, true),
    ("J", [2, 1, -2, 0], 0, 1.0, true),
    ("W", [2, 1, -3, 0], 0, 1.0, true),
    ("l", [3, 0, 0, 0], -3, 1.0, true),
    ("L", [3, 0, 0, 0], -3, 1.0, true),
    ("t", [0, 1, 0, 0], 3, 1.0, false),
];

const PREFIXES: &[(&str, i32)] = &[
    ("p", -12),
    ("n", -9),
    ("u", -6),
    ("µ", -6), // micro sign
    ("μ", -6), // Greek mu
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

fn symbol(text: &str) -> Option<Unit> {
    let find = |name: &str, prefixed: bool| {
        UNITS
            .iter()
            .find(|unit| unit.0 == name && (!prefixed || unit.4))
            .map(|&(_, exponents, decade, factor, _)| Unit { exponents, decade, factor })
    };
    find(text, false).or_else(|| {
        PREFIXES.iter().find_map(|(prefix, decade)| {
            let unit = find(text.strip_prefix(prefix)?, true)?;
            Some(Unit { decade: unit.decade + decade, ..unit })
        })
    })
}

impl Unit {
    const ONE: Self = Self { exponents: [0; 4], decade: 0, factor: 1.0 };

    /// `self · other^power`, or nothing if an exponent leaves the range any physical unit has.
    fn times(self, other: Self, power: i32) -> Option<Self> {
        let mut exponents = self.exponents;
        for (mine, theirs) in exponents.iter_mut().zip(other.exponents) {
            *mine = i8::try_from(i32::from(*mine) + i32::from(theirs) * power).ok()?;
        }
        Some(Self {
            exponents,
            decade: self.decade + other.decade * power,
            factor: self.factor * other.factor.powi(power),
        })
    }
}

/// Reads a unit from left to right.
struct Reader<'a> {
    rest: &'a str,
    /// Open parentheses.
    depth: usize,
}

impl<'a> Reader<'a> {
    fn take_while(&mut self, keep: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|c| !keep(c)).unwrap_or(self.rest.len());
        let (head, tail) = self.rest.split_at(end);
        self.rest = tail;
        head
    }

    fn take(&mut self, wanted: &[char]) -> bool {
        match self.rest.strip_prefix(wanted) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// product := factor { ("*" | "·" | "." | " " | "/") factor }
    fn product(&mut self) -> Result<Unit, String> {
        let mut unit = Unit::ONE;
        let (mut power, mut divided) = (1, false);
        loop {
            self.take_while(char::is_whitespace);
            let factor = self.factor()?;
            unit = unit.times(factor, power).ok_or("has an exponent that is too large")?;
            self.take_while(char::is_whitespace);
            if self.rest.is_empty() || self.rest.starts_with(')') {
                return Ok(unit);
            }
            if self.take(&['/']) {
                (power, divided) = (-1, true);
            } else if divided {
                return Err("has a product after a quotient, which can be read in two ways".into());
            } else {
                self.take(&['*', '·', '⋅', '.']);
            }
        }
    }

    /// factor := "(" product ")" | "1" | symbol [ ["^"] integer ]
    fn factor(&mut self) -> Result<Unit, String> {
        let base = if self.take(&['(']) {
            self.depth += 1;
            if self.depth > 8 {
                return Err("has too many parentheses".into());
            }
            let inner = self.product()?;
            self.depth -= 1;
            if !self.take(&[')']) {
                return Err("has an unclosed parenthesis".into());
            }
            inner
        } else if self.take(&['1']) {
            return Ok(Unit::ONE);
        } else {
            let name = self.take_while(|c| c.is_alphabetic() || c == '°');
            if name.is_empty() {
                return Err("is not complete".into());
            }
            symbol(name).ok_or_else(|| format!("has an unknown part \"{name}\""))?
        };
        let caret = self.take(&['^']);
        let exponent: String = self
            .take_while(|c| c.is_ascii_digit() || "-+⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c))
            .chars()
            .map(|c| match "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|s| s == c) {
                Some(digit) => char::from(b'0' + digit as u8),
                None if c == '⁻' => '-',
                None => c,
            })
            .collect();
        if exponent.is_empty() && !caret {
            return Ok(base);
        }
        match exponent.parse() {
            Ok(power @ -9..=9) => {
                Unit::ONE.times(base, power).ok_or("has an exponent that is too large".into())
            }
            _ => Err("has a power that is not an integer from -9 to 9".into()),
        }
    }
}

/// Splits a decimal number from what follows it: (mantissa, decimal exponent, rest).
fn split_number(text: &str) -> Option<(&str, i32, &str)> {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let sign = usize::from(text.starts_with(['+', '-']));
    let whole = digits(sign);
    let mut end = sign + whole;
    let mut fraction = 0;
    if text[end..].starts_with('.') {
        fraction = digits(end + 1);
        end += 1 + fraction;
    }
    if whole + fraction == 0 {
        return None;
    }
    let mantissa = &text[..end];
    if text[end..].starts_with(['e', 'E']) {
        let signed = end + 1 + usize::from(text[end + 1..].starts_with(['+', '-']));
        let length = digits(signed);
        if length > 0 {
            let exponent = text[end + 1..signed + length].parse().ok()?;
            return Some((mantissa, exponent, &text[signed + length..]));
        }
    }
    Some((mantissa, 0, &text[end..]))
}

/// The SI value of `text`, a number and a unit of the kind `K`, or what is wrong and how to write it.
pub(super) fn parse<K: Kind>(text: &str) -> Result<f64, String> {
    let example = format!("for example \"2.5 {}\" ({})", K::USUAL_UNIT, K::NAME);
    let text = text.trim();
    let (mantissa, exponent, rest) = split_number(text).ok_or_else(|| {
        format!("\"{text}\" does not start with a finite number; write a number and a unit, {example}")
    })?;
    let name = rest.trim();
    if name.is_empty() {
        return Err(format!("value {text} has no unit; write \"{text} {}\" ({})", K::USUAL_UNIT, K::NAME));
    }
    let mut reader = Reader { rest: name, depth: 0 };
    let unit = match reader.product() {
        Ok(unit) if reader.rest.is_empty() => unit,
        Ok(_) => return Err(format!("unit \"{name}\" has a parenthesis too many; write {example}")),
        Err(problem) => return Err(format!("unit \"{name}\" {problem}; write {example}")),
    };
    let found = Exponents(unit.exponents);
    if found != K::EXPONENTS {
        return Err(format!("\"{text}\" is {}, not {}; write {example}", found.describe(), K::NAME));
    }
    let decade = exponent.saturating_add(unit.decade);
    let number: f64 =
        format!("{mantissa}e{decade}").parse().map_err(|_| format!("\"{text}\" is not a number"))?;
    let value = number * unit.factor;
    if value.is_finite() {
        Ok(value)
    } else {
        Err(format!("\"{text}\" is too large for a number; write {example}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::quantity::kind::{
        Acceleration, Angle, Density, Force, Length, NumberRate, Pressure, Time, Viscosity,
    };

    #[test]
    fn decimal_units_give_the_very_bits_of_the_si_number() {
        assert_eq!(parse::<Length>("2.5 mm"), Ok(0.0025));
        assert_eq!(parse::<Length>("0.3 um"), Ok(0.3e-6));
        assert_eq!(parse::<Length>("-1.7e3 km"), Ok(-1.7e6));
        assert_eq!(parse::<Time>("10 us"), Ok(1e-5));
        assert_eq!(parse::<Time>("10 µs"), Ok(1e-5));
        assert_eq!(parse::<Density>("1 g/cm^3"), Ok(1000.0));
        assert_eq!(parse::<Density>("998.2 kg/m^3"), Ok(998.2));
        assert_eq!(parse::<Pressure>("1.2 bar"), Ok(1.2e5));
    }

    #[test]
    fn one_unit_can_be_written_in_many_ways() {
        for text in [
            "1e-3 Pa s",
            "1e-3 Pa*s",
            "1e-3 Pa.s",
            "1e-3 Pa·s",
            "1 mPa s",
            "1mPa.s",
            "1 cP",
            "1 g/(m s)",
            "1 mN s/m^2",
            "0.001 kg m^-1 s^-1",
            "0.001 kg·m⁻¹·s⁻¹",
            "1e-3 kg/m/s",
            "1E-3 (Pa s)",
            "  1e-3  Pa  s ",
        ] {
            // "mN s/m^2" is a product before a quotient: only the other order is ambiguous.
            assert_eq!(parse::<Viscosity>(text), Ok(1e-3), "{text}");
        }
        assert_eq!(parse::<Acceleration>("9.81 m/s²"), Ok(9.81));
        assert_eq!(parse::<Acceleration>("9.81 m s-2"), Ok(9.81));
        assert_eq!(parse::<Acceleration>("9.81 m/s/s"), Ok(9.81));
        assert_eq!(parse::<NumberRate>("100 1/s"), Ok(100.0));
        assert_eq!(parse::<NumberRate>("2 kHz"), Ok(2000.0));
        assert_eq!(parse::<NumberRate>("6 1/min"), Ok(6.0 * (1.0 / 60.0)));
        assert_eq!(parse::<Time>("2 min"), Ok(120.0));
        assert_eq!(parse::<Time>("1 h"), Ok(3600.0));
        assert_eq!(parse::<Angle>("90 deg"), Ok(90.0 * (std::f64::consts::PI / 180.0)));
        assert_eq!(parse::<Force>("3 kg m/s^2"), Ok(3.0));
        assert_eq!(parse::<Length>("+.5 m"), Ok(0.5));
    }

    #[test]
    fn a_refusal_names_what_was_found_and_gives_an_example() {
        let refusal = |text: &str| parse::<Length>(text).unwrap_err();
        let example = "for example \"2.5 mm\" (a length)";
        assert_eq!(refusal("2.5"), "value 2.5 has no unit; write \"2.5 mm\" (a length)");
        assert_eq!(refusal("2.5 kg^2"), format!("\"2.5 kg^2\" is in kg^2, not a length; write {example}"));
        assert_eq!(refusal("2.5 kg"), format!("\"2.5 kg\" is a mass (kg), not a length; write {example}"));
        assert_eq!(refusal("2.5 s"), format!("\"2.5 s\" is a time (s), not a length; write {example}"));
        assert_eq!(
            refusal("2.5 m/m"),
            format!("\"2.5 m/m\" is a number without unit, not a length; write {example}")
        );
        assert_eq!(
            refusal("2.5 furlong"),
            format!("unit \"furlong\" has an unknown part \"furlong\"; write {example}")
        );
        assert_eq!(
            refusal("2 m^"),
            format!("unit \"m^\" has a power that is not an integer from -9 to 9; write {example}")
        );
        assert_eq!(
            refusal("2 m^1.5"),
            format!("unit \"m^1.5\" has an unknown part \"5\"; write {example}")
                .replace("has an unknown part \"5\"", "is not complete")
        );
        assert_eq!(
            refusal("2 m/s s"),
            format!(
                "unit \"m/s s\" has a product after a quotient, which can be read in two ways; write {example}"
            )
        );
        assert_eq!(refusal("2 (m"), format!("unit \"(m\" has an unclosed parenthesis; write {example}"));
        assert_eq!(refusal("2 m)"), format!("unit \"m)\" has a parenthesis too many; write {example}"));
        assert_eq!(refusal("2 m*"), format!("unit \"m*\" is not complete; write {example}"));
        for text in ["", "m", "nan m", "inf m", "-inf m", ". m", "e5 m", "--2 m"] {
            let text = text.trim();
            assert_eq!(
                refusal(text),
                format!(
                    "\"{text}\" does not start with a finite number; write a number and a unit, {example}"
                )
            );
        }
        assert_eq!(refusal("1e400 m"), format!("\"1e400 m\" is too large for a number; write {example}"));
        assert_eq!(
            refusal("1e99999999999 m"),
            format!(
                "\"1e99999999999 m\" does not start with a finite number; write a number and a unit, {example}"
            )
        );
    }

    #[test]
    fn hostile_units_end_in_a_refusal() {
        for text in ["(".repeat(100_000), "m^9".repeat(1000), "m/".repeat(1000), "m*".repeat(100_000)] {
            assert!(parse::<Length>(&format!("1 {text}")).is_err());
        }
    }
}
