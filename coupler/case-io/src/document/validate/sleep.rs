//! `[grains.sleep]`

use super::rules::Rules;
use crate::document::Document;
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let Some(sleep) = document.grains.as_ref().and_then(|grains| grains.sleep) else { return Ok(()) };
    if !document.clump.is_empty() {
        return rules.refuse(
            "grains.sleep",
            "clumps do not sleep",
            "grains alone",
            "leave out grains.sleep or [[clump]]",
        );
    }
    rules.optional_positive("grains.sleep.speed", sleep.speed)?;
    rules.optional_positive("grains.sleep.acceleration", sleep.acceleration)?;
    if document.case.gravity.to_array() == [0.0; 3] {
        let reason =
            |example: &str| format!("without gravity nothing says how slow is idle, for example {example}");
        rules.required("grains.sleep.speed", reason("\"10 um/s\""))?;
        rules.required("grains.sleep.acceleration", reason("\"0.01 m/s^2\""))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CARRIED, DRY, assert_refusals};

    #[test]
    fn bounds_are_positive_and_stated_where_nothing_weighs() {
        assert_refusals(
            DRY,
            &[
                (
                    "[[insertion]]",
                    "sleep = { speed = \"0 m/s\" }\n[[insertion]]",
                    "case.toml:27: grains.sleep.speed: found 0 m/s; allowed: more than 0 m/s",
                ),
                (
                    "[[insertion]]",
                    "sleep = { acceleration = \"-1 m/s^2\" }\n[[insertion]]",
                    "case.toml:27: grains.sleep.acceleration: found -1 m/s^2; allowed: more than 0 m/s^2",
                ),
            ],
        );
        assert_refusals(
            CARRIED,
            &[(
                "[[insertion]]",
                "sleep = { speed = \"1 um/s\" }\n[[insertion]]",
                "case.toml:12: grains.sleep.acceleration: missing; without gravity nothing says how slow is idle, for example \"0.01 m/s^2\"",
            )],
        );
    }
}
