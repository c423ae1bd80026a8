//! `[[fluid.inlet]]`, `[[fluid.outlet]]`, and what inlets and outlets on boundaries of the mesh lack where nodes move.

use super::fluid::velocity;
use super::rules::Rules;
use super::wall::direction;
use crate::document::quantity::{Length, Velocity};
use crate::document::vector::extent;
use crate::document::{Boundary, BoundaryVelocity, Dimension, Disc, Fluid, Inlet, Profile, unit_vector};
use crate::error::CaseError;

pub(super) fn check(fluid: &Fluid, rules: &Rules) -> Result<(), CaseError> {
    rules.names("fluid.inlet", fluid.inlet.iter().map(|inlet| inlet.name.as_str()))?;
    rules.names("fluid.outlet", fluid.outlet.iter().map(|outlet| outlet.name.as_str()))?;
    for (index, stated) in fluid.inlet.iter().enumerate() {
        inlet(fluid, stated, &format!("fluid.inlet[{index}]"), rules)?;
    }
    for (index, outlet) in fluid.outlet.iter().enumerate() {
        let table = format!("fluid.outlet[{index}]");
        rules.vector(&format!("{table}.beyond.point"), &outlet.beyond.point)?;
        let allowed = "any direction, towards the fluid that stays";
        direction(rules, &format!("{table}.beyond.normal"), &outlet.beyond.normal, allowed)?;
        if let Some(within) = &outlet.within {
            rules.corners(&format!("{table}.within"), &within.lower, &within.upper)?;
        }
    }
    Ok(())
}

/// What a boundary of the mesh that is an inlet or an outlet may not state.
pub(super) fn boundary(boundary: &Boundary, table: &str, rules: &Rules) -> Result<(), CaseError> {
    if boundary.profile == Some(Profile::Parabolic) {
        let advice = "state the profile as velocity = { expression = […] }";
        return rules.refuse(
            &format!("{table}.profile"),
            "backend \"pfem\" has no profile \"parabolic\"",
            "constant",
            advice,
        );
    }
    rules.optional_positive(&format!("{table}.speed"), boundary.speed)?;
    match boundary.pressure {
        Some(pressure) if pressure.si() != 0.0 => rules.refuse(
            &format!("{table}.pressure"),
            format_args!("found {pressure}: fluid of backend \"pfem\" leaves against no pressure"),
            "0 Pa",
            "",
        ),
        _ => Ok(()),
    }
}

fn inlet(fluid: &Fluid, inlet: &Inlet, table: &str, rules: &Rules) -> Result<(), CaseError> {
    let key = |name: &str| format!("{table}.{name}");
    rules.exactly_one(table, &["box", "disc"])?;
    direction(rules, &key("normal"), &inlet.normal, "any direction, into the fluid")?;
    if inlet.flat.is_some() {
        flat(inlet, table, rules)?;
    }
    if let Some(Disc { centre, radius }) = &inlet.disc {
        if rules.dimension == Dimension::Two {
            return rules.refuse(&key("disc"), "a disc is no inlet in 2D", "", "use a box: a segment");
        }
        rules.vector(&key("disc.centre"), centre)?;
        rules.positive(&key("disc.radius"), *radius)?;
    }
    thickness(fluid, inlet, table, rules)?;
    rules.exactly_one(table, &["velocity", "speed"])?;
    rules.optional_positive(&key("speed"), inlet.speed)?;
    velocity(&key("velocity"), inlet.velocity.as_ref(), rules)?;
    if let Some(BoundaryVelocity::Constant(stated)) = &inlet.velocity {
        let (normal, stated) = (unit_vector::<3>(&inlet.normal), stated.to_array::<3>());
        let into: f64 = (0..3).map(|k| normal[k] * stated[k]).sum();
        if into <= 0.0 {
            let found = format!("it has {} along the normal", Velocity::from_si(into));
            let allowed = "more than 0 m/s: into the fluid";
            return rules.refuse(&key("velocity"), found, allowed, "turn it or the normal round");
        }
    }
    Ok(())
}

/// A flat box has no thickness along one axis, that of the normal.
fn flat(inlet: &Inlet, table: &str, rules: &Rules) -> Result<(), CaseError> {
    let Some(bounds) = &inlet.flat else { return Ok(()) };
    let key = |name: &str| format!("{table}.{name}");
    rules.vector(&key("box.lower"), &bounds.lower)?;
    rules.vector(&key("box.upper"), &bounds.upper)?;
    let extent = extent(&bounds.lower, &bounds.upper);
    let axes = 0..rules.dimension.count();
    let thin: Vec<usize> = axes.clone().filter(|&axis| extent[axis] == 0.0).collect();
    let &[axis] = thin.as_slice() else {
        let found = format!("lower and upper agree along {} axes", thin.len());
        return rules.refuse(&key("box"), found, "along one: an inlet is flat", "");
    };
    if let Some(axis) = axes.clone().find(|&axis| extent[axis] < 0.0) {
        let found = format!("found {}", Length::from_si(bounds.upper.to_array::<3>()[axis]));
        let allowed = format!("lower or more, {}", Length::from_si(bounds.lower.to_array::<3>()[axis]));
        return rules.refuse(&key(&format!("box.upper[{axis}]")), found, allowed, "");
    }
    if axes.clone().any(|other| other != axis && inlet.normal[other] != 0.0) {
        let allowed = format!("along the {} axis, across the box", ["x", "y", "z"][axis]);
        return rules.refuse(&key("normal"), "it is not the normal of the box", allowed, "");
    }
    Ok(())
}

/// Widths of decimal numbers are this exact.
const ROUND_OFF: f64 = 1e-9;

/// An inlet is at least one cell wide.
fn thickness(fluid: &Fluid, inlet: &Inlet, table: &str, rules: &Rules) -> Result<(), CaseError> {
    let Some(size) = fluid.pfem.as_ref().and_then(|pfem| pfem.size) else { return Ok(()) };
    let (key, least) = match (&inlet.flat, &inlet.disc) {
        (Some(bounds), _) => {
            let extent = extent(&bounds.lower, &bounds.upper);
            ("box", extent.into_iter().filter(|&edge| edge > 0.0).fold(f64::INFINITY, f64::min))
        }
        (None, Some(disc)) => ("disc", 2.0 * disc.radius.si()),
        (None, None) => return Ok(()),
    };
    if least >= size.si() * (1.0 - ROUND_OFF) {
        return Ok(());
    }
    let found = format!("it is {} wide", Length::from_si(least));
    let allowed = format!("at least the size of the cells, {size}");
    rules.refuse(&format!("{table}.{key}"), found, allowed, "widen it, or lower fluid.pfem.size")
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{TANK, assert_refusals, document};

    const NOZZLE: &str = "[[fluid.inlet]]\nname = \"nozzle\"\nnormal = [1, 0]\nspeed = \"1 m/s\"\nbox = { lower = [\"0 m\", \"2 m\"], upper = [\"0 m\", \"2.25 m\"] }\n[[wall]]";

    fn with(from: &str, to: &str) -> String {
        let inlet = NOZZLE.replace(from, to);
        assert!(from.is_empty() || inlet != NOZZLE);
        inlet
    }

    #[test]
    fn an_inlet_is_flat_and_blows_into_the_fluid() {
        document(&TANK.replace("[[wall]]", NOZZLE));
        let rows = [
            (
                with("\"2.25 m\"", "\"2 m\""),
                "case.toml:27: fluid.inlet[0].box: lower and upper agree along 2 axes; allowed: along one: an inlet is flat",
            ),
            (
                with("\"2.25 m\"", "\"1.8 m\""),
                "case.toml:27: fluid.inlet[0].box.upper[1]: found 1.8 m; allowed: lower or more, 2 m",
            ),
            (
                with("[1, 0]", "[1, 1]"),
                "case.toml:25: fluid.inlet[0].normal: it is not the normal of the box; allowed: along the x axis, across the box",
            ),
            (
                with("\"1 m/s\"", "\"0 m/s\""),
                "case.toml:26: fluid.inlet[0].speed: found 0 m/s; allowed: more than 0 m/s",
            ),
            (
                with("speed = \"1 m/s\"", "velocity = [\"-1 m/s\", \"0 m/s\"]"),
                "case.toml:26: fluid.inlet[0].velocity: it has -1 m/s along the normal; allowed: more than 0 m/s: into the fluid; turn it or the normal round",
            ),
            (
                with("speed = \"1 m/s\"\n", ""),
                "case.toml:23: fluid.inlet[0]: none of these keys is given; allowed: exactly one of velocity, speed",
            ),
            (
                with("[[wall]]", "[fluid.pfem]\nsize = \"0.3 m\"\n[[wall]]"),
                "case.toml:27: fluid.inlet[0].box: it is 0.25 m wide; allowed: at least the size of the cells, 0.3 m; widen it, or lower fluid.pfem.size",
            ),
            (
                with(
                    "box = { lower = [\"0 m\", \"2 m\"], upper = [\"0 m\", \"2.25 m\"] }",
                    "disc = { centre = [\"0 m\", \"2 m\"], radius = \"1 m\" }",
                ),
                "case.toml:27: fluid.inlet[0].disc: a disc is no inlet in 2D; use a box: a segment",
            ),
        ];
        for (to, message) in &rows {
            assert_refusals(TANK, &[("[[wall]]", to, message)]);
        }
    }

    #[test]
    fn an_outlet_is_a_plane_without_pressure() {
        let outlet = |normal: &str| {
            format!(
                "[[fluid.outlet]]\nname = \"drain\"\nbeyond = {{ point = [\"3 m\", \"0 m\"], normal = {normal} }}\n[[wall]]"
            )
        };
        document(&TANK.replace("[[wall]]", &outlet("[-1, 0]")));
        assert_refusals(
            TANK,
            &[
                (
                    "[[wall]]",
                    &outlet("[0, 0]"),
                    "case.toml:25: fluid.outlet[0].beyond.normal: all components are 0; allowed: any direction, towards the fluid that stays",
                ),
                (
                    "kind = \"free-surface\"",
                    "kind = \"outlet\"\npressure = \"1 Pa\"",
                    "case.toml:20: fluid.boundary[1].pressure: found 1 Pa: fluid of backend \"pfem\" leaves against no pressure; allowed: 0 Pa",
                ),
                (
                    "kind = \"free-surface\"",
                    "kind = \"inlet\"\nspeed = \"1 m/s\"\nprofile = \"parabolic\"",
                    "case.toml:21: fluid.boundary[1].profile: backend \"pfem\" has no profile \"parabolic\"; allowed: constant; state the profile as velocity = { expression = […] }",
                ),
            ],
        );
    }
}
