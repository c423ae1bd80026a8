//! `grains.cohesion-law`, and what `[pairs.*]` say of it.

use super::rules::Rules;
use crate::document::{CohesionLaw, Document, NormalLaw, Pair};
use crate::error::CaseError;

/// The keys of a pair that some law needs, and how one may be written.
const KEYS: [(&str, &str); 5] = [
    ("cohesion-energy-density", "\"10 kJ/m^3\""),
    ("work-of-adhesion", "\"50 mJ/m^2\""),
    ("surface-tension", "\"72 mN/m\""),
    ("contact-angle", "\"10 deg\""),
    ("bridge-volume-ratio", "0.01"),
];

/// The name of a law and the keys that it needs.
fn needs(law: CohesionLaw) -> (&'static str, &'static [&'static str]) {
    match law {
        CohesionLaw::Sjkr => ("sjkr", &["cohesion-energy-density"]),
        CohesionLaw::Sjkr2 => ("sjkr2", &["cohesion-energy-density"]),
        CohesionLaw::Dmt => ("dmt", &["work-of-adhesion"]),
        CohesionLaw::Jkr => ("jkr", &["work-of-adhesion"]),
        CohesionLaw::Capillary => ("capillary", &["surface-tension", "contact-angle", "bridge-volume-ratio"]),
    }
}

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let Some(grains) = &document.grains else { return Ok(()) };
    let key = "grains.cohesion-law";
    if grains.normal_law == NormalLaw::None {
        rules.no_effect(key, "with normal-law = \"none\"")?;
    }
    if grains.cohesion_law.is_some() && document.case.dimension.count() == 2 {
        return rules.refuse(key, "the laws of cohesion are for spheres", "", "delete it");
    }
    let linear = matches!(grains.normal_law, NormalLaw::Hooke | NormalLaw::LiggghtsHooke);
    if grains.cohesion_law == Some(CohesionLaw::Jkr) && linear {
        let found = "\"jkr\" is the adhesion of elastic spheres, and the normal law is linear";
        let advice = "take normal-law = \"hertz\" or \"liggghts-hertz\"";
        return rules.refuse(key, found, "\"sjkr\", \"sjkr2\", \"dmt\", \"capillary\"", advice);
    }
    for (name, pair) in &document.pairs {
        of_pair(&format!("pairs.{name}"), pair, grains.cohesion_law, rules)?;
    }
    Ok(())
}

fn of_pair(table: &str, pair: &Pair, law: Option<CohesionLaw>, rules: &Rules) -> Result<(), CaseError> {
    for (name, example) in KEYS {
        let key = format!("{table}.{name}");
        match law.map(needs) {
            None => rules.no_effect(&key, "without grains.cohesion-law")?,
            Some((law, keys)) if keys.contains(&name) => {
                rules.required(&key, format_args!("\"{law}\" needs it, for example {name} = {example}"))?;
            }
            Some((law, _)) => rules.no_effect(&key, format_args!("with cohesion-law = \"{law}\""))?,
        }
    }
    rules.optional_not_negative(&format!("{table}.cohesion-energy-density"), pair.cohesion_energy_density)?;
    rules.optional_not_negative(&format!("{table}.work-of-adhesion"), pair.work_of_adhesion)?;
    rules.optional_not_negative(&format!("{table}.surface-tension"), pair.surface_tension)?;
    if let Some(angle) = pair.contact_angle
        && !(0.0..50.0).contains(&angle.si().to_degrees())
    {
        let key = format!("{table}.contact-angle");
        return rules.refuse(&key, format_args!("found {angle}"), "from 0, less than 50 deg", "");
    }
    let ratio = pair.bridge_volume_ratio.unwrap_or(0.1);
    let holds = ratio > 0.0 && ratio <= 0.1;
    rules.number(&format!("{table}.bridge-volume-ratio"), ratio, holds, "more than 0, at most 0.1")
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CARRIED, DRY, SETTLING, assert_refusals, document};

    fn with(law: &str, said: &str) -> String {
        let grains = format!("cohesion-law = \"{law}\"\n[[insertion]]\nname = \"bed\"");
        SETTLING
            .replace("[[insertion]]\nname = \"bed\"", &grains)
            .replace("sliding-friction = 0.3", &format!("sliding-friction = 0.3\n{said}"))
    }

    const WET: &str = "surface-tension = \"72 mN/m\"\ncontact-angle = \"10 deg\"\nbridge-volume-ratio = 0.01";

    #[test]
    fn a_pair_says_what_the_law_needs_and_nothing_else() {
        document(&with("dmt", "work-of-adhesion = \"50 mJ/m^2\""));
        assert_refusals(
            &with("sjkr", "cohesion-energy-density = \"1 kJ/m^3\""),
            &[
                (
                    "cohesion-energy-density = \"1 kJ/m^3\"\n",
                    "",
                    "case.toml:12: pairs.glass-glass.cohesion-energy-density: missing; \"sjkr\" needs it, for example cohesion-energy-density = \"10 kJ/m^3\"",
                ),
                (
                    "\"1 kJ/m^3\"",
                    "\"-1 kJ/m^3\"",
                    "case.toml:15: pairs.glass-glass.cohesion-energy-density: found -1000 Pa; allowed: 0 Pa or more",
                ),
                (
                    "cohesion-law = \"sjkr\"\n",
                    "",
                    "case.toml:15: pairs.glass-glass.cohesion-energy-density: has no effect without grains.cohesion-law; delete it",
                ),
                (
                    "\"sjkr\"",
                    "\"jkr\"",
                    "case.toml:15: pairs.glass-glass.cohesion-energy-density: has no effect with cohesion-law = \"jkr\"; delete it",
                ),
            ],
        );
        assert_refusals(
            &with("jkr", "work-of-adhesion = \"50 mJ/m^2\""),
            &[(
                "\"50 mJ/m^2\"",
                "\"-50 mJ/m^2\"",
                "case.toml:15: pairs.glass-glass.work-of-adhesion: found -0.05 J/m^2; allowed: 0 J/m^2 or more",
            )],
        );
    }

    #[test]
    fn a_bridge_is_one_that_its_law_describes() {
        document(&with("capillary", WET));
        assert_refusals(
            &with("capillary", WET),
            &[
                (
                    "contact-angle = \"10 deg\"\n",
                    "",
                    "case.toml:12: pairs.glass-glass.contact-angle: missing; \"capillary\" needs it, for example contact-angle = \"10 deg\"",
                ),
                (
                    "\"10 deg\"",
                    "\"0.9 rad\"",
                    "case.toml:16: pairs.glass-glass.contact-angle: found 0.9 rad; allowed: from 0, less than 50 deg",
                ),
                (
                    "\"72 mN/m\"",
                    "\"-72 mN/m\"",
                    "case.toml:15: pairs.glass-glass.surface-tension: found -0.072 J/m^2; allowed: 0 J/m^2 or more",
                ),
                (
                    "ratio = 0.01",
                    "ratio = 0.2",
                    "case.toml:17: pairs.glass-glass.bridge-volume-ratio: found 0.2; allowed: more than 0, at most 0.1",
                ),
            ],
        );
    }

    #[test]
    fn a_law_that_does_not_apply_is_refused() {
        assert_refusals(
            &with("jkr", "work-of-adhesion = \"50 mJ/m^2\""),
            &[(
                "normal-law = \"hertz\"",
                "normal-law = \"hooke\"\ncharacteristic-velocity = \"1 m/s\"",
                "case.toml:19: grains.cohesion-law: \"jkr\" is the adhesion of elastic spheres, and the normal law is linear; allowed: \"sjkr\", \"sjkr2\", \"dmt\", \"capillary\"; take normal-law = \"hertz\" or \"liggghts-hertz\"",
            )],
        );
        assert_refusals(
            CARRIED,
            &[(
                "[[insertion]]",
                "cohesion-law = \"sjkr\"\n[[insertion]]",
                "case.toml:12: grains.cohesion-law: has no effect with normal-law = \"none\"; delete it",
            )],
        );
        assert_refusals(
            DRY,
            &[(
                "[[insertion]]",
                "cohesion-law = \"sjkr\"\n[[insertion]]",
                "case.toml:27: grains.cohesion-law: the laws of cohesion are for spheres; delete it",
            )],
        );
    }
}
