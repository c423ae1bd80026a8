//! `[[probe]]`

use super::rules::Rules;
use super::wall::direction;
use crate::document::Document;
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    if document.fluid.is_none() {
        return rules.no_effect("probe", "without [fluid]");
    }
    rules.names("probe", document.probe.iter().map(|probe| probe.name.as_str()))?;
    document.probe.iter().enumerate().try_for_each(|(k, probe)| {
        rules.vector(&format!("probe[{k}].at"), &probe.at)?;
        let Some(disc) = &probe.disc else { return Ok(()) };
        rules.positive(&format!("probe[{k}].disc.radius"), disc.radius)?;
        direction(rules, &format!("probe[{k}].disc.normal"), &disc.normal, "any direction")
    })
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{DRY, SETTLING, assert_refusals};

    #[test]
    fn a_probe_is_a_named_point_of_the_fluid() {
        assert_refusals(
            SETTLING,
            &[
                (
                    "name = \"centre\"",
                    "name = \"\"",
                    "case.toml:42: probe[0].name: found the name \"\"; allowed: letters, digits, - and _",
                ),
                (
                    "at = [\"0 m\", \"0 m\", \"0.5 m\"]",
                    "at = [\"0 m\"]",
                    "case.toml:43: probe[0].at: found 1 components; allowed: 3; case.dimension is 3",
                ),
                (
                    "at = [\"0 m\", \"0 m\", \"0.5 m\"]",
                    "",
                    "case.toml:41: probe[0].at: missing; add it to probe[0]",
                ),
                (
                    "at = [\"0 m\", \"0 m\", \"0.5 m\"]",
                    "at = [\"0 m\", \"0 m\", \"0.5 m\"]\ndisc = { radius = \"0 m\", normal = [1, 0, 0] }",
                    "case.toml:44: probe[0].disc.radius: found 0 m; allowed: more than 0 m",
                ),
                (
                    "at = [\"0 m\", \"0 m\", \"0.5 m\"]",
                    "at = [\"0 m\", \"0 m\", \"0.5 m\"]\ndisc = { radius = \"1 cm\", normal = [0, 0, 0] }",
                    "case.toml:44: probe[0].disc.normal: all components are 0; allowed: any direction",
                ),
            ],
        );
        assert_refusals(
            DRY,
            &[(
                "[grains]",
                "[[probe]]\nname = \"a\"\nat = [\"0 m\", \"0 m\"]\n[grains]",
                "case.toml:22: probe: has no effect without [fluid]; delete it",
            )],
        );
    }
}
