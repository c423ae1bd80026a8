//! A column and its title.

use std::fmt;
use std::str::FromStr;

/// The title of a column, written `name[unit]`; a number without unit is `name[1]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Title {
    /// What is measured.
    pub name: String,
    /// Its SI unit.
    pub unit: String,
}

impl fmt::Display for Title {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        write!(formatter, "{}[{}]", self.name, self.unit)
    }
}

impl FromStr for Title {
    type Err = ();

    /// # Errors
    /// Anything but a name and a unit in brackets, free of commas, quotes and line ends.
    fn from_str(text: &str) -> Result<Self, ()> {
        let (name, unit) = text.strip_suffix(']').and_then(|text| text.split_once('[')).ok_or(())?;
        let plain = |part: &str| !part.is_empty() && !part.contains([',', '"', '[', ']', '\n', '\r']);
        if plain(name) && plain(unit) {
            Ok(Self { name: name.to_owned(), unit: unit.to_owned() })
        } else {
            Err(())
        }
    }
}

/// A column of a series.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name and unit.
    pub title: Title,
    /// One value per row.
    pub values: Vec<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_is_a_name_and_a_unit() {
        let title: Title = "vz[m/s]".parse().unwrap();
        assert_eq!((title.name.as_str(), title.unit.as_str()), ("vz", "m/s"));
        assert_eq!(title.to_string(), "vz[m/s]");
        for bad in ["", "vz", "vz[]", "[m]", "vz[m", "v,z[m]", "v[z][m]", "v\n[m]", "v\"[m]"] {
            assert!(bad.parse::<Title>().is_err(), "{bad:?}");
        }
    }
}
