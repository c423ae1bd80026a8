//! `[[bond]]`

use super::rules::Rules;
use crate::document::{Bond, BondLaw, Document, Placement};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    if document.grains.is_none() {
        return rules.no_effect("bond", "without [grains]");
    }
    for (index, bond) in document.bond.iter().enumerate() {
        let table = format!("bond[{index}]");
        insertions(document, bond, &table, rules)?;
        let named = |name: &str| bond.insertions.as_ref().is_none_or(|names| names.iter().any(|n| n == name));
        if let Some(clumps) = document.insertion.iter().find(|i| i.clump.is_some() && named(&i.name)) {
            let found = format!("\"{}\" inserts clumps, which are not bonded", clumps.name);
            return rules.refuse(&format!("{table}.insertions"), found, "insertions of grains", "name those");
        }
        let key = |name: &str| format!("{table}.{name}");
        rules.positive(&key("gap"), bond.gap)?;
        rules.positive(&key("youngs-modulus"), bond.youngs_modulus)?;
        rules.optional_positive(&key("tensile-strength"), bond.tensile_strength)?;
        rules.optional_positive(&key("shear-strength"), bond.shear_strength)?;
        let ratio = bond.damping_ratio;
        rules.number(&key("damping-ratio"), ratio, ratio >= 0.0, "0 or more")?;
        of_law(bond, &table, rules)?;
    }
    Ok(())
}

/// The keys of its law are there, and those of the other are not.
fn of_law(bond: &Bond, table: &str, rules: &Rules) -> Result<(), CaseError> {
    let key = |name: &str| format!("{table}.{name}");
    match bond.law {
        BondLaw::ParallelBond => {
            for other in ["poissons-ratio", "area-factor", "internal-friction"] {
                rules.no_effect(&key(other), "with law = \"parallel-bond\"")?;
            }
            rules
                .required(&key("stiffness-ratio"), "the shear stiffness is found from it, for example 2.5")?;
        }
        BondLaw::Cohesive => {
            for other in ["stiffness-ratio", "radius-multiplier"] {
                rules.no_effect(&key(other), "with law = \"cohesive\"")?;
            }
            rules
                .required(&key("poissons-ratio"), "the shear stiffness is found from it, for example 0.25")?;
        }
    }
    let factors = [
        ("stiffness-ratio", bond.stiffness_ratio),
        ("radius-multiplier", bond.radius_multiplier),
        ("area-factor", bond.area_factor),
    ];
    for (name, factor) in factors {
        let factor = factor.unwrap_or(1.0);
        rules.number(&key(name), factor, factor > 0.0, "more than 0")?;
    }
    let poisson = bond.poissons_ratio.unwrap_or(0.0);
    let holds = poisson > -1.0 && poisson <= 0.5;
    rules.number(&key("poissons-ratio"), poisson, holds, "more than -1, at most 0.5")?;
    let friction = bond.internal_friction.unwrap_or(0.0);
    if bond.shear_strength.is_none() {
        rules.no_effect(&key("internal-friction"), "without shear-strength")?;
    }
    rules.number(&key("internal-friction"), friction, friction >= 0.0, "0 or more")
}

/// Each is named once, and has grains at the start.
fn insertions(document: &Document, bond: &Bond, table: &str, rules: &Rules) -> Result<(), CaseError> {
    let Some(named) = &bond.insertions else { return Ok(()) };
    let key = format!("{table}.insertions");
    if named.is_empty() {
        return rules.refuse(&key, "names no insertion", "", "delete it to bond the grains of all");
    }
    let at_start = document.insertion.iter().filter(|i| !matches!(i.placement(), Some(Placement::Rate(_))));
    let known: Vec<&str> = at_start.map(|insertion| insertion.name.as_str()).collect();
    for (index, name) in named.iter().enumerate() {
        let key = format!("{key}[{index}]");
        rules.known(&key, "insertion at t = 0 of the name", name, &known)?;
        if named[..index].contains(name) {
            return rules.refuse(&key, format_args!("\"{name}\" is named twice"), "", "delete one");
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CHANNEL, SETTLING, assert_refusals, document};

    /// The scene with bonds of this law and these keys beside `gap` and `youngs-modulus`.
    fn with(law: &str, keys: &str) -> String {
        format!("[[bond]]\nlaw = \"{law}\"\ngap = \"1 mm\"\nyoungs-modulus = \"1 GPa\"\n{keys}\n[[wall]]")
    }

    #[test]
    fn bonds_are_whole_and_state_nothing_idle() {
        let parallel = |keys: &str| with("parallel-bond", &format!("stiffness-ratio = 2.5\n{keys}"));
        let cohesive = |keys: &str| with("cohesive", &format!("poissons-ratio = 0.2\n{keys}"));
        let rows = [
            (
                with("paralel-bond", ""),
                "case.toml:23: bond[0].law: unknown law \"paralel-bond\"; allowed: parallel-bond, cohesive; did you mean \"parallel-bond\"?",
            ),
            (
                parallel("gapp = \"1 mm\""),
                "case.toml:27: bond[0].gapp: unknown key; allowed: law, insertions, gap, youngs-modulus, stiffness-ratio, radius-multiplier, poissons-ratio, area-factor, internal-friction, tensile-strength, shear-strength, damping-ratio; did you mean \"gap\"?",
            ),
            (
                parallel("insertions = [\"bad\"]"),
                "case.toml:27: bond[0].insertions[0]: there is no insertion at t = 0 of the name \"bad\"; allowed: bed; did you mean \"bed\"?",
            ),
            (
                parallel("insertions = [\"bed\", \"bed\"]"),
                "case.toml:27: bond[0].insertions[1]: \"bed\" is named twice; delete one",
            ),
            (
                parallel("insertions = []"),
                "case.toml:27: bond[0].insertions: names no insertion; delete it to bond the grains of all",
            ),
            (
                with("parallel-bond", ""),
                "case.toml:22: bond[0].stiffness-ratio: missing; the shear stiffness is found from it, for example 2.5",
            ),
            (
                parallel("poissons-ratio = 0.2"),
                "case.toml:27: bond[0].poissons-ratio: has no effect with law = \"parallel-bond\"; delete it",
            ),
            (
                parallel("radius-multiplier = 0"),
                "case.toml:27: bond[0].radius-multiplier: found 0; allowed: more than 0",
            ),
            (
                parallel("tensile-strength = \"0 Pa\""),
                "case.toml:27: bond[0].tensile-strength: found 0 Pa; allowed: more than 0 Pa",
            ),
            (
                parallel("damping-ratio = -0.1"),
                "case.toml:27: bond[0].damping-ratio: found -0.1; allowed: 0 or more",
            ),
            (
                cohesive("stiffness-ratio = 2"),
                "case.toml:27: bond[0].stiffness-ratio: has no effect with law = \"cohesive\"; delete it",
            ),
            (
                cohesive("internal-friction = 0.5"),
                "case.toml:27: bond[0].internal-friction: has no effect without shear-strength; delete it",
            ),
            (
                with("cohesive", "poissons-ratio = 0.6"),
                "case.toml:26: bond[0].poissons-ratio: found 0.6; allowed: more than -1, at most 0.5",
            ),
        ];
        for (to, message) in &rows {
            assert_refusals(SETTLING, &[("[[wall]]", to, message)]);
        }
        let sound = cohesive("shear-strength = \"1 MPa\"\ninternal-friction = 0.5\ninsertions = [\"bed\"]");
        document(&SETTLING.replace("[[wall]]", &sound));
        let idle = "case.toml:7: bond: has no effect without [grains]; delete it";
        let stated = with("cohesive", "poissons-ratio = 0.2").replace("[[wall]]", "[fluid]");
        assert_refusals(CHANNEL, &[("[fluid]", &stated, idle)]);
    }
}
