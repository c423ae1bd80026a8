//! `[case]`, `[time]` and `[output]`.

use super::rules::Rules;
use crate::document::quantity::Time;
use crate::document::{Dimension, Document, Interval, MeshSource, NormalLaw, Placement};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    case(document, rules)?;
    time(document, rules)?;
    output(document, rules)
}

fn case(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let case = &document.case;
    if document.grains.is_none() && document.fluid.is_none() {
        return rules.refuse(
            "case",
            "there is neither [grains] nor [fluid]",
            "",
            "add at least one of the two tables",
        );
    }
    rules.vector("case.gravity", &case.gravity)?;
    if case.dimension == Dimension::Three {
        rules.no_effect("case.depth", "in 3D")?;
    }
    rules.optional_positive("case.depth", case.depth)?;
    if !draws(document) {
        rules.no_effect("case.seed", "because nothing in this case is random")?;
    }
    Ok(())
}

/// Whether anything is drawn at random.
fn draws(document: &Document) -> bool {
    let drawn = document.insertion.iter().any(|insertion| {
        insertion.diameter_range.is_some()
            || insertion.diameter_distribution.is_some()
            || insertion.random_orientation
            || matches!(insertion.placement(), Some(Placement::Random(_) | Placement::Rate(_)))
    });
    let mesh = document.fluid.as_ref().and_then(|fluid| fluid.mesh.as_ref()).and_then(|mesh| mesh.source());
    drawn || matches!(mesh, Some(MeshSource::Box(mesh)) if mesh.jitter > 0.0)
}

fn time(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let time = &document.time;
    rules.positive("time.end", time.end)?;
    rules.optional_positive("time.window", time.window)?;
    rules.optional_positive("time.smallest-window", time.smallest_window)?;
    rules.optional_positive("time.substep", time.substep)?;
    if document.grains.is_some() && document.fluid.is_some() {
        rules.required(
            "time.window",
            "a case with grains and fluid needs it, for example window = \"1 ms\"",
        )?;
    }
    let window = Time::from_si(document.window());
    if let Some(smallest) = time.smallest_window.filter(|smallest| smallest.si() > window.si()) {
        let allowed = format!("at most the window, {window}");
        return rules.refuse("time.smallest-window", format_args!("found {smallest}"), allowed, "");
    }
    if document.grains.is_none() {
        rules.no_effect("time.substep", "without [grains]")?;
        rules.no_effect("time.substep-safety", "without [grains]")?;
    }
    if let Some(substep) = time.substep {
        rules.no_effect("time.substep-safety", "where time.substep is stated")?;
        if substep.si() > window.si() {
            let allowed = format!("at most the window, {window}");
            return rules.refuse("time.substep", format_args!("found {substep}"), allowed, "");
        }
    }
    let safety = time.substep_safety;
    rules.number("time.substep-safety", safety, safety > 0.0 && safety <= 1.0, "more than 0, at most 1")
}

fn output(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let output = &document.output;
    rules.optional_positive("output.series", output.series)?;
    for (key, interval) in [("output.frames", output.frames), ("output.restart", output.restart)] {
        if let Some(Interval::Every(time)) = interval {
            rules.positive(key, time)?;
        }
    }
    if output.frames == Some(Interval::None) {
        rules.no_effect("output.compress", "where output.frames = \"none\"")?;
    }
    fields(document, rules)
}

/// Those of the grains in frames, each once.
fn fields(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let Some(grains) = &document.grains else {
        return rules.no_effect("output.fields", "without [grains]");
    };
    let fields = document.output.fields();
    for (index, field) in fields.iter().enumerate() {
        let key = format!("output.fields[{index}]");
        if fields[..index].contains(field) {
            return rules.refuse(&key, "this field is named twice", "", "delete one");
        }
        if field.is_of_contacts() && grains.normal_law == NormalLaw::None {
            return rules.no_effect(&key, "where grains.normal-law = \"none\"");
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CARRIED, CHANNEL, DRY, SETTLING, assert_refusals, document};
    use crate::document::{BoundaryVelocity, GrainField};

    #[test]
    fn the_fixtures_are_sound() {
        for text in [SETTLING, DRY, CHANNEL, CARRIED] {
            document(text);
        }
    }

    #[test]
    fn every_optional_key_is_read() {
        let text = SETTLING
            .replace("dimension = 3", "dimension = 3\nseed = 7")
            .replace("window =", "smallest-window = \"1 us\"\nsubstep-safety = 0.2\nwindow =")
            .replace("[materials", "[output]\nseries = \"10 ms\"\nframes = \"100 ms\"\nrestart = \"none\"\ncompress = false\n[materials")
            .replace("[[insertion]]", "escape = \"remove\"\ndomain = { lower = [\"-1 m\", \"-1 m\", \"0 m\"], upper = [\"1 m\", \"1 m\", \"2 m\"] }\n[[insertion]]")
            .replace("diameter = \"2 mm\"", "diameter-range = [\"1 mm\", \"2 mm\"]\nvelocity = [\"0 m/s\", \"0 m/s\", \"-1 m/s\"]")
            .replace("[fluid.mesh]", "velocity = [\"1 cm/s\", \"0 m/s\", \"0 m/s\"]\nbody-force = [\"1 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\nsolve = { tolerance = 1e-9 }\n[fluid.mesh]")
            .replace("drag = ", "added-mass = 0.5\nself-disturbance = false\ntolerance = { velocity = 1e-4, pressure-floor = \"1 uPa\" }\nmax-iterations = 7\nacceleration = \"constant\"\nrelaxation = 0.4\nledger-tolerance = 1e-10\npeer-deadline = \"5 s\"\nanswer-deadline = \"2 min\"\ndrag = ");
        let read = document(&text);
        let (fluid, coupling) = (read.fluid.as_ref().unwrap(), read.coupling.as_ref().unwrap());
        assert_eq!((read.case.seed, read.time.substep_safety, read.smallest_window()), (7, 0.2, 1e-6));
        assert_eq!((read.output.series(read.time.end), read.output.compress), (0.01, false));
        assert_eq!(read.insertion[0].diameters(), Some([0.001, 0.002]));
        assert_eq!(read.insertion[0].velocity.as_ref().unwrap().to_array(), [0.0, 0.0, -1.0]);
        let Some(BoundaryVelocity::Constant(velocity)) = &fluid.velocity else {
            panic!("the initial velocity is stated as a vector")
        };
        assert_eq!(velocity.to_array(), [0.01, 0.0, 0.0]);
        assert_eq!(
            (fluid.body_force.as_ref().unwrap().to_array(), fluid.solve_tolerance()),
            ([1.0, 0.0], 1e-9)
        );
        assert_eq!((coupling.added_mass, coupling.max_iterations, coupling.relaxation), (0.5, 7, 0.4));
        assert_eq!(
            (
                coupling.tolerance.velocity,
                coupling.tolerance.pressure,
                coupling.tolerance.pressure_floor.si()
            ),
            (1e-4, 1e-3, 1e-6)
        );
        assert_eq!(
            (coupling.ledger_tolerance, coupling.peer_deadline.si(), coupling.answer_deadline.si()),
            (1e-10, 5.0, 120.0)
        );
    }

    #[test]
    fn fields_of_frames_are_known_ones_each_once() {
        let output = |fields: &str| format!("[output]\nfields = {fields}\n[materials.glass]");
        let of = |fields: &str| document(&SETTLING.replace("[materials.glass]", &output(fields))).output;
        let chosen = of(r#"["contact-force", "coordination"]"#);
        assert_eq!(chosen.fields(), [GrainField::ContactForce, GrainField::Coordination]);
        assert_eq!(document(SETTLING).output.fields(), GrainField::DEFAULT);
        for (sound, fields, message) in [
            (
                SETTLING,
                r#"["id", "pressure"]"#,
                "case.toml:9: output.fields[1]: unknown field \"pressure\"; allowed: id, radius, mass, velocity, angular-velocity, material, contact-force, contact-torque, coordination, kinetic-energy",
            ),
            (
                SETTLING,
                r#"["id", "id"]"#,
                "case.toml:9: output.fields[1]: this field is named twice; delete one",
            ),
            (
                CARRIED,
                r#"["coordination"]"#,
                "case.toml:9: output.fields[0]: has no effect where grains.normal-law = \"none\"; delete it",
            ),
        ] {
            assert_refusals(sound, &[("[materials.glass]", &output(fields), message)]);
        }
        assert_refusals(
            CHANNEL,
            &[(
                "[fluid]",
                "[output]\nfields = [\"id\"]\n[fluid]",
                "case.toml:8: output.fields: has no effect without [grains]; delete it",
            )],
        );
    }

    #[test]
    fn a_flat_case_has_no_third_component() {
        let read = document(DRY);
        assert_eq!(read.case.gravity.to_array::<2>(), [0.0, -9.81]);
        assert_eq!(read.case.gravity.to_array::<3>(), [0.0, -9.81, 0.0]);
        assert_eq!(read.case.depth(), 0.01);
        let Some(crate::document::WallShape::Plane(plane)) = read.wall[0].shape() else {
            panic!("the floor is a plane")
        };
        assert_eq!(crate::document::unit_vector::<3>(&plane.normal), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn space_and_time_are_checked() {
        assert_refusals(
            SETTLING,
            &[
                (
                    r#", "-9.81 m/s^2"]"#,
                    "]",
                    "case.toml:4: case.gravity: found 2 components; allowed: 3; case.dimension is 3",
                ),
                (
                    "dimension = 3",
                    "dimension = 3\ndepth = \"1 m\"",
                    "case.toml:4: case.depth: has no effect in 3D; delete it",
                ),
                (
                    "dimension = 3",
                    "dimension = 3\nseed = 7",
                    "case.toml:4: case.seed: has no effect because nothing in this case is random; delete it",
                ),
                (r#""2 s""#, r#""0 s""#, "case.toml:6: time.end: found 0 s; allowed: more than 0 s"),
                (
                    r#""1 ms""#,
                    r#""-1 ms""#,
                    "case.toml:7: time.window: found -0.001 s; allowed: more than 0 s",
                ),
                (
                    "window = \"1 ms\"",
                    "",
                    "case.toml:5: time.window: missing; a case with grains and fluid needs it, for example window = \"1 ms\"",
                ),
                (
                    "[materials.glass]",
                    "smallest-window = \"1 s\"\n[materials.glass]",
                    "case.toml:8: time.smallest-window: found 1 s; allowed: at most the window, 0.001 s",
                ),
                (
                    "[materials.glass]",
                    "substep = \"1 s\"\n[materials.glass]",
                    "case.toml:8: time.substep: found 1 s; allowed: at most the window, 0.001 s",
                ),
                (
                    "[materials.glass]",
                    "substep = \"1 us\"\nsubstep-safety = 0.1\n[materials.glass]",
                    "case.toml:9: time.substep-safety: has no effect where time.substep is stated; delete it",
                ),
                (
                    "[materials.glass]",
                    "substep-safety = 1.5\n[materials.glass]",
                    "case.toml:8: time.substep-safety: found 1.5; allowed: more than 0, at most 1",
                ),
            ],
        );
        assert_refusals(
            CHANNEL,
            &[
                (
                    "[fluid]",
                    "substep = \"1 us\"\n[fluid]",
                    "case.toml:7: time.substep: has no effect without [grains]; delete it",
                ),
                (
                    "[fluid]",
                    "substep-safety = 0.2\n[fluid]",
                    "case.toml:7: time.substep-safety: has no effect without [grains]; delete it",
                ),
            ],
        );
        assert_refusals(
            DRY,
            &[(r#""1 cm""#, r#""0 m""#, "case.toml:4: case.depth: found 0 m; allowed: more than 0 m")],
        );
    }

    #[test]
    fn a_case_of_nothing_is_refused() {
        let empty = "[case]\ntitle = \"\"\ndimension = 2\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n[time]\nend = \"1 s\"\n";
        assert_refusals(
            CHANNEL,
            &[
                (
                    CHANNEL,
                    empty,
                    "case.toml:1: case: there is neither [grains] nor [fluid]; add at least one of the two tables",
                ),
                (CHANNEL, "", "case.toml:1: case: missing; add the table [case]"),
            ],
        );
    }

    #[test]
    fn output_intervals_are_positive_or_none() {
        assert_refusals(
            SETTLING,
            &[
                (
                    "[materials.glass]",
                    "[output]\nseries = \"0 s\"\n[materials.glass]",
                    "case.toml:9: output.series: found 0 s; allowed: more than 0 s",
                ),
                (
                    "[materials.glass]",
                    "[output]\nframes = \"-1 s\"\n[materials.glass]",
                    "case.toml:9: output.frames: found -1 s; allowed: more than 0 s",
                ),
                (
                    "[materials.glass]",
                    "[output]\nrestart = \"never\"\n[materials.glass]",
                    "case.toml:9: output.restart: \"never\" does not start with a finite number; write a number and a unit, for example \"2.5 s\" (a time), or \"none\"",
                ),
                (
                    "[materials.glass]",
                    "[output]\nrestart = 3\n[materials.glass]",
                    "case.toml:9: output.restart: value 3 has no unit; write \"3 s\" (a time), or \"none\"",
                ),
                (
                    "[materials.glass]",
                    "[output]\nframes = \"none\"\ncompress = true\n[materials.glass]",
                    "case.toml:10: output.compress: has no effect where output.frames = \"none\"; delete it",
                ),
            ],
        );
        let sound = document(&SETTLING.replace(
            "[materials.glass]",
            "[output]\nframes = \"none\"\nrestart = \"0.5 s\"\n[materials.glass]",
        ));
        let end = sound.time.end;
        assert_eq!(
            (sound.output.series(end), sound.output.frames(end), sound.output.restart(end)),
            (0.01, None, Some(0.5))
        );
    }
}
