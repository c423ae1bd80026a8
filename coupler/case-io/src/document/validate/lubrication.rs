//! `[grains.lubrication]`

use super::rules::Rules;
use crate::document::quantity::Length;
use crate::document::{Document, NormalLaw};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let Some(grains) = &document.grains else { return Ok(()) };
    let Some(lubrication) = &grains.lubrication else { return Ok(()) };
    let table = "grains.lubrication";
    if grains.normal_law == NormalLaw::None {
        rules.no_effect(table, "with normal-law = \"none\"")?;
    }
    if document.case.dimension.count() == 2 {
        return rules.refuse(table, "the law of lubrication is for spheres", "", "delete it");
    }
    rules.positive(&format!("{table}.viscosity"), lubrication.viscosity)?;
    rules.positive(&format!("{table}.roughness"), lubrication.roughness)?;
    let (cut_off, roughness) = (lubrication.cut_off, lubrication.roughness);
    if cut_off.si() <= roughness.si() {
        let allowed = format_args!("more than the roughness, {roughness}");
        return rules.refuse(&format!("{table}.cut-off"), format_args!("found {cut_off}"), allowed, "");
    }
    let smallest = document.insertion.iter().filter_map(|insertion| insertion.diameters());
    let radius = 0.5 * smallest.map(|[smallest, _]| smallest).fold(f64::INFINITY, f64::min);
    if cut_off.si() > radius {
        let found = format_args!("found {cut_off}, more than a film between grains");
        let allowed = format_args!("at most the smallest radius, {}", Length::from_si(radius));
        return rules.refuse(&format!("{table}.cut-off"), found, allowed, "");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CARRIED, DRY, SETTLING, assert_refusals, document};

    const WET: &str = "lubrication = { viscosity = \"1 mPa s\", roughness = \"1 um\", cut-off = \"0.1 mm\" }\n[[insertion]]";

    #[test]
    fn a_film_has_a_viscosity_and_lies_between_roughness_and_cut_off() {
        let base = SETTLING.replace("[[insertion]]", WET);
        document(&base);
        assert_refusals(
            &base,
            &[
                (
                    "\"1 mPa s\", rough",
                    "\"0 mPa s\", rough",
                    "case.toml:17: grains.lubrication.viscosity: found 0 Pa s; allowed: more than 0 Pa s",
                ),
                (
                    "\"1 um\"",
                    "\"-1 um\"",
                    "case.toml:17: grains.lubrication.roughness: found -1e-6 m; allowed: more than 0 m",
                ),
                (
                    "\"0.1 mm\"",
                    "\"1 um\"",
                    "case.toml:17: grains.lubrication.cut-off: found 1e-6 m; allowed: more than the roughness, 1e-6 m",
                ),
                (
                    "\"0.1 mm\"",
                    "\"1.1 mm\"",
                    "case.toml:17: grains.lubrication.cut-off: found 0.0011 m, more than a film between grains; allowed: at most the smallest radius, 0.001 m",
                ),
            ],
        );
    }

    #[test]
    fn only_spheres_that_touch_squeeze_a_film() {
        assert_refusals(
            DRY,
            &[(
                "[[insertion]]",
                WET,
                "case.toml:27: grains.lubrication: the law of lubrication is for spheres; delete it",
            )],
        );
        assert_refusals(
            CARRIED,
            &[(
                "[[insertion]]",
                WET,
                "case.toml:12: grains.lubrication: has no effect with normal-law = \"none\"; delete it",
            )],
        );
    }
}
