//! `[materials.*]` and `[pairs.*]`

use std::collections::BTreeSet;

use super::rules::{Rules, check_name};
use crate::document::{Document, NormalLaw, Placement};
use crate::error::CaseError;
use crate::nearest::did_you_mean;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let Some(grains) = &document.grains else {
        rules.no_effect("materials", "without [grains]")?;
        return rules.no_effect("pairs", "without [grains]");
    };
    let touching = grains.normal_law != NormalLaw::None;
    materials(document, touching, rules)?;
    if !touching {
        return rules.no_effect("pairs", "with normal-law = \"none\"");
    }
    pairs(document, rules)
}

fn materials(document: &Document, touching: bool, rules: &Rules) -> Result<(), CaseError> {
    for (material, properties) in &document.materials {
        let table = format!("materials.{material}");
        check_name(rules.source, &table, material)?;
        let used = document.insertion.iter().any(|insertion| insertion.material == *material)
            || document.wall.iter().any(|wall| wall.material.as_ref() == Some(material));
        if !used {
            return rules.refuse(&table, "no insertion and no wall is made of it", "", "delete it");
        }
        if properties.micro {
            micro(document, material, &table, rules)?;
        }
        rules.positive(&format!("{table}.density"), properties.density)?;
        let (modulus, ratio) = (format!("{table}.youngs-modulus"), format!("{table}.poissons-ratio"));
        if touching {
            rules.required(&modulus, "contacts need it, for example youngs-modulus = \"5 MPa\"")?;
            rules.required(&ratio, "contacts need it, for example poissons-ratio = 0.3")?;
        } else {
            rules.no_effect(&modulus, "with normal-law = \"none\"")?;
            rules.no_effect(&ratio, "with normal-law = \"none\"")?;
        }
        rules.optional_positive(&modulus, properties.youngs_modulus)?;
        let poisson = properties.poissons_ratio.unwrap_or(0.0);
        rules.number(&ratio, poisson, poisson > -1.0 && poisson <= 0.5, "more than -1, at most 0.5")?;
    }
    Ok(())
}

/// Micro grains are grains, and no bond turns them.
fn micro(document: &Document, material: &str, table: &str, rules: &Rules) -> Result<(), CaseError> {
    let key = format!("{table}.micro");
    let of_it = |name: &str| {
        document.insertion.iter().any(|insertion| insertion.name == name && insertion.material == material)
    };
    if document.insertion.iter().all(|insertion| insertion.material != material) {
        rules.no_effect(&key, "where no insertion is made of it")?;
    }
    let bonded = document
        .bond
        .iter()
        .any(|bond| bond.insertions.as_ref().is_none_or(|names| names.iter().any(|name| of_it(name))));
    if bonded {
        return rules.refuse(&key, "its grains are bonded, and a bond turns them", "false", "");
    }
    Ok(())
}

fn pairs(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let possible = possible(document);
    let mut stated: Vec<(&str, [&str; 2])> = Vec::new();
    for (pair, properties) in &document.pairs {
        let table = format!("pairs.{pair}");
        let materials = split(document, pair, rules)?;
        if let Some((other, _)) = stated.iter().find(|(_, stated)| *stated == materials) {
            return rules.refuse(
                &table,
                format_args!("is the same pair as {other}"),
                "",
                "delete one of them",
            );
        }
        if !possible.iter().any(|(pair, _)| *pair == materials) {
            let [one, other] = materials;
            let found = format!("no grain can bring {one} and {other} into contact");
            return rules.refuse(&table, found, "", "delete it");
        }
        stated.push((pair, materials));
        let restitution = properties.restitution;
        let holds = restitution > 0.0 && restitution <= 1.0;
        rules.number(&format!("{table}.restitution"), restitution, holds, "more than 0, at most 1")?;
        let friction = properties.sliding_friction;
        rules.number(&format!("{table}.sliding-friction"), friction, friction >= 0.0, "0 or more")?;
        if let Some(micro) = materials.into_iter().find(|material| document.materials[*material].micro) {
            let allowed = format!("0, since {micro} is of micro grains, which bear no tangential force");
            for (key, value) in [
                ("sliding-friction", friction),
                ("rolling-friction", properties.rolling_friction.unwrap_or(0.0)),
            ] {
                rules.number(&format!("{table}.{key}"), value, value == 0.0, &allowed)?;
            }
        }
    }
    for ([one, other], key) in possible {
        if !stated.iter().any(|(_, pair)| *pair == [one, other]) {
            let advice = format!("add [pairs.{one}-{other}] with restitution and sliding-friction");
            return rules.refuse(&key, format_args!("how {one} and {other} touch is not stated"), "", advice);
        }
    }
    Ok(())
}

/// The two materials of `NAME-NAME`, sorted.
fn split<'a>(document: &'a Document, pair: &'a str, rules: &Rules) -> Result<[&'a str; 2], CaseError> {
    let table = format!("pairs.{pair}");
    let named = |material: &str| document.materials.contains_key(material);
    let mut splits = pair
        .match_indices('-')
        .map(|(at, _)| sorted(&pair[..at], &pair[at + 1..]))
        .filter(|[one, other]| named(one) && named(other))
        .collect::<BTreeSet<_>>()
        .into_iter();
    match (splits.next(), splits.next()) {
        (Some(materials), None) => Ok(materials),
        (Some(_), Some(_)) => rules.refuse(
            &table,
            "can be read as two pairs of materials",
            "",
            "rename a material, without hyphen",
        ),
        (None, _) => {
            let names: Vec<&String> = document.materials.keys().collect();
            let known: Vec<String> = names
                .iter()
                .enumerate()
                .flat_map(|(k, one)| names[k..].iter().map(move |other| format!("{one}-{other}")))
                .collect();
            let either_order: Vec<String> = names
                .iter()
                .flat_map(|one| names.iter().map(move |other| format!("{one}-{other}")))
                .collect();
            rules.refuse(
                &table,
                "does not name two materials",
                known.join(", "),
                did_you_mean(pair, &either_order),
            )
        }
    }
}

fn sorted<'a>(one: &'a str, other: &'a str) -> [&'a str; 2] {
    if one <= other { [one, other] } else { [other, one] }
}

/// The pairs of materials that may touch, each with the key that says so: two grains of which one moves, or a
/// moving grain and a wall.
fn possible(document: &Document) -> Vec<([&str; 2], String)> {
    let mut pairs: Vec<([&str; 2], String)> = Vec::new();
    for (i, one) in document.insertion.iter().enumerate() {
        let lone = matches!(one.placement(), Some(Placement::At([_])));
        for (j, other) in document.insertion[..=i].iter().enumerate() {
            let apart = one.frozen && other.frozen || i == j && lone;
            if !apart {
                pairs.push((sorted(&one.material, &other.material), format!("insertion[{i}].material")));
            }
        }
        if !one.frozen {
            for (k, wall) in document.wall.iter().enumerate() {
                let Some(material) = &wall.material else { continue };
                pairs.push((sorted(&one.material, material), format!("wall[{k}].material")));
            }
        }
    }
    pairs
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CARRIED, CHANNEL, DRY, SETTLING, assert_refusals, document};

    #[test]
    fn materials_are_physical_and_used() {
        assert_refusals(
            SETTLING,
            &[
                (
                    r#""2500 kg/m^3""#,
                    r#""-1 kg/m^3""#,
                    "case.toml:9: materials.glass.density: found -1 kg/m^3; allowed: more than 0 kg/m^3",
                ),
                (
                    r#""5 MPa""#,
                    r#""0 Pa""#,
                    "case.toml:10: materials.glass.youngs-modulus: found 0 Pa; allowed: more than 0 Pa",
                ),
                (
                    r#"youngs-modulus = "5 MPa""#,
                    "",
                    "case.toml:8: materials.glass.youngs-modulus: missing; contacts need it, for example youngs-modulus = \"5 MPa\"",
                ),
                (
                    "poissons-ratio = 0.3",
                    "",
                    "case.toml:8: materials.glass.poissons-ratio: missing; contacts need it, for example poissons-ratio = 0.3",
                ),
                (
                    "poissons-ratio = 0.3",
                    "poissons-ratio = 0.51",
                    "case.toml:11: materials.glass.poissons-ratio: found 0.51; allowed: more than -1, at most 0.5",
                ),
                (
                    "poissons-ratio = 0.3",
                    "poissons-ratio = -1",
                    "case.toml:11: materials.glass.poissons-ratio: found -1; allowed: more than -1, at most 0.5",
                ),
                (
                    "[grains]",
                    "[materials.wood]\ndensity = \"600 kg/m^3\"\n[grains]",
                    "case.toml:15: materials.wood: no insertion and no wall is made of it; delete it",
                ),
                (
                    "[grains]",
                    "[materials.\"a.b\"]\ndensity = \"600 kg/m^3\"\n[grains]",
                    "case.toml:8: materials.a.b: found the name \"a.b\"; allowed: letters, digits, - and _",
                ),
            ],
        );
        assert_refusals(
            CARRIED,
            &[(
                "[grains]",
                "youngs-modulus = \"1 Pa\"\n[grains]",
                "case.toml:10: materials.glass.youngs-modulus: has no effect with normal-law = \"none\"; delete it",
            )],
        );
        assert_refusals(
            CHANNEL,
            &[(
                "[fluid]",
                "[materials.a]\ndensity = \"1 kg/m^3\"\n[fluid]",
                "case.toml:7: materials: has no effect without [grains]; delete it",
            )],
        );
    }

    #[test]
    fn every_possible_contact_has_its_pair_and_no_pair_is_idle() {
        assert_refusals(
            DRY,
            &[
                (
                    "restitution = 0.9",
                    "restitution = 0",
                    "case.toml:17: pairs.glass-glass.restitution: found 0; allowed: more than 0, at most 1",
                ),
                (
                    "restitution = 0.9",
                    "restitution = 1.1",
                    "case.toml:17: pairs.glass-glass.restitution: found 1.1; allowed: more than 0, at most 1",
                ),
                (
                    "restitution = 0.9",
                    "restitution = inf",
                    "case.toml:17: pairs.glass-glass.restitution: found inf; allowed: finite numbers",
                ),
                (
                    "sliding-friction = 0.3",
                    "sliding-friction = -0.3",
                    "case.toml:18: pairs.glass-glass.sliding-friction: found -0.3; allowed: 0 or more",
                ),
                (
                    "[pairs.steel-glass]",
                    "[pairs.steel-glas]",
                    "case.toml:19: pairs.steel-glas: does not name two materials; allowed: glass-glass, glass-steel, steel-steel; did you mean \"steel-glass\"?",
                ),
                (
                    "[pairs.steel-glass]",
                    "[pairs.steel-steel]",
                    "case.toml:19: pairs.steel-steel: no grain can bring steel and steel into contact; delete it",
                ),
                (
                    "[pairs.steel-glass]\nrestitution = 0.8\nsliding-friction = 0.1\n",
                    "",
                    "case.toml:31: wall[0].material: how glass and steel touch is not stated; add [pairs.glass-steel] with restitution and sliding-friction",
                ),
                (
                    "[grains]",
                    "[pairs.glass-steel]\nrestitution = 0.8\nsliding-friction = 0.1\n[grains]",
                    "case.toml:19: pairs.steel-glass: is the same pair as glass-steel; delete one of them",
                ),
            ],
        );
        assert_refusals(
            CARRIED,
            &[(
                "[grains]",
                "[pairs.glass-glass]\nrestitution = 0.8\nsliding-friction = 0.1\n[grains]",
                "case.toml:10: pairs: has no effect with normal-law = \"none\"; delete it",
            )],
        );
    }

    #[test]
    fn micro_grains_rub_on_nothing_and_are_not_bonded() {
        let micro = "poissons-ratio = 0.3\nmicro = true";
        let settling = SETTLING.replace("poissons-ratio = 0.3", micro);
        let message = "case.toml:15: pairs.glass-glass.sliding-friction: found 0.3; allowed: 0, since glass is of micro grains, which bear no tangential force";
        assert_refusals(SETTLING, &[("poissons-ratio = 0.3", micro, message)]);
        let smooth = settling.replace("sliding-friction = 0.3", "sliding-friction = 0");
        assert!(document(&smooth).materials["glass"].micro);
        let bond = "[[bond]]\nlaw = \"parallel-bond\"\ngap = \"1 mm\"\nyoungs-modulus = \"1 MPa\"\nstiffness-ratio = 2.5\n[fluid]";
        let message = "case.toml:12: materials.glass.micro: its grains are bonded, and a bond turns them; allowed: false";
        assert_refusals(&smooth, &[("[fluid]", bond, message)]);
    }

    #[test]
    fn a_lone_grain_needs_no_pair_with_itself() {
        let lone = SETTLING.replace(r#", ["0 m", "0 m", "0.6 m"]"#, "").replace("name = \"floor\"\nmaterial = \"glass\"", "name = \"floor\"\nmaterial = \"steel\"")
            .replace("[pairs.glass-glass]", "[materials.steel]\ndensity = \"1 kg/m^3\"\nyoungs-modulus = \"1 Pa\"\npoissons-ratio = 0\n[pairs.steel-glass]");
        let document = document(&lone);
        assert_eq!(document.pair("glass", "steel"), document.pair("steel", "glass"));
        assert!(document.pair("glass", "steel").is_some() && document.pair("glass", "glass").is_none());
    }

    #[test]
    fn a_pair_that_can_be_read_in_two_ways_is_refused() {
        let mut text = DRY.to_string();
        for name in ["a", "a-b", "b-a"] {
            text += &format!(
                "[materials.{name}]\ndensity = \"1 kg/m^3\"\nyoungs-modulus = \"1 Pa\"\npoissons-ratio = 0\n\
                 [[wall]]\nname = \"of-{name}\"\nmaterial = \"{name}\"\n\
                 plane = {{ point = [\"0 m\", \"0 m\"], normal = [0, 1] }}\n\
                 [pairs.glass-{name}]\nrestitution = 1\nsliding-friction = 0\n"
            );
        }
        let pair = "[pairs.a-b-a]\nrestitution = 1\nsliding-friction = 0\n[grains]";
        let message = "case.toml:22: pairs.a-b-a: can be read as two pairs of materials; rename a material, without hyphen";
        assert_refusals(&text, &[("[grains]", pair, message)]);
    }
}
