//! `[[wall]]`

use super::mesh::boundary_names;
use super::rules::Rules;
use crate::document::{Dimension, Document, WallShape};
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
                let key = format!("{table}.plane.normal");
                rules.components(&key, plane.normal.len())?;
                if plane.normal.iter().all(|&component| component == 0.0) {
                    return rules.refuse(
                        &key,
                        "all components are 0",
                        "any direction, towards the grains",
                        "",
                    );
                }
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
}
