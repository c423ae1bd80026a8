//! The sizes of an insertion.

use case_io::document::{self, Case, Insertion};

use crate::error::DemError;
use crate::insertion::{Class, Classes, Lognormal, Normal, Sizes, Uniform, read_sieve};

/// The radii of an insertion's grains; where neither the case nor a file of sizes states them, none is drawn.
pub fn sizes<const D: usize>(case: &Case, index: usize, insertion: &Insertion) -> Result<Sizes, DemError> {
    if let Some(stated) = &insertion.diameter_distribution {
        return distribution::<D>(case, &format!("insertion[{index}].diameter-distribution"), stated);
    }
    let [smallest, largest] = insertion.diameters().unwrap_or_default().map(|diameter| 0.5 * diameter);
    Ok(if smallest == largest { Sizes::All(smallest) } else { Sizes::Uniform(Uniform { smallest, largest }) })
}

fn distribution<const D: usize>(
    case: &Case,
    key: &str,
    stated: &document::Distribution,
) -> Result<Sizes, DemError> {
    if let Some(normal) = &stated.normal {
        let [mean, deviation, smallest, largest] =
            [normal.mean, normal.deviation, normal.smallest, normal.largest].map(|d| 0.5 * d.si());
        return Ok(Sizes::Normal(Normal { mean, deviation, smallest, largest }));
    }
    if let Some(lognormal) = &stated.lognormal {
        let [median, smallest, largest] =
            [lognormal.median, lognormal.smallest, lognormal.largest].map(|d| 0.5 * d.si());
        return Ok(Sizes::Lognormal(Lognormal::new(median, lognormal.deviation, smallest, largest)));
    }
    let classes = match &stated.sieve {
        Some(sieve) => read_sieve(&case.folder.join(&sieve.path))
            .map_err(|error| error.at_key(case, &format!("{key}.sieve.path")))?,
        None => stated.mixture.iter().flatten().map(class).collect(),
    };
    Ok(Sizes::Classes(Classes::new(classes, D)))
}

fn class(size: &document::MixtureSize) -> Class {
    let radius = 0.5 * size.diameter.si();
    Class { smallest: radius, largest: radius, mass: size.mass_fraction }
}
