//! Diameters of `[[insertion]]`.

use super::rules::Rules;
use crate::document::quantity::Length;
use crate::document::{Distribution, Insertion, MixtureSize, Placement};
use crate::error::CaseError;

/// Shares of a mixture add up to 1 within this: as thirds written with three digits do not, with six they do.
const SUM_OF_SHARES: f64 = 1e-5;

pub(super) fn check(insertion: &Insertion, table: &str, rules: &Rules) -> Result<(), CaseError> {
    let from_file = matches!(insertion.placement(), Some(Placement::File(_)));
    if !from_file || insertion.is_sized() {
        rules.exactly_one(table, &["diameter", "diameter-range", "diameter-distribution", "clump"])?;
    }
    rules.optional_positive(&format!("{table}.diameter"), insertion.diameter)?;
    if let Some([smallest, largest]) = insertion.diameter_range {
        rules.positive(&format!("{table}.diameter-range[0]"), smallest)?;
        if largest.si() <= smallest.si() {
            let allowed = format!("more than the smallest, {smallest}");
            return rules.refuse(
                &format!("{table}.diameter-range[1]"),
                format_args!("found {largest}"),
                allowed,
                "",
            );
        }
    }
    match &insertion.diameter_distribution {
        Some(stated) => distribution(stated, &format!("{table}.diameter-distribution"), rules),
        None => Ok(()),
    }
}

fn distribution(stated: &Distribution, table: &str, rules: &Rules) -> Result<(), CaseError> {
    rules.exactly_one(table, &["normal", "lognormal", "mixture", "sieve"])?;
    if let Some(normal) = &stated.normal {
        let table = format!("{table}.normal");
        rules.positive(&format!("{table}.mean"), normal.mean)?;
        rules.positive(&format!("{table}.deviation"), normal.deviation)?;
        ends(&table, normal.smallest, normal.largest, rules)?;
    }
    if let Some(lognormal) = &stated.lognormal {
        let (table, deviation) = (format!("{table}.lognormal"), lognormal.deviation);
        rules.positive(&format!("{table}.median"), lognormal.median)?;
        rules.number(&format!("{table}.deviation"), deviation, deviation > 0.0, "more than 0")?;
        ends(&table, lognormal.smallest, lognormal.largest, rules)?;
    }
    match &stated.mixture {
        Some(sizes) => mixture(sizes, &format!("{table}.mixture"), rules),
        None => Ok(()),
    }
}

fn ends(table: &str, smallest: Length, largest: Length, rules: &Rules) -> Result<(), CaseError> {
    rules.positive(&format!("{table}.smallest"), smallest)?;
    if largest.si() > smallest.si() {
        return Ok(());
    }
    let allowed = format!("more than the smallest, {smallest}");
    rules.refuse(&format!("{table}.largest"), format_args!("found {largest}"), allowed, "")
}

fn mixture(sizes: &[MixtureSize], table: &str, rules: &Rules) -> Result<(), CaseError> {
    if sizes.is_empty() {
        let advice = "write for example [{ diameter = \"1 mm\", mass-fraction = 1 }]";
        return rules.refuse(table, "there is no diameter in it", "", advice);
    }
    for (k, size) in sizes.iter().enumerate() {
        rules.positive(&format!("{table}[{k}].diameter"), size.diameter)?;
        let key = format!("{table}[{k}].mass-fraction");
        rules.number(&key, size.mass_fraction, size.mass_fraction > 0.0, "more than 0")?;
    }
    let sum: f64 = sizes.iter().map(|size| size.mass_fraction).sum();
    if (sum - 1.0).abs() > SUM_OF_SHARES {
        return rules.refuse(table, format_args!("the mass fractions add up to {sum}"), "1", "");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{SETTLING, assert_refusals, document};

    const DIAMETER: &str = "diameter = \"2 mm\"";

    #[test]
    fn distributions_are_stated_whole() {
        let sized = |stated: &str| format!("diameter-distribution = {{ {stated} }}");
        let normal = |deviation: &str, largest: &str| {
            sized(&format!(
                "normal = {{ mean = \"2 mm\", deviation = \"{deviation}\", smallest = \"1 mm\", largest = \"{largest}\" }}"
            ))
        };
        let lognormal = |deviation: &str| {
            sized(&format!(
                "lognormal = {{ median = \"2 mm\", deviation = {deviation}, smallest = \"1 mm\", largest = \"3 mm\" }}"
            ))
        };
        let rows = [
            (
                sized(""),
                "case.toml:20: insertion[0].diameter-distribution: none of these keys is given; allowed: exactly one of normal, lognormal, mixture, sieve",
            ),
            (
                normal("0 mm", "3 mm"),
                "case.toml:20: insertion[0].diameter-distribution.normal.deviation: found 0 m; allowed: more than 0 m",
            ),
            (
                normal("1 mm", "1 mm"),
                "case.toml:20: insertion[0].diameter-distribution.normal.largest: found 0.001 m; allowed: more than the smallest, 0.001 m",
            ),
            (
                lognormal("-1"),
                "case.toml:20: insertion[0].diameter-distribution.lognormal.deviation: found -1; allowed: more than 0",
            ),
            (
                sized("mixture = []"),
                "case.toml:20: insertion[0].diameter-distribution.mixture: there is no diameter in it; write for example [{ diameter = \"1 mm\", mass-fraction = 1 }]",
            ),
            (
                sized(
                    "mixture = [{ diameter = \"1 mm\", mass-fraction = 0.5 }, { diameter = \"2 mm\", mass-fraction = 0.25 }]",
                ),
                "case.toml:20: insertion[0].diameter-distribution.mixture: the mass fractions add up to 0.75; allowed: 1",
            ),
            (
                format!("{DIAMETER}\n{}", lognormal("0.5")),
                "case.toml:17: insertion[0]: diameter and diameter-distribution exclude each other; allowed: exactly one of diameter, diameter-range, diameter-distribution, clump",
            ),
        ];
        for (to, message) in &rows {
            assert_refusals(SETTLING, &[(DIAMETER, to, message)]);
        }
        let sound = document(&SETTLING.replace(DIAMETER, &lognormal("0.5")));
        assert_eq!(sound.insertion[0].diameters(), Some([1e-3, 3e-3]));
        document(&SETTLING.replace(DIAMETER, &sized("sieve = { path = \"a.csv\" }")));
    }
}
