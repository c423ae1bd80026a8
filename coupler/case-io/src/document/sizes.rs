//! Distributions of diameters.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::quantity::Length;

/// A distribution of diameters; exactly one of its keys.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Distribution {
    /// Normal by number, cut off at both ends.
    pub normal: Option<NormalSizes>,
    /// Lognormal by number, cut off at both ends.
    pub lognormal: Option<LognormalSizes>,
    /// Diameters with their shares of the mass.
    pub mixture: Option<Vec<MixtureSize>>,
    /// A sieve curve.
    pub sieve: Option<SieveFile>,
}

/// Normal by number, cut off at both ends.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct NormalSizes {
    /// Mean diameter before it is cut off.
    pub mean: Length,
    /// Standard deviation before it is cut off.
    pub deviation: Length,
    /// Smallest diameter.
    pub smallest: Length,
    /// Largest diameter.
    pub largest: Length,
}

/// Lognormal by number, cut off at both ends.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct LognormalSizes {
    /// Median diameter before it is cut off.
    pub median: Length,
    /// Standard deviation of the natural logarithm of the diameter before it is cut off.
    pub deviation: f64,
    /// Smallest diameter.
    pub smallest: Length,
    /// Largest diameter.
    pub largest: Length,
}

/// A diameter and its share of the mass.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct MixtureSize {
    /// The diameter.
    pub diameter: Length,
    /// Its share of the mass; all shares add up to 1.
    pub mass_fraction: f64,
}

/// A sieve curve from a csv file with the columns `diameter[m],passing[-]`: the share of the mass, from 0 to 1, that is
/// smaller; between rows it is straight over the logarithm of the diameter.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct SieveFile {
    /// The file, relative to the case's folder.
    pub path: PathBuf,
}

impl Distribution {
    /// Smallest and largest diameter in m; nothing if a file states them.
    pub fn ends(&self) -> Option<[f64; 2]> {
        let normal = self.normal.as_ref().map(|sizes| [sizes.smallest.si(), sizes.largest.si()]);
        let lognormal = || self.lognormal.as_ref().map(|sizes| [sizes.smallest.si(), sizes.largest.si()]);
        let mixture = || {
            let diameters = self.mixture.as_ref()?.iter().map(|size| size.diameter.si());
            Some([diameters.clone().fold(f64::INFINITY, f64::min), diameters.fold(0.0, f64::max)])
        };
        normal.or_else(lognormal).or_else(mixture)
    }
}
