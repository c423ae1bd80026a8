//! Regions of space.

use super::rules::Rules;
use crate::document::quantity::Length;
use crate::document::{Dimension, Point, Region};
use crate::error::CaseError;

pub(super) fn check(rules: &Rules, table: &str, region: Region) -> Result<(), CaseError> {
    let key = |key: &str| format!("{table}.{key}");
    match region {
        Region::Box(lower, upper) => rules.corners(table, lower, upper),
        Region::Sphere(centre, radius) => {
            rules.vector(&key("centre"), centre)?;
            rules.positive(&key("radius"), radius)
        }
        Region::Cylinder(from, to, radius) => cylinder(rules, table, from, to, radius),
        Region::Stl(_, scale) => surface(rules, table, scale),
    }
}

fn cylinder(rules: &Rules, table: &str, from: &Point, to: &Point, radius: Length) -> Result<(), CaseError> {
    if rules.dimension == Dimension::Two {
        return rules.refuse(table, "a cylinder is no region in 2D", "", "use a box or a sphere: a circle");
    }
    rules.vector(&format!("{table}.from"), from)?;
    rules.vector(&format!("{table}.to"), to)?;
    if from == to {
        return rules.refuse(&format!("{table}.to"), "is where from is", "another point", "");
    }
    rules.positive(&format!("{table}.radius"), radius)
}

fn surface(rules: &Rules, table: &str, scale: f64) -> Result<(), CaseError> {
    if rules.dimension == Dimension::Two {
        return rules.refuse(table, "triangles are no region in 2D", "", "use a box or a sphere: a circle");
    }
    rules.number(&format!("{table}.scale"), scale, scale > 0.0, "more than 0")
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{DRY, SETTLING, assert_refusals, document};

    const AT: &str = r#"at = [["0 m", "0 m", "0.5 m"], ["0 m", "0 m", "0.6 m"]]"#;
    const ENDS: &str = r#"from = ["0 m", "0 m", "0 m"], to = ["0 m", "0 m", "1 m"]"#;
    const CENTRE: &str = r#"centre = ["0 m", "0 m", "0.5 m"]"#;

    #[test]
    fn regions_have_an_inside() {
        let rows = [
            (
                format!("random-cylinder = {{ {ENDS}, radius = \"0 m\", count = 2 }}"),
                "case.toml:21: insertion[0].random-cylinder.radius: found 0 m; allowed: more than 0 m",
            ),
            (
                format!(
                    "random-cylinder = {{ {}, radius = \"1 m\", count = 2 }}",
                    ENDS.replace("\"1 m\"", "\"0 m\"")
                ),
                "case.toml:21: insertion[0].random-cylinder.to: is where from is; allowed: another point",
            ),
            (
                format!("random-sphere = {{ {CENTRE}, radius = \"1 m\" }}"),
                "case.toml:21: insertion[0].random-sphere: none of these keys is given; allowed: exactly one of count, solid-fraction",
            ),
            (
                format!("rate = {{ sphere = {{ {CENTRE}, radius = \"-1 m\" }}, number-rate = \"1 1/s\" }}"),
                "case.toml:21: insertion[0].rate.sphere.radius: found -1 m; allowed: more than 0 m",
            ),
            (
                "random-stl = { path = \"a.stl\", scale = 0, count = 2 }".to_string(),
                "case.toml:21: insertion[0].random-stl.scale: found 0; allowed: more than 0",
            ),
            (
                "random-stl = { path = \"a.stl\" }".to_string(),
                "case.toml:21: insertion[0].random-stl: none of these keys is given; allowed: exactly one of count, solid-fraction",
            ),
            (
                "rate = { number-rate = \"1 1/s\" }".to_string(),
                "case.toml:21: insertion[0].rate: none of these keys is given; allowed: exactly one of lower, sphere, cylinder, stl",
            ),
            (
                "rate = { lower = [\"0 m\", \"0 m\", \"0 m\"], number-rate = \"1 1/s\" }".to_string(),
                "case.toml:21: insertion[0].rate.upper: missing; state the other corner of the box",
            ),
        ];
        for (to, message) in &rows {
            assert_refusals(SETTLING, &[(AT, to, message)]);
        }
        for sound in [
            format!("random-cylinder = {{ {ENDS}, radius = \"1 m\", count = 2 }}"),
            format!("random-sphere = {{ {CENTRE}, radius = \"1 m\", solid-fraction = 0.1 }}"),
            "random-stl = { path = \"a.stl\", scale = 0.001, count = 2 }".to_string(),
            "rate = { stl = { path = \"a.stl\" }, number-rate = \"1 1/s\" }".to_string(),
            format!("rate = {{ cylinder = {{ {ENDS}, radius = \"1 m\" }}, mass-rate = \"1 g/s\" }}"),
        ] {
            document(&SETTLING.replace(AT, &sound));
        }
        let lattice = DRY.lines().find(|line| line.starts_with("lattice")).unwrap();
        let flat =
            r#"random-cylinder = { from = ["0 m", "0 m"], to = ["0 m", "1 m"], radius = "1 m", count = 2 }"#;
        assert_refusals(
            DRY,
            &[(
                lattice,
                flat,
                "case.toml:31: insertion[0].random-cylinder: a cylinder is no region in 2D; use a box or a sphere: a circle",
            )],
        );
    }
}
