//! `[[wall]]`

use super::mesh::boundary_names;
use super::motion_table;
use super::rules::Rules;
use crate::document::{
    Backend, Cylinder, Dimension, Document, Fluid, Motion, Polyline, Servo, SurfaceFile, Wall, WallShape,
};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let held = document.fluid.as_ref().filter(|fluid| fluid.backend == Backend::Pfem);
    if document.grains.is_none() && held.is_none() {
        return rules.no_effect("wall", "without [grains]");
    }
    rules.names("wall", document.wall.iter().map(|wall| wall.name.as_str()))?;
    let materials: Vec<&str> = document.materials.keys().map(String::as_str).collect();
    for (index, wall) in document.wall.iter().enumerate() {
        let table = format!("wall[{index}]");
        let material = format!("{table}.material");
        match &wall.material {
            _ if document.grains.is_none() => rules.no_effect(&material, "without [grains]")?,
            Some(name) => rules.known(&material, "material", name, &materials)?,
            None => rules.required(&material, "grains touch the wall: name one of [materials.*]")?,
        }
        rules.exactly_one(&table, &["plane", "cylinder", "sphere", "polyline", "stl", "obj", "mesh"])?;
        if let Some(fluid) = held {
            holds_fluid(document, fluid, rules, &table, wall)?;
        }
        match wall.shape() {
            Some(WallShape::Plane(plane)) => {
                rules.vector(&format!("{table}.plane.point"), &plane.point)?;
                let allowed = "any direction, towards grains and fluid";
                direction(rules, &format!("{table}.plane.normal"), &plane.normal, allowed)?;
            }
            Some(WallShape::Cylinder(stated)) => cylinder(rules, &format!("{table}.cylinder"), stated)?,
            Some(WallShape::Sphere(sphere)) => {
                rules.vector(&format!("{table}.sphere.centre"), &sphere.centre)?;
                rules.positive(&format!("{table}.sphere.radius"), sphere.radius)?;
            }
            Some(WallShape::Polyline(line)) => polyline(rules, &format!("{table}.polyline"), line)?,
            Some(WallShape::Stl(file)) => triangles(rules, &format!("{table}.stl"), file)?,
            Some(WallShape::Obj(file)) => triangles(rules, &format!("{table}.obj"), file)?,
            Some(WallShape::Mesh(mesh)) => {
                let key = format!("{table}.mesh.boundary");
                let Some(fluid_mesh) = document.fluid.as_ref().and_then(|fluid| fluid.mesh.as_ref()) else {
                    return rules.refuse(
                        &format!("{table}.mesh"),
                        "there is no [fluid.mesh]",
                        "",
                        "use another shape",
                    );
                };
                if mesh.boundary.is_empty() {
                    return rules.refuse(
                        &key,
                        "there is no name in it",
                        "",
                        "name boundaries of the fluid mesh",
                    );
                }
                if let Some(known) = boundary_names(fluid_mesh, rules.dimension) {
                    for (k, boundary) in mesh.boundary.iter().enumerate() {
                        rules.known(&format!("{key}[{k}]"), "boundary", boundary, &known)?;
                    }
                }
            }
            None => {}
        }
        rules.optional_vector(&format!("{table}.torque-about"), wall.torque_about.as_ref())?;
        if let Some(stated) = &wall.motion {
            motion(rules, &format!("{table}.motion"), stated)?;
        }
        if let Some(stated) = &wall.servo {
            servo(rules, &format!("{table}.servo"), stated)?;
        }
        moves(document, rules, &table, wall)?;
    }
    Ok(())
}

fn cylinder(rules: &Rules, table: &str, cylinder: &Cylinder) -> Result<(), CaseError> {
    let key = |key: &str| format!("{table}.{key}");
    if rules.dimension == Dimension::Two {
        return rules.refuse(table, "a cylinder is no wall in 2D", "", "use sphere: in 2D it is a circle");
    }
    rules.vector(&key("point"), &cylinder.point)?;
    direction(rules, &key("axis"), &cylinder.axis, "any direction")?;
    rules.positive(&key("radius"), cylinder.radius)?;
    if cylinder.length.is_some() {
        rules.no_effect(&key("grains"), "with length: the shell is felt from both sides")?;
    } else {
        rules.required(&key("grains"), "state \"inside\" or \"outside\", or the length of a shell")?;
        rules.no_effect(&key("closed"), "without length: there are no ends")?;
    }
    rules.optional_positive(&key("length"), cylinder.length)
}

/// What a fluid asks of a wall that is to hold it.
fn holds_fluid(
    document: &Document,
    fluid: &Fluid,
    rules: &Rules,
    table: &str,
    wall: &Wall,
) -> Result<(), CaseError> {
    if !fluid.boundary.iter().any(|boundary| boundary.on.contains(&wall.name)) {
        if document.grains.is_some() {
            return Ok(());
        }
        let found = format!("\"{}\" holds neither grains nor the fluid", wall.name);
        return rules.refuse(table, found, "", "name it in a [[fluid.boundary]], or delete it");
    }
    let refuse = |key: &str, found: &str, allowed: &str| {
        rules.refuse(&format!("{table}.{key}"), format_args!("{found} cannot hold the fluid"), allowed, "")
    };
    if wall.cylinder.as_ref().is_some_and(|cylinder| cylinder.length.is_some()) {
        return refuse(
            "cylinder.length",
            "a shell, which has two sides,",
            "a cylinder without length, stl, obj",
        );
    }
    if wall.mesh.is_some() {
        return refuse("mesh", "a boundary of its own mesh", "the boundary itself in [[fluid.boundary]]");
    }
    if wall.servo.is_some() {
        return refuse("servo", "a wall that gives way", "motion");
    }
    Ok(())
}

fn polyline(rules: &Rules, table: &str, line: &Polyline) -> Result<(), CaseError> {
    if rules.dimension == Dimension::Three {
        return rules.refuse(table, "a line is no wall in 3D", "", "use plane, stl or obj");
    }
    let key = format!("{table}.points");
    if line.points.len() < 2 {
        return rules.refuse(&key, format_args!("found {} points", line.points.len()), "2 or more", "");
    }
    for (k, point) in line.points.iter().enumerate() {
        rules.vector(&format!("{key}[{k}]"), point)?;
    }
    let count = line.points.len();
    match line.segments().iter().position(|[from, to]| from == to) {
        Some(k) => {
            let found = format!("the points {} and {} are the same", k + 1, (k + 1) % count + 1);
            rules.refuse(&key, found, "", "delete one; closed = true needs no repetition of the first")
        }
        None => Ok(()),
    }
}

fn triangles(rules: &Rules, table: &str, file: &SurfaceFile) -> Result<(), CaseError> {
    if rules.dimension == Dimension::Two {
        return rules.refuse(
            table,
            "triangles are no walls in 2D",
            "",
            "use plane, sphere, polyline or mesh",
        );
    }
    rules.number(&format!("{table}.scale"), file.scale, file.scale > 0.0, "more than 0")
}

pub(super) fn direction(rules: &Rules, key: &str, found: &[f64], allowed: &str) -> Result<(), CaseError> {
    rules.components(key, found.len())?;
    if found.iter().all(|&component| component == 0.0) {
        return rules.refuse(key, "all components are 0", allowed, "");
    }
    Ok(())
}

/// Which walls may move, and what must then be stated.
fn moves(document: &Document, rules: &Rules, table: &str, wall: &Wall) -> Result<(), CaseError> {
    let given = [("motion", wall.motion.is_some()), ("servo", wall.servo.is_some())];
    let Some((key, _)) = given.iter().find(|(_, given)| *given) else { return Ok(()) };
    if wall.mesh.is_some() {
        let found = "this wall is the boundary of the fluid's mesh, which stays where it is";
        return rules.refuse(&format!("{table}.{key}"), found, "motion of any other wall", "delete it");
    }
    // Around a wall that moves, its box at the start says nothing.
    let has_ends = wall.plane.is_none() && wall.cylinder.as_ref().is_none_or(|c| c.length.is_some());
    if has_ends && document.grains.as_ref().is_some_and(|grains| grains.domain.is_none()) {
        return rules.required(
            "grains.domain",
            format_args!("the wall \"{}\" moves: state where grains may be", wall.name),
        );
    }
    Ok(())
}

fn servo(rules: &Rules, table: &str, servo: &Servo) -> Result<(), CaseError> {
    direction(rules, &format!("{table}.direction"), &servo.direction, "any direction")?;
    rules.positive(&format!("{table}.force"), servo.force)?;
    rules.positive(&format!("{table}.mass"), servo.mass)?;
    rules.positive(&format!("{table}.largest-speed"), servo.largest_speed)
}

fn motion(rules: &Rules, table: &str, motion: &Motion) -> Result<(), CaseError> {
    let key = |key: &str| format!("{table}{key}");
    let Motion { translation, rotation, oscillation, table: over_time } = motion;
    if translation.is_none() && rotation.is_none() && oscillation.is_none() && over_time.is_none() {
        let allowed = "one or more of translation, rotation, oscillation, table";
        return rules.refuse(&key(""), "none of these keys is given", allowed, "");
    }
    rules.optional_vector(&key(".translation"), translation.as_ref())?;
    if let Some(rotation) = rotation {
        rules.vector(&key(".rotation.point"), &rotation.point)?;
        match (&rotation.axis, rules.dimension) {
            (None, Dimension::Three) => rules.required(&key(".rotation.axis"), "state its direction")?,
            (Some(axis), Dimension::Three) => {
                direction(rules, &key(".rotation.axis"), axis, "any direction")?;
            }
            (_, Dimension::Two) => rules.no_effect(&key(".rotation.axis"), "in 2D, where the axis is z")?,
        }
    }
    if let Some(oscillation) = oscillation {
        direction(rules, &key(".oscillation.direction"), &oscillation.direction, "any direction")?;
        rules.positive(&key(".oscillation.amplitude"), oscillation.amplitude)?;
        rules.positive(&key(".oscillation.frequency"), oscillation.frequency)?;
    }
    if let Some(over_time) = over_time {
        motion_table::check(rules, &key(".table"), over_time, rotation.is_some())?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CHANNEL, DRY, SETTLING, assert_refusals, document};

    const PLANE: &str = r#"plane = { point = ["0 m", "0 m", "0 m"], normal = [0, 0, 1] }"#;

    #[test]
    fn a_wall_has_one_shape_and_a_known_material() {
        assert_refusals(
            SETTLING,
            &[
                (
                    "name = \"floor\"\nmaterial = \"glass\"",
                    "name = \"floor\"\nmaterial = \"wood\"",
                    "case.toml:24: wall[0].material: there is no material \"wood\"; allowed: glass",
                ),
                (
                    PLANE,
                    "",
                    "case.toml:22: wall[0]: none of these keys is given; allowed: exactly one of plane, cylinder, sphere, polyline, stl, obj, mesh",
                ),
                (
                    "normal = [0, 0, 1]",
                    "normal = [0, 0, 0.0]",
                    "case.toml:25: wall[0].plane.normal: all components are 0; allowed: any direction, towards grains and fluid",
                ),
                (
                    "normal = [0, 0, 1]",
                    "normal = [0, 1]",
                    "case.toml:25: wall[0].plane.normal: found 2 components; allowed: 3; case.dimension is 3",
                ),
                (
                    "normal = [0, 0, 1]",
                    "normal = [0, 0, nan]",
                    "case.toml:25: wall[0].plane.normal[2]: found NaN; allowed: finite numbers",
                ),
                (
                    PLANE,
                    "stl = { path = \"x.stl\", scale = 0 }",
                    "case.toml:25: wall[0].stl.scale: found 0; allowed: more than 0",
                ),
                (
                    PLANE,
                    "mesh = { boundary = [] }",
                    "case.toml:25: wall[0].mesh.boundary: there is no name in it; name boundaries of the fluid mesh",
                ),
                (
                    PLANE,
                    "mesh = { boundary = [\"z-mn\"] }",
                    "case.toml:25: wall[0].mesh.boundary[0]: there is no boundary \"z-mn\"; allowed: x-min, x-max, y-min, y-max, z-min, z-max; did you mean \"z-min\"?",
                ),
            ],
        );
        let plane = r#"plane = { point = ["0 m", "0 m"], normal = [0, 2.0] }"#;
        assert_refusals(
            DRY,
            &[
                (
                    plane,
                    "stl = { path = \"x.stl\" }",
                    "case.toml:35: wall[0].stl: triangles are no walls in 2D; use plane, sphere, polyline or mesh",
                ),
                (
                    plane,
                    "mesh = { boundary = [\"wall\"] }",
                    "case.toml:35: wall[0].mesh: there is no [fluid.mesh]; use another shape",
                ),
            ],
        );
        assert_refusals(
            CHANNEL,
            &[(
                "[fluid]",
                "[[wall]]\nname = \"a\"\nmaterial = \"b\"\n[fluid]",
                "case.toml:7: wall: has no effect without [grains]; delete it",
            )],
        );
    }

    #[test]
    fn a_servo_pushes_something_of_mass() {
        let pushed = |force: &str, mass: &str, direction: &str| {
            format!(
                "{PLANE}\nservo = {{ direction = {direction}, force = \"{force}\", mass = \"{mass}\", largest-speed = \"1 m/s\" }}"
            )
        };
        let rows = [
            (
                pushed("0 N", "1 kg", "[0, 0, 1]"),
                "case.toml:26: wall[0].servo.force: found 0 N; allowed: more than 0 N",
            ),
            (
                pushed("1 N", "0 g", "[0, 0, 1]"),
                "case.toml:26: wall[0].servo.mass: found 0 kg; allowed: more than 0 kg",
            ),
            (
                pushed("1 N", "1 g", "[0, 0, 0]"),
                "case.toml:26: wall[0].servo.direction: all components are 0; allowed: any direction",
            ),
            (
                pushed("1 N", "1 g", "[0, 0, 1]").replace(PLANE, "mesh = { boundary = [\"z-min\"] }"),
                "case.toml:26: wall[0].servo: this wall is the boundary of the fluid's mesh, which stays where it is; allowed: motion of any other wall; delete it",
            ),
        ];
        for (to, message) in &rows {
            assert_refusals(SETTLING, &[(PLANE, to, message)]);
        }
        document(&SETTLING.replace(PLANE, &pushed("1 N", "1 g", "[0, 0, -1]")));
    }

    #[test]
    fn a_round_wall_has_a_side_or_ends() {
        let round = r#"point = ["0 m", "0 m", "0 m"], axis = [0, 0, 1], radius = "1 m""#;
        let cylinder = |rest: &str| format!("cylinder = {{ {round}{rest} }}");
        let sphere = |radius: &str, side: &str| {
            format!(
                r#"sphere = {{ centre = ["0 m", "0 m", "0 m"], radius = "{radius}", grains = "{side}" }}"#
            )
        };
        let rows = [
            (
                cylinder(""),
                "case.toml:25: wall[0].cylinder.grains: missing; state \"inside\" or \"outside\", or the length of a shell",
            ),
            (
                cylinder(", grains = \"inside\", length = \"1 m\""),
                "case.toml:25: wall[0].cylinder.grains: has no effect with length: the shell is felt from both sides; delete it",
            ),
            (
                cylinder(", grains = \"inside\", closed = true"),
                "case.toml:25: wall[0].cylinder.closed: has no effect without length: there are no ends; delete it",
            ),
            (
                cylinder(", length = \"0 m\""),
                "case.toml:25: wall[0].cylinder.length: found 0 m; allowed: more than 0 m",
            ),
            (
                cylinder(", length = \"1 m\"").replace("[0, 0, 1]", "[0, 0, 0]"),
                "case.toml:25: wall[0].cylinder.axis: all components are 0; allowed: any direction",
            ),
            (
                sphere("1 m", "within"),
                "case.toml:25: wall[0].sphere.grains: unknown side \"within\"; allowed: inside, outside",
            ),
            (
                sphere("0 m", "inside"),
                "case.toml:25: wall[0].sphere.radius: found 0 m; allowed: more than 0 m",
            ),
        ];
        for (to, message) in &rows {
            assert_refusals(SETTLING, &[(PLANE, to, message)]);
        }
        for sound in [
            cylinder(", grains = \"outside\""),
            cylinder(", length = \"1 m\", closed = true"),
            sphere("1 m", "inside"),
        ] {
            document(&SETTLING.replace(PLANE, &sound));
        }
        assert_refusals(
            DRY,
            &[(
                r#"plane = { point = ["0 m", "0 m"], normal = [0, 2.0] }"#,
                &cylinder(", grains = \"inside\""),
                "case.toml:35: wall[0].cylinder: a cylinder is no wall in 2D; use sphere: in 2D it is a circle",
            )],
        );
    }

    #[test]
    fn a_motion_is_stated_whole_and_only_of_walls_that_can_move() {
        let moving = |motion: &str| format!("{PLANE}\nmotion = {motion}");
        let cases: Vec<(String, &str)> = [
            (
                "mesh = { boundary = [\"z-min\"] }\nmotion = { translation = [\"0 m/s\", \"0 m/s\", \"1 m/s\"] }".to_string(),
                "case.toml:26: wall[0].motion: this wall is the boundary of the fluid's mesh, which stays where it is; allowed: motion of any other wall; delete it",
            ),
            (
                moving("{}"),
                "case.toml:26: wall[0].motion: none of these keys is given; allowed: one or more of translation, rotation, oscillation, table",
            ),
            (
                moving("{ translation = [\"1 m/s\"] }"),
                "case.toml:26: wall[0].motion.translation: found 1 components; allowed: 3; case.dimension is 3",
            ),
            (
                moving("{ rotation = { point = [\"0 m\", \"0 m\", \"0 m\"], rate = \"1 rad/s\" } }"),
                "case.toml:26: wall[0].motion.rotation.axis: missing; state its direction",
            ),
            (
                moving("{ rotation = { axis = [0, 0, 0], point = [\"0 m\", \"0 m\", \"0 m\"], rate = \"1 rad/s\" } }"),
                "case.toml:26: wall[0].motion.rotation.axis: all components are 0; allowed: any direction",
            ),
            (
                moving("{ oscillation = { direction = [0, 0, 1], amplitude = \"0 mm\", frequency = \"1 Hz\" } }"),
                "case.toml:26: wall[0].motion.oscillation.amplitude: found 0 m; allowed: more than 0 m",
            ),
            (
                "stl = { path = \"x.stl\" }\nmotion = { translation = [\"0 m/s\", \"0 m/s\", \"1 m/s\"] }".to_string(),
                "case.toml:15: grains.domain: missing; the wall \"floor\" moves: state where grains may be",
            ),
        ]
        .into();
        for (to, message) in &cases {
            assert_refusals(SETTLING, &[(PLANE, to, message)]);
        }
        assert_refusals(
            DRY,
            &[(
                "normal = [0, 2.0] }",
                "normal = [0, 2.0] }\nmotion = { rotation = { axis = [0, 0, 1], point = [\"0 m\", \"0 m\"], rate = \"1 rad/s\" } }",
                "case.toml:36: wall[0].motion.rotation.axis: has no effect in 2D, where the axis is z; delete it",
            )],
        );
    }
}
