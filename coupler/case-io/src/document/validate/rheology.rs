//! `[fluid.rheology]`

use super::rules::Rules;
use crate::document::{Coupling, Document, Drag, Rheology, RheologyLaw, Scheme};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rheology: &Rheology, rules: &Rules) -> Result<(), CaseError> {
    let table = "fluid.rheology";
    let corrects = |coupling: &Coupling| {
        coupling.self_disturbance && coupling.drag != Drag::None && coupling.scheme != Scheme::OneWay
    };
    if document.grains.is_some() && document.coupling.as_ref().is_some_and(corrects) {
        let found = "found true, but a grain's own disturbance is known of one viscosity";
        return rules.refuse("coupling.self-disturbance", found, "false with [fluid.rheology]", "");
    }
    rules.positive(&format!("{table}.yield-stress"), rheology.yield_stress)?;
    rules.optional_positive(&format!("{table}.creep-rate"), rheology.creep_rate)?;
    let key = format!("{table}.index");
    match (rheology.law, rheology.index) {
        (RheologyLaw::Bingham, _) => rules.no_effect(&key, "with law = \"bingham\""),
        (RheologyLaw::HerschelBulkley, None) => {
            rules.required(&key, "the law needs the exponent of the rate of shear")
        }
        (RheologyLaw::HerschelBulkley, Some(index)) => {
            rules.number(&key, index, index > 0.0 && index <= 2.0, "more than 0, at most 2")
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CHANNEL, SETTLING, TANK, assert_refusals, document};

    const MUD: &str = "[fluid.rheology]\nlaw = \"bingham\"\nyield-stress = \"20 Pa\"\n[fluid.mesh]";
    const PASTE: &str =
        "[fluid.rheology]\nlaw = \"herschel-bulkley\"\nyield-stress = \"20 Pa\"\nindex = 0.5\n[fluid.mesh]";

    #[test]
    fn a_yield_stress_has_a_law_and_grains_in_it_no_correction_of_their_disturbance() {
        let (mud, paste) = (TANK.replace("[fluid.mesh]", MUD), TANK.replace("[fluid.mesh]", PASTE));
        let rheology = document(&mud).fluid.unwrap().rheology.unwrap();
        // Even at 20 Pa/(1 mPa s).
        assert!((rheology.creep_rate(1e-3) - 20.0).abs() < 1e-12);
        let rheology = document(&paste).fluid.unwrap().rheology.unwrap();
        assert!((rheology.creep_rate(10.0) - 4e-3).abs() < 1e-15);
        assert_refusals(
            &mud,
            &[
                (
                    "\"20 Pa\"",
                    "\"0 Pa\"",
                    "case.toml:14: fluid.rheology.yield-stress: found 0 Pa; allowed: more than 0 Pa",
                ),
                (
                    "\"20 Pa\"",
                    "\"20 Pa\"\nindex = 0.5",
                    "case.toml:15: fluid.rheology.index: has no effect with law = \"bingham\"; delete it",
                ),
                (
                    "\"20 Pa\"",
                    "\"20 Pa\"\ncreep-rate = \"1 m/s\"",
                    "case.toml:15: fluid.rheology.creep-rate: \"1 m/s\" is a velocity (m s^-1), not a number rate; write for example \"2.5 1/s\" (a number rate)",
                ),
                (
                    "\"bingham\"",
                    "\"casson\"",
                    "case.toml:13: fluid.rheology.law: unknown law \"casson\"; allowed: bingham, herschel-bulkley",
                ),
            ],
        );
        assert_refusals(
            &paste,
            &[
                (
                    "index = 0.5",
                    "",
                    "case.toml:12: fluid.rheology.index: missing; the law needs the exponent of the rate of shear",
                ),
                (
                    "0.5",
                    "-0.5",
                    "case.toml:15: fluid.rheology.index: found -0.5; allowed: more than 0, at most 2",
                ),
            ],
        );
        assert_refusals(
            CHANNEL,
            &[(
                "[fluid.mesh]",
                MUD,
                "case.toml:11: fluid.rheology: has no effect with backend = \"eulerian\"; delete it",
            )],
        );
        assert_refusals(
            &SETTLING.replace("\"eulerian\"", "\"pfem\"").replace("\"outlet\"", "\"free-surface\""),
            &[(
                "[fluid.mesh]",
                MUD,
                "case.toml:41: coupling.self-disturbance: found true, but a grain's own disturbance is known of one viscosity; allowed: false with [fluid.rheology]",
            )],
        );
    }
}
