//! `[[clump]]`, and the insertions that insert them.

use super::rules::Rules;
use super::wall::direction;
use crate::document::{Clump, Dimension, Document, Insertion, Placement};
use crate::error::CaseError;

/// Spheres touch where they are no further apart than this fraction of the sum of their radii.
const TOUCHING: f64 = 1e-6;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    if document.grains.is_none() {
        return rules.no_effect("clump", "without [grains]");
    }
    if document.fluid.is_some() && !document.clump.is_empty() {
        return rules.refuse(
            "clump",
            "clumps feel no fluid",
            "grains in a fluid",
            "leave out [fluid] or [[clump]]",
        );
    }
    rules.names("clump", document.clump.iter().map(|clump| clump.name.as_str()))?;
    for (index, clump) in document.clump.iter().enumerate() {
        let table = format!("clump[{index}]");
        let used = |insertion: &Insertion| insertion.clump.as_ref() == Some(&clump.name);
        if !document.insertion.iter().any(used) {
            return rules.refuse(&table, "no insertion inserts it", "", "delete it");
        }
        spheres(clump, &table, rules)?;
        rules.optional_positive(&format!("{table}.mass"), clump.mass)?;
    }
    Ok(())
}

/// Each is a sphere with a centre of its own, and all are one body.
fn spheres(clump: &Clump, table: &str, rules: &Rules) -> Result<(), CaseError> {
    let key = format!("{table}.spheres");
    if clump.spheres.is_empty() {
        let advice = "write for example [{ centre = [\"0 m\", …], radius = \"1 mm\" }, …]";
        return rules.refuse(&key, "there is no sphere in it", "", advice);
    }
    for (k, sphere) in clump.spheres.iter().enumerate() {
        rules.vector(&format!("{key}[{k}].centre"), &sphere.centre)?;
        rules.positive(&format!("{key}[{k}].radius"), sphere.radius)?;
    }
    let apart = |one: usize, other: usize| -> f64 {
        let (a, b) = (&clump.spheres[one], &clump.spheres[other]);
        let (x, y) = (a.centre.to_array::<3>(), b.centre.to_array::<3>());
        let distance = (0..3).map(|axis| (x[axis] - y[axis]).powi(2)).sum::<f64>().sqrt();
        distance / (a.radius.si() + b.radius.si())
    };
    let pairs = (0..clump.spheres.len()).flat_map(|other| (0..other).map(move |one| (one, other)));
    if let Some((one, other)) = pairs.into_iter().find(|&(one, other)| apart(one, other) < TOUCHING) {
        let found = format!("has the same centre as spheres[{one}]");
        return rules.refuse(&format!("{key}[{other}].centre"), found, "", "delete one of them");
    }
    let mut reached = vec![0];
    let mut left: Vec<usize> = (1..clump.spheres.len()).collect();
    for next in 0..clump.spheres.len() {
        let Some(&from) = reached.get(next) else {
            let found = format!("touches none of the {next} spheres that hang together with spheres[0]");
            let advice = "move it, or make two clumps";
            return rules.refuse(&format!("{key}[{}]", left[0]), found, "one body", advice);
        };
        let (near, far) = left.into_iter().partition(|&sphere| apart(from, sphere) <= 1.0 + TOUCHING);
        reached.extend::<Vec<usize>>(near);
        left = far;
    }
    Ok(())
}

/// The keys of an insertion of clumps, and of one of grains.
pub(super) fn inserted(
    document: &Document,
    insertion: &Insertion,
    table: &str,
    rules: &Rules,
) -> Result<(), CaseError> {
    let key = |name: &str| format!("{table}.{name}");
    let Some(name) = &insertion.clump else {
        let of_clumps = ["orientation", "random-orientation", "spin"];
        return of_clumps.iter().try_for_each(|name| rules.no_effect(&key(name), "without clump"));
    };
    let known: Vec<&str> = document.clump.iter().map(|clump| clump.name.as_str()).collect();
    rules.known(&key("clump"), "clump", name, &known)?;
    if insertion.frozen {
        let advice = "insert its spheres as frozen grains";
        return rules.refuse(&key("frozen"), "clumps move", "false", advice);
    }
    if matches!(insertion.placement(), Some(Placement::File(_))) {
        let allowed = "at, lattice, random-box, random-sphere, random-cylinder, rate";
        return rules.refuse(&key("file"), "a file places grains, not clumps", allowed, "");
    }
    if insertion.random_orientation {
        rules.no_effect(&key("orientation"), "where random-orientation = true")?;
    }
    if let Some(turn) = &insertion.orientation {
        axis(&key("orientation.axis"), turn.axis.as_deref(), rules)?;
    }
    if let Some(spin) = &insertion.spin {
        axis(&key("spin.axis"), spin.axis.as_deref(), rules)?;
    }
    Ok(())
}

fn axis(key: &str, stated: Option<&[f64]>, rules: &Rules) -> Result<(), CaseError> {
    match (stated, rules.dimension) {
        (None, Dimension::Three) => rules.required(key, "state its direction"),
        (Some(axis), Dimension::Three) => direction(rules, key, axis, "any direction"),
        (_, Dimension::Two) => rules.no_effect(key, "in 2D, where the axis is z"),
    }
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CHANNEL, DRY, SETTLING, assert_refusals, document};

    const OF_CLUMP: &str = "# more of the clump";
    const OF_INSERTION: &str = "# more of the insertion";
    const PAIR: &str =
        r#"[{ centre = ["0 mm", "0 mm"], radius = "1 mm" }, { centre = ["1 mm", "0 mm"], radius = "1 mm" }]"#;

    /// The discs with a clump of these spheres and keys, which an insertion with these keys inserts.
    fn with(spheres: &str, of_clump: &str, of_insertion: &str) -> String {
        let clump = format!("[[clump]]\nname = \"pair\"\nspheres = {spheres}\n{of_clump}\n[[insertion]]");
        let dry = DRY.replace("[[insertion]]", &clump);
        dry.replace("diameter = \"2 mm\"", &format!("clump = \"pair\"\n{of_insertion}"))
    }

    #[test]
    fn a_clump_is_one_body_of_spheres_with_mass() {
        document(&with(
            PAIR,
            "mass = \"1 g\"",
            "orientation = { angle = \"30 deg\" }\nspin = { rate = \"1 rad/s\" }",
        ));
        document(&with(PAIR, "", "random-orientation = true"));
        let rows = [
            (
                PAIR,
                "[]",
                "case.toml:29: clump[0].spheres: there is no sphere in it; write for example [{ centre = [\"0 m\", …], radius = \"1 mm\" }, …]",
            ),
            (
                PAIR,
                r#"[{ centre = ["0 mm"], radius = "1 mm" }]"#,
                "case.toml:29: clump[0].spheres[0].centre: found 1 components; allowed: 2; case.dimension is 2",
            ),
            (
                PAIR,
                r#"[{ centre = ["0 mm", "0 mm"], radius = "0 mm" }]"#,
                "case.toml:29: clump[0].spheres[0].radius: found 0 m; allowed: more than 0 m",
            ),
            (
                PAIR,
                r#"[{ centre = ["0 mm", "0 mm"], radius = "1 mm" }, { centre = ["0 mm", "0 mm"], radius = "2 mm" }]"#,
                "case.toml:29: clump[0].spheres[1].centre: has the same centre as spheres[0]; delete one of them",
            ),
            (
                PAIR,
                r#"[{ centre = ["0 mm", "0 mm"], radius = "1 mm" }, { centre = ["5 mm", "0 mm"], radius = "1 mm" }, { centre = ["2 mm", "0 mm"], radius = "1 mm" }]"#,
                "case.toml:29: clump[0].spheres[1]: touches none of the 2 spheres that hang together with spheres[0]; allowed: one body; move it, or make two clumps",
            ),
            (OF_CLUMP, "mass = \"0 g\"", "case.toml:30: clump[0].mass: found 0 kg; allowed: more than 0 kg"),
        ];
        assert_refusals(&with(PAIR, OF_CLUMP, OF_INSERTION), &rows);
    }

    #[test]
    fn clumps_are_inserted_by_name_and_move_freely() {
        let rows = [
            (
                "orientation = { axis = [0, 0, 1], angle = \"30 deg\" }",
                "case.toml:35: insertion[0].orientation.axis: has no effect in 2D, where the axis is z; delete it",
            ),
            (
                "random-orientation = true\norientation = { angle = \"30 deg\" }",
                "case.toml:36: insertion[0].orientation: has no effect where random-orientation = true; delete it",
            ),
            (
                "frozen = true",
                "case.toml:35: insertion[0].frozen: clumps move; allowed: false; insert its spheres as frozen grains",
            ),
            (
                "diameter = \"2 mm\"",
                "case.toml:31: insertion[0]: diameter and clump exclude each other; allowed: exactly one of diameter, diameter-range, diameter-distribution, clump",
            ),
        ];
        let sound = with(PAIR, OF_CLUMP, OF_INSERTION);
        assert_refusals(&sound, &rows.map(|(keys, message)| (OF_INSERTION, keys, message)));
        let message = "case.toml:34: insertion[0].clump: there is no clump \"pear\"; allowed: pair; did you mean \"pair\"?";
        assert_refusals(&sound, &[("clump = \"pair\"", "clump = \"pear\"", message)]);
        let idle = format!("[[clump]]\nname = \"pair\"\nspheres = {PAIR}\n[[insertion]]");
        let alone = "case.toml:27: clump[0]: no insertion inserts it; delete it";
        let spun = "case.toml:31: insertion[0].spin: has no effect without clump; delete it";
        let turned = "diameter = \"2 mm\"\nspin = { rate = \"1 rad/s\" }";
        assert_refusals(DRY, &[("[[insertion]]", &idle, alone), ("diameter = \"2 mm\"", turned, spun)]);
        let glued = "[[bond]]\nlaw = \"cohesive\"\ngap = \"1 mm\"\nyoungs-modulus = \"1 GPa\"\npoissons-ratio = 0.2\n[[wall]]";
        let message = "case.toml:37: bond[0].insertions: \"lattice\" inserts clumps, which are not bonded; allowed: insertions of grains; name those";
        assert_refusals(&sound, &[("[[wall]]", glued, message)]);
    }

    #[test]
    fn clumps_need_grains_and_feel_no_fluid() {
        let clump = "[[clump]]\nname = \"pair\"\nspheres = []\n";
        let idle = "case.toml:7: clump: has no effect without [grains]; delete it";
        assert_refusals(CHANNEL, &[("[fluid]\n", &format!("{clump}[fluid]\n"), idle)]);
        let wet = "case.toml:17: clump: clumps feel no fluid; allowed: grains in a fluid; leave out [fluid] or [[clump]]";
        assert_refusals(SETTLING, &[("[[insertion]]", &format!("{clump}[[insertion]]"), wet)]);
    }
}
