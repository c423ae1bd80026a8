//! `[[wall]]`

use super::mesh::boundary_names;
use super::rules::Rules;
use crate::document::{Dimension, Document, Motion, Wall, WallShape};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    if document.grains.is_none() {
        return rules.no_effect("wall", "without [grains]");
    }
    rules.names("wall", document.wall.iter().map(|wall| wall.name.as_str()))?;
    let materials: Vec<&str> = document.materials.keys().map(String::as_str).collect();
    for (index, wall) in document.wall.iter().enumerate() {
        let table = format!("wall[{index}]");
        rules.known(&format!("{table}.material"), "material", &wall.material, &materials)?;
        rules.exactly_one(&table, &["plane", "stl", "mesh"])?;
        match wall.shape() {
            Some(WallShape::Plane(plane)) => {
                rules.vector(&format!("{table}.plane.point"), &plane.point)?;
                let allowed = "any direction, towards the grains";
                direction(rules, &format!("{table}.plane.normal"), &plane.normal, allowed)?;
            }
            Some(WallShape::Stl(stl)) => {
                if rules.dimension == Dimension::Two {
                    let advice = "use plane or mesh";
                    return rules.refuse(&format!("{table}.stl"), "triangles are no walls in 2D", "", advice);
                }
                rules.number(&format!("{table}.stl.scale"), stl.scale, stl.scale > 0.0, "more than 0")?;
            }
            Some(WallShape::Mesh(mesh)) => {
                let key = format!("{table}.mesh.boundary");
                let Some(fluid_mesh) = document.fluid.as_ref().and_then(|fluid| fluid.mesh.as_ref()) else {
                    return rules.refuse(
                        &format!("{table}.mesh"),
                        "there is no [fluid.mesh]",
                        "",
                        "use plane or stl",
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
            motion(document, rules, &table, wall, stated)?;
        }
    }
    Ok(())
}

fn direction(rules: &Rules, key: &str, found: &[f64], allowed: &str) -> Result<(), CaseError> {
    rules.components(key, found.len())?;
    if found.iter().all(|&component| component == 0.0) {
        return rules.refuse(key, "all components are 0", allowed, "");
    }
    Ok(())
}

fn motion(
    document: &Document,
    rules: &Rules,
    table: &str,
    wall: &Wall,
    motion: &Motion,
) -> Result<(), CaseError> {
    let key = |key: &str| format!("{table}.motion{key}");
    if wall.mesh.is_some() {
        let found = "this wall is the boundary of the fluid's mesh, which stays where it is";
        return rules.refuse(&key(""), found, "motion of a plane or stl wall", "delete it");
    }
    let Motion { translation, rotation, oscillation } = motion;
    if translation.is_none() && rotation.is_none() && oscillation.is_none() {
        let allowed = "one or more of translation, rotation, oscillation";
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
    // Around a wall that moves, the box of its facets at the start says nothing.
    if wall.stl.is_some() && document.grains.as_ref().is_some_and(|grains| grains.domain.is_none()) {
        return rules.required(
            "grains.domain",
            format_args!("the wall \"{}\" moves: state where grains may be", wall.name),
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CHANNEL, DRY, SETTLING, assert_refusals};

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
                    "case.toml:22: wall[0]: none of these keys is given; allowed: exactly one of plane, stl, mesh",
                ),
                (
                    "normal = [0, 0, 1]",
                    "normal = [0, 0, 0.0]",
                    "case.toml:25: wall[0].plane.normal: all components are 0; allowed: any direction, towards the grains",
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
                    "case.toml:35: wall[0].stl: triangles are no walls in 2D; use plane or mesh",
                ),
                (
                    plane,
                    "mesh = { boundary = [\"wall\"] }",
                    "case.toml:35: wall[0].mesh: there is no [fluid.mesh]; use plane or stl",
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
    fn a_motion_is_stated_whole_and_only_of_walls_that_can_move() {
        let moving = |motion: &str| format!("{PLANE}\nmotion = {motion}");
        let cases: Vec<(String, &str)> = [
            (
                "mesh = { boundary = [\"z-min\"] }\nmotion = { translation = [\"0 m/s\", \"0 m/s\", \"1 m/s\"] }".to_string(),
                "case.toml:26: wall[0].motion: this wall is the boundary of the fluid's mesh, which stays where it is; allowed: motion of a plane or stl wall; delete it",
            ),
            (
                moving("{}"),
                "case.toml:26: wall[0].motion: none of these keys is given; allowed: one or more of translation, rotation, oscillation",
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
