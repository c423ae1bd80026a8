//! `[[deletion]]`

use super::region;
use super::rules::Rules;
use super::wall::direction;
use crate::document::Document;
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    if document.grains.is_none() {
        return rules.no_effect("deletion", "without [grains]");
    }
    rules.names("deletion", document.deletion.iter().map(|deletion| deletion.name.as_str()))?;
    for (index, deletion) in document.deletion.iter().enumerate() {
        let table = format!("deletion[{index}]");
        rules.exactly_one(&table, &["box", "sphere", "cylinder", "stl", "beyond"])?;
        // Feeds, deletions and the escaped are columns of one series.
        let known = document.insertion.iter().any(|insertion| insertion.name == deletion.name);
        if known || deletion.name == "escaped" {
            let found = format!("\"{}\" names something else in series/turnover.csv", deletion.name);
            return rules.refuse(&format!("{table}.name"), found, "", "rename it");
        }
        let stated = [
            ("box", deletion.cuboid.is_some()),
            ("sphere", deletion.sphere.is_some()),
            ("cylinder", deletion.cylinder.is_some()),
            ("stl", deletion.stl.is_some()),
        ];
        if let (Some((key, _)), Some(region)) = (stated.iter().find(|(_, given)| *given), deletion.region()) {
            region::check(rules, &format!("{table}.{key}"), region)?;
        }
        if let Some(plane) = &deletion.beyond {
            rules.vector(&format!("{table}.beyond.point"), &plane.point)?;
            let allowed = "any direction, towards the grains that stay";
            direction(rules, &format!("{table}.beyond.normal"), &plane.normal, allowed)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CHANNEL, SETTLING, assert_refusals, document};

    fn with(keys: &str) -> String {
        format!("[[deletion]]\n{keys}\n[[wall]]")
    }

    #[test]
    fn a_deletion_has_one_region_and_a_name_of_its_own() {
        let rows = [
            (
                with("name = \"out\""),
                "case.toml:22: deletion[0]: none of these keys is given; allowed: exactly one of box, sphere, cylinder, stl, beyond",
            ),
            (
                with("name = \"bed\"\nbeyond = { point = [\"0 m\", \"0 m\", \"0 m\"], normal = [0, 0, 1] }"),
                "case.toml:23: deletion[0].name: \"bed\" names something else in series/turnover.csv; rename it",
            ),
            (
                with("name = \"out\"\nbeyond = { point = [\"0 m\", \"0 m\", \"0 m\"], normal = [0, 0, 0] }"),
                "case.toml:24: deletion[0].beyond.normal: all components are 0; allowed: any direction, towards the grains that stay",
            ),
            (
                with(
                    "name = \"out\"\nbox = { lower = [\"0 m\", \"0 m\", \"0 m\"], upper = [\"1 m\", \"1 m\", \"0 m\"] }",
                ),
                "case.toml:24: deletion[0].box.upper[2]: found 0 m; allowed: more than lower, 0 m",
            ),
            (
                with("name = \"out\"\nsphere = { centre = [\"0 m\", \"0 m\", \"0 m\"], radius = \"0 m\" }"),
                "case.toml:24: deletion[0].sphere.radius: found 0 m; allowed: more than 0 m",
            ),
        ];
        for (to, message) in &rows {
            assert_refusals(SETTLING, &[("[[wall]]", to, message)]);
        }
        document(&SETTLING.replace(
            "[[wall]]",
            &with("name = \"out\"\nbeyond = { point = [\"0 m\", \"0 m\", \"0 m\"], normal = [0, 0, 1] }"),
        ));
        assert_refusals(
            CHANNEL,
            &[(
                "[fluid]",
                "[[deletion]]\nname = \"a\"\n[fluid]",
                "case.toml:7: deletion: has no effect without [grains]; delete it",
            )],
        );
    }
}
