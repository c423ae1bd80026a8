//! `[coupling]`

use super::rules::Rules;
use crate::document::{Acceleration, Backend, Coupling, Dimension, Document, Drag, Scheme};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let (Some(_), Some(fluid)) = (&document.grains, &document.fluid) else {
        let absent = if document.grains.is_none() { "grains" } else { "fluid" };
        return rules.no_effect("coupling", format_args!("without [{absent}]"));
    };
    let Some(coupling) = &document.coupling else {
        return rules.required("coupling", "a case with grains and fluid needs it: add scheme and drag");
    };
    if fluid.backend == Backend::Imposed && coupling.scheme != Scheme::OneWay {
        return rules.refuse("coupling.scheme", "an imposed flow cannot be pushed", "one-way", "");
    }
    laws(coupling, rules)?;
    iterations(coupling, rules)?;
    let ledger = coupling.ledger_tolerance;
    rules.number("coupling.ledger-tolerance", ledger, ledger > 0.0, "more than 0")?;
    rules.positive("coupling.peer-deadline", coupling.peer_deadline)?;
    rules.positive("coupling.answer-deadline", coupling.answer_deadline)
}

/// What is allowed in 3D.
const SPHERE_LAWS: &str =
    "none, stokes, schiller-naumann, haider-levenspiel, wen-yu, ergun, gidaspow, di-felice";

fn laws(coupling: &Coupling, rules: &Rules) -> Result<(), CaseError> {
    let discs = rules.dimension == Dimension::Two;
    let for_discs = coupling.drag == Drag::DiFeliceCylinder;
    if coupling.drag != Drag::None && for_discs != discs {
        let (found, allowed) = if discs {
            ("this law was fitted to spheres, and grains in 2D are discs", "none, di-felice-cylinder")
        } else {
            ("this law was fitted to cylinders, and grains in 3D are spheres", SPHERE_LAWS)
        };
        return rules.refuse("coupling.drag", found, allowed, "");
    }
    let added = coupling.added_mass;
    rules.number("coupling.added-mass", added, added >= 0.0, "0 or more (a sphere has 0.5)")?;
    if coupling.drag == Drag::None {
        rules.no_effect("coupling.self-disturbance", "with drag = \"none\"")?;
    }
    if coupling.scheme == Scheme::OneWay {
        rules.no_effect(
            "coupling.self-disturbance",
            "with scheme = \"one-way\": the fluid is not disturbed",
        )?;
    }
    Ok(())
}

fn iterations(coupling: &Coupling, rules: &Rules) -> Result<(), CaseError> {
    let scheme = match coupling.scheme {
        Scheme::SerialExplicit => "serial-explicit",
        Scheme::OneWay => "one-way",
        Scheme::SerialImplicit => {
            if coupling.max_iterations == 0 {
                return rules.refuse("coupling.max-iterations", "found 0", "1 or more", "");
            }
            if coupling.acceleration == Acceleration::None {
                rules.no_effect("coupling.relaxation", "with acceleration = \"none\"")?;
            }
            let factor = coupling.relaxation;
            let holds = factor > 0.0 && factor <= 1.0;
            rules.number("coupling.relaxation", factor, holds, "more than 0, at most 1")?;
            return tolerance(coupling, rules);
        }
    };
    for key in ["tolerance", "max-iterations", "acceleration", "relaxation"] {
        rules.no_effect(
            &format!("coupling.{key}"),
            format_args!("with scheme = \"{scheme}\", which does not iterate"),
        )?;
    }
    Ok(())
}

fn tolerance(coupling: &Coupling, rules: &Rules) -> Result<(), CaseError> {
    let tolerance = &coupling.tolerance;
    for (name, value) in
        [("velocity", tolerance.velocity), ("pressure", tolerance.pressure), ("force", tolerance.force)]
    {
        let holds = value > 0.0 && value < 1.0;
        rules.number(&format!("coupling.tolerance.{name}"), value, holds, "more than 0, less than 1")?;
    }
    rules.positive("coupling.tolerance.velocity-floor", tolerance.velocity_floor)?;
    rules.positive("coupling.tolerance.pressure-floor", tolerance.pressure_floor)?;
    rules.positive("coupling.tolerance.force-floor", tolerance.force_floor)
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CARRIED, CHANNEL, DRY, SETTLING, assert_refusals, document};

    const TABLE: &str = "[coupling]\nscheme = \"serial-implicit\"\ndrag = \"di-felice\"\n";

    #[test]
    fn coupling_takes_two_sides() {
        assert_refusals(
            SETTLING,
            &[(
                TABLE,
                "",
                "case.toml:1: coupling: missing; a case with grains and fluid needs it: add scheme and drag",
            )],
        );
        assert_refusals(
            DRY,
            &[(
                "[grains]",
                "[coupling]\nscheme = \"one-way\"\ndrag = \"none\"\n[grains]",
                "case.toml:22: coupling: has no effect without [fluid]; delete it",
            )],
        );
        assert_refusals(
            CHANNEL,
            &[(
                "[fluid]",
                "[coupling]\nscheme = \"one-way\"\ndrag = \"none\"\n[fluid]",
                "case.toml:7: coupling: has no effect without [grains]; delete it",
            )],
        );
        assert_refusals(
            CARRIED,
            &[(
                "one-way",
                "serial-explicit",
                "case.toml:23: coupling.scheme: an imposed flow cannot be pushed; allowed: one-way",
            )],
        );
    }

    #[test]
    fn laws_of_spheres_are_refused_for_discs_and_the_other_way_round() {
        let both = DRY.replace("[grains]", "[coupling]\nscheme = \"one-way\"\ndrag = \"none\"\n[fluid]\nbackend = \"imposed\"\ndensity = \"1 kg/m^3\"\nviscosity = \"1 Pa s\"\nfield = { velocity = [\"0\", \"0\"], pressure = \"0\" }\n[grains]").replace("end = \"1 s\"", "end = \"1 s\"\nwindow = \"1 ms\"");
        assert_refusals(
            &both,
            &[(
                "drag = \"none\"",
                "drag = \"wen-yu\"",
                "case.toml:25: coupling.drag: this law was fitted to spheres, and grains in 2D are discs; allowed: none, di-felice-cylinder",
            )],
        );
        document(&both.replace("drag = \"none\"", "drag = \"di-felice-cylinder\""));
        assert_refusals(
            SETTLING,
            &[(
                "\"di-felice\"",
                "\"di-felice-cylinder\"",
                "case.toml:40: coupling.drag: this law was fitted to cylinders, and grains in 3D are spheres; allowed: none, stokes, schiller-naumann, haider-levenspiel, wen-yu, ergun, gidaspow, di-felice",
            )],
        );
        assert_refusals(
            SETTLING,
            &[(
                "\"di-felice\"",
                "\"difelice\"",
                "case.toml:40: coupling.drag: unknown drag \"difelice\"; allowed: none, stokes, schiller-naumann, haider-levenspiel, wen-yu, ergun, gidaspow, di-felice, di-felice-cylinder; did you mean \"di-felice\"?",
            )],
        );
    }

    #[test]
    fn options_without_effect_are_refused() {
        let with = |scheme: &str, line: &str| {
            format!("[coupling]\nscheme = \"{scheme}\"\ndrag = \"di-felice\"\n{line}\n")
        };
        assert_refusals(
            SETTLING,
            &[
                (
                    TABLE,
                    &with("serial-explicit", "max-iterations = 3"),
                    "case.toml:41: coupling.max-iterations: has no effect with scheme = \"serial-explicit\", which does not iterate; delete it",
                ),
                (
                    TABLE,
                    &with("serial-explicit", "acceleration = \"none\""),
                    "case.toml:41: coupling.acceleration: has no effect with scheme = \"serial-explicit\", which does not iterate; delete it",
                ),
                (
                    TABLE,
                    &with("one-way", "tolerance = {}"),
                    "case.toml:41: coupling.tolerance: has no effect with scheme = \"one-way\", which does not iterate; delete it",
                ),
                (
                    TABLE,
                    &with("one-way", "self-disturbance = true"),
                    "case.toml:41: coupling.self-disturbance: has no effect with scheme = \"one-way\": the fluid is not disturbed; delete it",
                ),
                (
                    TABLE,
                    &with("serial-implicit", "acceleration = \"none\"\nrelaxation = 0.5"),
                    "case.toml:42: coupling.relaxation: has no effect with acceleration = \"none\"; delete it",
                ),
                (
                    "drag = \"di-felice\"",
                    "drag = \"none\"\nself-disturbance = true",
                    "case.toml:41: coupling.self-disturbance: has no effect with drag = \"none\"; delete it",
                ),
            ],
        );
    }

    #[test]
    fn numbers_are_in_their_ranges() {
        let with = |line: &str| format!("{TABLE}{line}\n");
        assert_refusals(
            SETTLING,
            &[
                (
                    TABLE,
                    &with("added-mass = -0.5"),
                    "case.toml:41: coupling.added-mass: found -0.5; allowed: 0 or more (a sphere has 0.5)",
                ),
                (
                    TABLE,
                    &with("max-iterations = 0"),
                    "case.toml:41: coupling.max-iterations: found 0; allowed: 1 or more",
                ),
                (
                    TABLE,
                    &with("max-iterations = 99999999999999999999"),
                    "case.toml:41: coupling.max-iterations: found 1e20; allowed: a whole number from 0",
                ),
                (
                    TABLE,
                    &with("relaxation = 1.5"),
                    "case.toml:41: coupling.relaxation: found 1.5; allowed: more than 0, at most 1",
                ),
                (
                    TABLE,
                    &with("ledger-tolerance = 0.0"),
                    "case.toml:41: coupling.ledger-tolerance: found 0; allowed: more than 0",
                ),
                (
                    TABLE,
                    &with("peer-deadline = \"0 min\""),
                    "case.toml:41: coupling.peer-deadline: found 0 s; allowed: more than 0 s",
                ),
                (
                    TABLE,
                    &with("answer-deadline = 5"),
                    "case.toml:41: coupling.answer-deadline: value 5 has no unit; write \"5 s\" (a time)",
                ),
                (
                    TABLE,
                    &with("tolerance = { velocity = 0 }"),
                    "case.toml:41: coupling.tolerance.velocity: found 0; allowed: more than 0, less than 1",
                ),
                (
                    TABLE,
                    &with("tolerance = { force-floor = \"0 N\" }"),
                    "case.toml:41: coupling.tolerance.force-floor: found 0 N; allowed: more than 0 N",
                ),
            ],
        );
    }
}
