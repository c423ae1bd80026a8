//! `[[insertion]]`

use super::rules::Rules;
use super::{clump, region, sizes};
use crate::document::quantity::{Length, Time};
use crate::document::{Document, Insertion, NormalLaw, Placement, Rate, Region};
use crate::error::CaseError;

const PLACEMENTS: [&str; 8] =
    ["at", "lattice", "random-box", "random-sphere", "random-cylinder", "random-stl", "file", "rate"];

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let Some(grains) = &document.grains else {
        return rules.no_effect("insertion", "without [grains]");
    };
    if document.insertion.is_empty() {
        return rules.refuse("grains", "there are no grains", "", "add an [[insertion]]");
    }
    rules.names("insertion", document.insertion.iter().map(|insertion| insertion.name.as_str()))?;
    let materials: Vec<&str> = document.materials.keys().map(String::as_str).collect();
    for (index, insertion) in document.insertion.iter().enumerate() {
        let table = format!("insertion[{index}]");
        rules.known(&format!("{table}.material"), "material", &insertion.material, &materials)?;
        rules.exactly_one(&table, &PLACEMENTS)?;
        clump::inserted(document, insertion, &table, rules)?;
        sizes::check(insertion, &table, rules)?;
        rules.optional_vector(&format!("{table}.velocity"), insertion.velocity.as_ref())?;
        if insertion.frozen {
            rules.no_effect(&format!("{table}.velocity"), "where frozen = true")?;
        }
        let overlap_matters = grains.normal_law != NormalLaw::None && !insertion.frozen;
        placement(document, insertion, &table, overlap_matters, rules)?;
    }
    Ok(())
}

fn placement(
    document: &Document,
    insertion: &Insertion,
    table: &str,
    overlap_matters: bool,
    rules: &Rules,
) -> Result<(), CaseError> {
    match insertion.placement() {
        Some(Placement::At(centres)) => {
            let key = format!("{table}.at");
            if centres.is_empty() {
                return rules.refuse(
                    &key,
                    "there is no centre in it",
                    "",
                    "write for example [[\"0 m\", …], …]",
                );
            }
            centres
                .iter()
                .enumerate()
                .try_for_each(|(k, centre)| rules.vector(&format!("{key}[{k}]"), centre))
        }
        Some(Placement::Lattice(lattice)) => {
            let key = format!("{table}.lattice");
            rules.corners(&key, &lattice.lower, &lattice.upper)?;
            rules.positive(&format!("{key}.spacing"), lattice.spacing)?;
            match insertion.diameters().map(|[_, largest]| Length::from_si(largest)) {
                Some(largest) if overlap_matters && lattice.spacing.si() < largest.si() => rules.refuse(
                    &format!("{key}.spacing"),
                    format_args!("found {}: the grains overlap", lattice.spacing),
                    format_args!("at least the diameter, {largest}"),
                    "",
                ),
                _ => Ok(()),
            }
        }
        Some(Placement::Random(random)) => {
            let key = format!("{table}.{}", random.key);
            region::check(rules, &key, random.region)?;
            rules.exactly_one(&key, &["count", "solid-fraction"])?;
            if random.count == Some(0) {
                return rules.refuse(&format!("{key}.count"), "found 0", "1 or more", "");
            }
            let fraction = random.solid_fraction.unwrap_or(0.5);
            let allowed = "more than 0, less than 1 (random packings end near 0.6)";
            rules.number(
                &format!("{key}.solid-fraction"),
                fraction,
                fraction > 0.0 && fraction < 1.0,
                allowed,
            )
        }
        Some(Placement::Rate(feed)) => rate(document, feed, &format!("{table}.rate"), rules),
        Some(Placement::File(_)) | None => Ok(()),
    }
}

fn rate(document: &Document, rate: &Rate, table: &str, rules: &Rules) -> Result<(), CaseError> {
    rules.exactly_one(table, &["lower", "sphere", "cylinder", "stl"])?;
    if rate.lower.is_some() {
        rules.required(&format!("{table}.upper"), "state the other corner of the box")?;
    } else {
        rules.no_effect(&format!("{table}.upper"), "without lower")?;
    }
    if let Some(stated) = rate.region() {
        let within = match stated {
            Region::Box(..) => "",
            Region::Sphere(..) => ".sphere",
            Region::Cylinder(..) => ".cylinder",
            Region::Stl(..) => ".stl",
        };
        let key = format!("{table}{within}");
        region::check(rules, &key, stated)?;
    }
    rules.exactly_one(table, &["mass-rate", "number-rate"])?;
    rules.optional_positive(&format!("{table}.mass-rate"), rate.mass_rate)?;
    rules.optional_positive(&format!("{table}.number-rate"), rate.number_rate)?;
    let start = rate.start.unwrap_or(Time::from_si(0.0));
    let end = document.time.end;
    if let Some(found) = rate.start.filter(|start| start.si() < 0.0 || start.si() >= end.si()) {
        let allowed = format!("from 0 s, before the end of the run, {end}");
        return rules.refuse(&format!("{table}.start"), format_args!("found {found}"), allowed, "");
    }
    if let Some(stop) = rate.stop.filter(|stop| stop.si() <= start.si()) {
        let allowed = format!("after the start, {start}");
        return rules.refuse(&format!("{table}.stop"), format_args!("found {stop}"), allowed, "");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CARRIED, CHANNEL, DRY, SETTLING, assert_refusals, document};

    const AT: &str = r#"at = [["0 m", "0 m", "0.5 m"], ["0 m", "0 m", "0.6 m"]]"#;
    const BOX: &str = r#"lower = ["0 m", "0 m", "0 m"], upper = ["1 m", "1 m", "1 m"]"#;

    #[test]
    fn grains_and_insertions_go_together() {
        let grain = "[fluid]\nbackend = \"eulerian\"";
        assert_refusals(
            CHANNEL,
            &[(
                grain,
                &format!("[[insertion]]\nname = \"a\"\nmaterial = \"b\"\n{grain}"),
                "case.toml:7: insertion: has no effect without [grains]; delete it",
            )],
        );
        let insertion = CARRIED.split("[[insertion]]").nth(1).unwrap().split("[fluid]").next().unwrap();
        let insertion = format!("[[insertion]]{insertion}");
        assert_refusals(
            CARRIED,
            &[(&insertion, "", "case.toml:10: grains: there are no grains; add an [[insertion]]")],
        );
    }

    #[test]
    fn an_insertion_is_placed_once_and_sized_once() {
        assert_refusals(
            SETTLING,
            &[
                (
                    "name = \"bed\"",
                    "name = \"a bed\"",
                    "case.toml:18: insertion[0].name: found the name \"a bed\"; allowed: letters, digits, - and _",
                ),
                (
                    "[[wall]]",
                    "[[insertion]]\nname = \"bed\"\nmaterial = \"glass\"\ndiameter = \"1 mm\"\nfile = { path = \"x\" }\n[[wall]]",
                    "case.toml:23: insertion[1].name: \"bed\" names two of [[insertion]]; rename one",
                ),
                (
                    "material = \"glass\"",
                    "material = \"glas\"",
                    "case.toml:19: insertion[0].material: there is no material \"glas\"; allowed: glass; did you mean \"glass\"?",
                ),
                (
                    AT,
                    "",
                    "case.toml:17: insertion[0]: none of these keys is given; allowed: exactly one of at, lattice, random-box, random-sphere, random-cylinder, random-stl, file, rate",
                ),
                (
                    "at = [[",
                    "file = { path = \"x.csv\" }\nat = [[",
                    "case.toml:17: insertion[0]: at and file exclude each other; allowed: exactly one of at, lattice, random-box, random-sphere, random-cylinder, random-stl, file, rate",
                ),
                (
                    AT,
                    "at = []",
                    "case.toml:21: insertion[0].at: there is no centre in it; write for example [[\"0 m\", …], …]",
                ),
                (
                    r#""0.6 m"]"#,
                    r#""0.6 m", "0 m"]"#,
                    "case.toml:21: insertion[0].at[1]: found 4 components; allowed: 3; case.dimension is 3",
                ),
                (
                    "diameter = \"2 mm\"",
                    "",
                    "case.toml:17: insertion[0]: none of these keys is given; allowed: exactly one of diameter, diameter-range, diameter-distribution, clump",
                ),
                (
                    "diameter = \"2 mm\"",
                    "diameter = \"0 mm\"",
                    "case.toml:20: insertion[0].diameter: found 0 m; allowed: more than 0 m",
                ),
                (
                    "diameter = \"2 mm\"",
                    "diameter = \"2 mm\"\ndiameter-range = [\"1 mm\", \"2 mm\"]",
                    "case.toml:17: insertion[0]: diameter and diameter-range exclude each other; allowed: exactly one of diameter, diameter-range, diameter-distribution, clump",
                ),
                (
                    "diameter = \"2 mm\"",
                    "diameter-range = [\"2 mm\", \"1 mm\"]",
                    "case.toml:20: insertion[0].diameter-range[1]: found 0.001 m; allowed: more than the smallest, 0.002 m",
                ),
                (
                    "diameter = \"2 mm\"",
                    "diameter-range = [\"2 mm\"]",
                    "case.toml:20: insertion[0].diameter-range: found 1 entries; allowed: 2 entries",
                ),
                (
                    "diameter = \"2 mm\"",
                    "diameter = \"2 mm\"\nvelocity = [\"0 m/s\"]",
                    "case.toml:21: insertion[0].velocity: found 1 components; allowed: 3; case.dimension is 3",
                ),
                (
                    "diameter = \"2 mm\"",
                    "diameter = \"2 mm\"\nfrozen = true\nvelocity = [\"0 m/s\", \"0 m/s\", \"1 m/s\"]",
                    "case.toml:22: insertion[0].velocity: has no effect where frozen = true; delete it",
                ),
            ],
        );
    }

    #[test]
    fn a_file_may_bring_its_own_diameters() {
        document(&SETTLING.replace(AT, "file = { path = \"x.csv\" }").replace("diameter = \"2 mm\"", ""));
    }

    #[test]
    fn regions_and_rates_make_sense() {
        assert_refusals(
            DRY,
            &[
                (
                    "2.2 mm",
                    "0 mm",
                    "case.toml:31: insertion[0].lattice.spacing: found 0 m; allowed: more than 0 m",
                ),
                (
                    "2.2 mm",
                    "1.9 mm",
                    "case.toml:31: insertion[0].lattice.spacing: found 0.0019 m: the grains overlap; allowed: at least the diameter, 0.002 m",
                ),
                (
                    r#"upper = ["1 cm", "1 cm"]"#,
                    r#"upper = ["1 cm", "0 cm"]"#,
                    "case.toml:31: insertion[0].lattice.upper[1]: found 0 m; allowed: more than lower, 0 m",
                ),
                (
                    "spacing",
                    "kind = \"cubic\", spacing",
                    "case.toml:31: insertion[0].lattice.kind: unknown kind \"cubic\"; allowed: simple-cubic, hexagonal",
                ),
            ],
        );
        let random = |rest: &str| format!("random-box = {{ {BOX}{rest} }}");
        let rate = |rest: &str| format!("rate = {{ {BOX}{rest} }}");
        assert_refusals(
            SETTLING,
            &[
                (
                    AT,
                    &random(""),
                    "case.toml:21: insertion[0].random-box: none of these keys is given; allowed: exactly one of count, solid-fraction",
                ),
                (
                    AT,
                    &random(", count = 0"),
                    "case.toml:21: insertion[0].random-box.count: found 0; allowed: 1 or more",
                ),
                (
                    AT,
                    &random(", count = -2"),
                    "case.toml:21: insertion[0].random-box.count: found -2; allowed: a whole number from 0",
                ),
                (
                    AT,
                    &random(", count = 2.5"),
                    "case.toml:21: insertion[0].random-box.count: found 2.5; allowed: a whole number from 0",
                ),
                (
                    AT,
                    &random(", solid-fraction = 1"),
                    "case.toml:21: insertion[0].random-box.solid-fraction: found 1; allowed: more than 0, less than 1 (random packings end near 0.6)",
                ),
                (
                    AT,
                    &rate(""),
                    "case.toml:21: insertion[0].rate: none of these keys is given; allowed: exactly one of mass-rate, number-rate",
                ),
                (
                    AT,
                    &rate(", mass-rate = \"-1 kg/s\""),
                    "case.toml:21: insertion[0].rate.mass-rate: found -1 kg/s; allowed: more than 0 kg/s",
                ),
                (
                    AT,
                    &rate(", number-rate = \"9 1/s\", start = \"2 s\""),
                    "case.toml:21: insertion[0].rate.start: found 2 s; allowed: from 0 s, before the end of the run, 2 s",
                ),
                (
                    AT,
                    &rate(", number-rate = \"9 1/s\", start = \"1 s\", stop = \"1 s\""),
                    "case.toml:21: insertion[0].rate.stop: found 1 s; allowed: after the start, 1 s",
                ),
            ],
        );
    }
}
