//! `[fluid]` and `[[fluid.boundary]]`

use super::gate;
use super::mesh::{self, boundary_names};
use super::pfem;
use super::rheology;
use super::rules::Rules;
use crate::document::{Backend, Boundary, BoundaryKind, BoundaryVelocity, Document, Fluid};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let Some(fluid) = &document.fluid else { return Ok(()) };
    rules.positive("fluid.density", fluid.density)?;
    rules.positive("fluid.viscosity", fluid.viscosity)?;
    match fluid.backend {
        Backend::Imposed => imposed(fluid, rules),
        Backend::Eulerian | Backend::Pfem => computed(document, fluid, rules),
    }
}

fn imposed(fluid: &Fluid, rules: &Rules) -> Result<(), CaseError> {
    for key in ["mesh", "boundary", "inlet", "outlet", "velocity", "body-force", "solve", "rheology"] {
        rules.no_effect(&format!("fluid.{key}"), "with backend = \"imposed\"")?;
    }
    rules.required(
        "fluid.field",
        "an imposed flow is stated there: field = { velocity = […], pressure = \"…\" }",
    )?;
    fluid
        .field
        .as_ref()
        .map_or(Ok(()), |field| rules.components("fluid.field.velocity", field.velocity.len()))
}

fn computed(document: &Document, fluid: &Fluid, rules: &Rules) -> Result<(), CaseError> {
    let backend = if fluid.backend == Backend::Pfem { "\"pfem\"" } else { "\"eulerian\"" };
    rules.no_effect("fluid.field", format_args!("with backend = {backend}"))?;
    velocity("fluid.velocity", fluid.velocity.as_ref(), rules)?;
    rules.optional_vector("fluid.body-force", fluid.body_force.as_ref())?;
    let tolerance = fluid.solve_tolerance();
    rules.number(
        "fluid.solve.tolerance",
        tolerance,
        tolerance > 0.0 && tolerance < 1.0,
        "more than 0, less than 1",
    )?;
    match (&fluid.mesh, fluid.backend) {
        (Some(mesh), _) => mesh::check(mesh, rules)?,
        (None, Backend::Pfem) if !fluid.body.is_empty() || !fluid.inlet.is_empty() => {}
        (None, _) => {
            let advice = format!("backend {backend} needs it: add [fluid.mesh] with box, pipe or gmsh");
            return rules.required("fluid.mesh", advice);
        }
    }
    if fluid.backend == Backend::Pfem {
        pfem::check(document, fluid, rules)?;
        gate::check(fluid, rules)?;
        fluid.rheology.as_ref().map_or(Ok(()), |stated| rheology::check(document, stated, rules))?;
    } else {
        for key in ["pfem", "rheology", "body", "inlet", "outlet", "mesh.box.surface"] {
            rules.no_effect(&format!("fluid.{key}"), format_args!("with backend = {backend}"))?;
        }
    }
    covered(document, fluid, rules)?;
    fluid.boundary.iter().enumerate().try_for_each(|(k, condition)| boundary(fluid, condition, k, rules))
}

/// Every boundary of the mesh has exactly one condition; walls may have one where nodes move.
fn covered(document: &Document, fluid: &Fluid, rules: &Rules) -> Result<(), CaseError> {
    let of_mesh = fluid.mesh.as_ref().map_or(Some(Vec::new()), |mesh| boundary_names(mesh, rules.dimension));
    let walls = document.wall.iter().filter(|_| fluid.backend == Backend::Pfem);
    let walls: Vec<&str> = walls.map(|wall| wall.name.as_str()).collect();
    let known = of_mesh.as_ref().map(|names| [names.as_slice(), &walls].concat());
    let twice = walls.iter().position(|wall| of_mesh.iter().flatten().any(|name| name == wall));
    if let Some(wall) = twice {
        let found = format!("the mesh has a boundary \"{}\" too", walls[wall]);
        return rules.refuse(&format!("wall[{wall}].name"), found, "", "rename the wall");
    }
    let mut named: Vec<&str> = Vec::new();
    for (k, condition) in fluid.boundary.iter().enumerate() {
        let key = format!("fluid.boundary[{k}].on");
        if condition.on.is_empty() {
            return rules.refuse(&key, "there is no name in it", "", "name boundaries of the mesh");
        }
        for (i, name) in condition.on.iter().enumerate() {
            let key = format!("{key}[{i}]");
            if let Some(known) = &known {
                rules.known(&key, "boundary", name, known)?;
            }
            if named.contains(&name.as_str()) {
                return rules.refuse(
                    &key,
                    format_args!("boundary \"{name}\" is named twice"),
                    "",
                    "delete one",
                );
            }
            named.push(name);
        }
    }
    let missing: Vec<&str> = of_mesh.into_iter().flatten().filter(|name| !named.contains(name)).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let found = format!("no condition is stated on {}", missing.join(", "));
    rules.refuse("fluid.boundary", found, "", "add a [[fluid.boundary]] with on = […] and kind")
}

fn boundary(fluid: &Fluid, boundary: &Boundary, index: usize, rules: &Rules) -> Result<(), CaseError> {
    let table = format!("fluid.boundary[{index}]");
    let key = |name: &str| format!("{table}.{name}");
    let kind = boundary.kind;
    let (used, word): (&[&str], _) = match kind {
        BoundaryKind::NoSlip => (&[], "no-slip"),
        BoundaryKind::Slip => (&[], "slip"),
        BoundaryKind::WallFunction => (&[], "wall-function"),
        BoundaryKind::Inlet => (&["velocity", "speed", "profile"], "inlet"),
        BoundaryKind::Outlet => (&["pressure"], "outlet"),
        BoundaryKind::MovingWall => (&["velocity"], "moving-wall"),
        BoundaryKind::FreeSurface => (&[], "free-surface"),
    };
    let moves = fluid.backend == Backend::Pfem;
    if moves && kind == BoundaryKind::MovingWall {
        let found = format!("backend \"pfem\" has no kind \"{word}\"");
        let advice = "state a wall that moves as [[wall]] with motion";
        return rules.refuse(
            &key("kind"),
            found,
            "no-slip, slip, wall-function, inlet, outlet, free-surface",
            advice,
        );
    }
    let only_moving = match kind {
        BoundaryKind::FreeSurface => Some("stays where it is and has no free surface"),
        BoundaryKind::WallFunction => Some("has no law of the wall"),
        _ => None,
    };
    if let Some(lacks) = only_moving.filter(|_| !moves) {
        let found = format!("the mesh of backend \"eulerian\" {lacks}");
        let allowed = "no-slip, slip, inlet, outlet, moving-wall";
        return rules.refuse(&key("kind"), found, allowed, "set backend = \"pfem\"");
    }
    if kind == BoundaryKind::WallFunction && fluid.rheology.is_some() {
        let found = "the law of the wall is that of a Newtonian fluid";
        return rules.refuse(&key("kind"), found, "no-slip, slip beside [fluid.rheology]", "");
    }
    for name in ["velocity", "speed", "profile", "pressure"] {
        if !used.contains(&name) {
            rules.no_effect(&key(name), format_args!("with kind = \"{word}\""))?;
        }
    }
    if kind == BoundaryKind::Inlet {
        rules.exactly_one(&table, &["velocity", "speed"])?;
        if boundary.speed.is_none() {
            rules.no_effect(&key("profile"), "without speed")?;
        }
    }
    if moves {
        gate::boundary(boundary, &table, rules)?;
    }
    if kind == BoundaryKind::MovingWall {
        rules.required(&key("velocity"), "a moving wall needs it")?;
    }
    velocity(&key("velocity"), boundary.velocity.as_ref(), rules)
}

/// A velocity has as many components as the case has dimensions.
pub(super) fn velocity(key: &str, stated: Option<&BoundaryVelocity>, rules: &Rules) -> Result<(), CaseError> {
    match stated {
        Some(BoundaryVelocity::Constant(vector)) => rules.vector(key, vector),
        Some(BoundaryVelocity::Expression(expressions)) => {
            rules.components(&format!("{key}.expression"), expressions.len())
        }
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CARRIED, CHANNEL, SETTLING, assert_refusals, document};

    #[test]
    fn a_fluid_is_physical_and_has_what_its_backend_needs() {
        assert_refusals(
            CHANNEL,
            &[
                (
                    "\"1 g/cm^3\"",
                    "\"0 g/cm^3\"",
                    "case.toml:9: fluid.density: found 0 kg/m^3; allowed: more than 0 kg/m^3",
                ),
                (
                    "\"1 mPa*s\"",
                    "\"1e-6 m^2/s\"",
                    "case.toml:10: fluid.viscosity: \"1e-6 m^2/s\" is in m^2 s^-1, not a dynamic viscosity; write for example \"2.5 mPa s\" (a dynamic viscosity)",
                ),
                (
                    "\"1 mPa*s\"",
                    "\"-1 mPa*s\"",
                    "case.toml:10: fluid.viscosity: found -0.001 Pa s; allowed: more than 0 Pa s",
                ),
                (
                    "\"1 mPa*s\"",
                    "\"1 mPa*s\"\nfield = { velocity = [\"0\", \"0\"], pressure = \"0\" }",
                    "case.toml:11: fluid.field: has no effect with backend = \"eulerian\"; delete it",
                ),
                (
                    "\"1 mPa*s\"",
                    "\"1 mPa*s\"\nvelocity = [\"0 m/s\"]",
                    "case.toml:11: fluid.velocity: found 1 components; allowed: 2; case.dimension is 2",
                ),
                (
                    "\"1 mPa*s\"",
                    "\"1 mPa*s\"\nbody-force = [\"0 N\", \"0 N\"]",
                    "case.toml:11: fluid.body-force[0]: \"0 N\" is a force (m kg s^-2), not an acceleration; write for example \"2.5 m/s^2\" (an acceleration)",
                ),
                (
                    "\"1 mPa*s\"",
                    "\"1 mPa*s\"\nsolve = { tolerance = 1 }",
                    "case.toml:11: fluid.solve.tolerance: found 1; allowed: more than 0, less than 1",
                ),
                (
                    "eulerian",
                    "eulerain",
                    "case.toml:8: fluid.backend: unknown backend \"eulerain\"; allowed: imposed, eulerian, pfem; did you mean \"eulerian\"?",
                ),
            ],
        );
        let mesh = CHANNEL.split("[fluid.mesh]").nth(1).unwrap();
        assert_refusals(
            CHANNEL,
            &[(
                &format!("[fluid.mesh]{mesh}"),
                "",
                "case.toml:7: fluid.mesh: missing; backend \"eulerian\" needs it: add [fluid.mesh] with box, pipe or gmsh",
            )],
        );
        assert_refusals(
            CARRIED,
            &[
                (
                    "field = {",
                    "solve = { tolerance = 1e-9 }\nfield = {",
                    "case.toml:21: fluid.solve: has no effect with backend = \"imposed\"; delete it",
                ),
                (
                    "\"0.1*sin(t)\", ",
                    "",
                    "case.toml:21: fluid.field.velocity: found 2 components; allowed: 3; case.dimension is 3",
                ),
                (
                    "sin(t)",
                    "sin(q)",
                    "case.toml:21: fluid.field.velocity[0]: expression \"0.1*sin(q)\", column 9: unknown name \"q\"; allowed: x, y, z, t, pi, sin, cos, tan, tanh, exp, log, sqrt, abs, step, min, max, pow, if",
                ),
                (
                    "field = {",
                    "#",
                    "case.toml:17: fluid.field: missing; an imposed flow is stated there: field = { velocity = […], pressure = \"…\" }",
                ),
            ],
        );
    }

    #[test]
    fn every_boundary_has_one_condition() {
        assert_refusals(
            CHANNEL,
            &[
                (
                    "[\"x-max\"]",
                    "[\"x-max\", \"x-min\"]",
                    "case.toml:22: fluid.boundary[2].on[1]: boundary \"x-min\" is named twice; delete one",
                ),
                (
                    "[\"x-max\"]",
                    "[\"x-mx\"]",
                    "case.toml:22: fluid.boundary[2].on[0]: there is no boundary \"x-mx\"; allowed: x-min, x-max, y-min, y-max; did you mean \"x-max\"?",
                ),
                (
                    "[\"x-max\"]",
                    "[]",
                    "case.toml:22: fluid.boundary[2].on: there is no name in it; name boundaries of the mesh",
                ),
                (
                    "\"y-min\", ",
                    "",
                    "case.toml:13: fluid.boundary: no condition is stated on y-min; add a [[fluid.boundary]] with on = […] and kind",
                ),
                (
                    "size",
                    "periodic = [\"x\"], size",
                    "case.toml:17: fluid.boundary[1].on[0]: there is no boundary \"x-min\"; allowed: y-min, y-max; did you mean \"y-min\"?",
                ),
            ],
        );
    }

    #[test]
    fn a_condition_states_what_its_kind_uses() {
        assert_refusals(
            CHANNEL,
            &[
                (
                    "\"no-slip\"",
                    "\"no-slip\"\nspeed = \"1 m/s\"",
                    "case.toml:16: fluid.boundary[0].speed: has no effect with kind = \"no-slip\"; delete it",
                ),
                (
                    "\"no-slip\"",
                    "\"wall-function\"",
                    "case.toml:15: fluid.boundary[0].kind: the mesh of backend \"eulerian\" has no law of the wall; allowed: no-slip, slip, inlet, outlet, moving-wall; set backend = \"pfem\"",
                ),
                (
                    "\"no-slip\"",
                    "\"moving-wall\"",
                    "case.toml:13: fluid.boundary[0].velocity: missing; a moving wall needs it",
                ),
                (
                    "\"outlet\"",
                    "\"outlet\"\npressure = \"1 m\"",
                    "case.toml:24: fluid.boundary[2].pressure: \"1 m\" is a length (m), not a pressure; write for example \"2.5 Pa\" (a pressure)",
                ),
                (
                    "speed = \"0.2 m/s\"\nprofile = \"parabolic\"",
                    "",
                    "case.toml:16: fluid.boundary[1]: none of these keys is given; allowed: exactly one of velocity, speed",
                ),
                (
                    "speed = \"0.2 m/s\"",
                    "velocity = [\"1 m/s\", \"0 m/s\"]",
                    "case.toml:20: fluid.boundary[1].profile: has no effect without speed; delete it",
                ),
                (
                    "speed = \"0.2 m/s\"\nprofile = \"parabolic\"",
                    "velocity = [\"1 m/s\"]",
                    "case.toml:19: fluid.boundary[1].velocity: found 1 components; allowed: 2; case.dimension is 2",
                ),
                (
                    "speed = \"0.2 m/s\"\nprofile = \"parabolic\"",
                    "velocity = { expression = [\"y\"] }",
                    "case.toml:19: fluid.boundary[1].velocity.expression: found 1 components; allowed: 2; case.dimension is 2",
                ),
                (
                    "speed = \"0.2 m/s\"\nprofile = \"parabolic\"",
                    "velocity = { expresion = [\"y\", \"0\"] }",
                    "case.toml:19: fluid.boundary[1].velocity.expresion: unknown key; allowed: expression; did you mean \"expression\"?",
                ),
                (
                    "speed = \"0.2 m/s\"\nprofile = \"parabolic\"",
                    "velocity = \"1 m/s\"",
                    "case.toml:19: fluid.boundary[1].velocity: found the string \"1 m/s\"; allowed: a vector such as [\"1 m/s\", \"0 m/s\"] or { expression = [\"1-y^2\", \"0\"] }",
                ),
            ],
        );
        document(&CHANNEL.replace(
            "speed = \"0.2 m/s\"\nprofile = \"parabolic\"",
            "velocity = { expression = [\"1-y^2\", \"0\"] }",
        ));
        document(&SETTLING.replace("kind = \"outlet\"", "kind = \"outlet\"\npressure = \"1 bar\""));
    }
}
