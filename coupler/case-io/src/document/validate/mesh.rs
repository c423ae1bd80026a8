//! `[fluid.mesh]`

use super::rules::Rules;
use crate::document::quantity::Length;
use crate::document::vector::extent;
use crate::document::{BoxMesh, Dimension, Mesh, MeshSource, PipeMesh};
use crate::error::CaseError;

const SIDES: [[&str; 2]; 3] = [["x-min", "x-max"], ["y-min", "y-max"], ["z-min", "z-max"]];

/// The names of the mesh's boundaries; nothing if only its file knows them.
pub(super) fn boundary_names(mesh: &Mesh, dimension: Dimension) -> Option<Vec<&'static str>> {
    match mesh.source()? {
        MeshSource::Box(mesh) => {
            let wraps = |axis: usize| mesh.periodic.iter().any(|periodic| periodic.index() == axis);
            Some((0..dimension.count()).filter(|&axis| !wraps(axis)).flat_map(|axis| SIDES[axis]).collect())
        }
        MeshSource::Pipe(_) => Some(vec!["inlet", "outlet", "wall"]),
        MeshSource::Gmsh(_) => None,
    }
}

pub(super) fn check(mesh: &Mesh, rules: &Rules) -> Result<(), CaseError> {
    rules.exactly_one("fluid.mesh", &["box", "pipe", "gmsh"])?;
    match mesh.source() {
        Some(MeshSource::Box(mesh)) => box_mesh(mesh, rules),
        Some(MeshSource::Pipe(mesh)) => pipe(mesh, rules),
        Some(MeshSource::Gmsh(file)) => {
            rules.number("fluid.mesh.gmsh.scale", file.scale, file.scale > 0.0, "more than 0")
        }
        None => Ok(()),
    }
}

fn box_mesh(mesh: &BoxMesh, rules: &Rules) -> Result<(), CaseError> {
    let table = "fluid.mesh.box";
    rules.corners(table, &mesh.lower, &mesh.upper)?;
    rules.exactly_one(table, &["cells", "size"])?;
    rules.axes("fluid.mesh.box.periodic", &mesh.periodic)?;
    if let Some(cells) = &mesh.cells {
        rules.components("fluid.mesh.box.cells", cells.len())?;
        if let Some(axis) = cells.iter().position(|&count| count == 0) {
            return rules.refuse(&format!("fluid.mesh.box.cells[{axis}]"), "found 0", "1 or more", "");
        }
    }
    if let Some(size) = mesh.size {
        rules.positive("fluid.mesh.box.size", size)?;
        let extent = extent(&mesh.lower, &mesh.upper);
        let shortest = extent[..rules.dimension.count()].iter().copied().fold(f64::INFINITY, f64::min);
        let shortest = Length::from_si(shortest);
        if size.si() > shortest.si() {
            let allowed = format!("at most the shortest edge, {shortest}");
            return rules.refuse("fluid.mesh.box.size", format_args!("found {size}"), allowed, "");
        }
    }
    let jitter = mesh.jitter;
    rules.number("fluid.mesh.box.jitter", jitter, (0.0..0.5).contains(&jitter), "from 0, less than 0.5")
}

fn pipe(mesh: &PipeMesh, rules: &Rules) -> Result<(), CaseError> {
    if rules.dimension == Dimension::Two {
        return rules.refuse(
            "fluid.mesh.pipe",
            "a pipe has no 2D form",
            "box, gmsh",
            "use a box for a channel",
        );
    }
    rules.positive("fluid.mesh.pipe.radius", mesh.radius)?;
    rules.positive("fluid.mesh.pipe.length", mesh.length)?;
    rules.positive("fluid.mesh.pipe.size", mesh.size)?;
    if mesh.size.si() > mesh.radius.si() {
        let allowed = format!("at most the radius, {}", mesh.radius);
        return rules.refuse("fluid.mesh.pipe.size", format_args!("found {}", mesh.size), allowed, "");
    }
    match (mesh.bend_radius, mesh.bend_angle) {
        (None, None) => {
            rules.no_effect("fluid.mesh.pipe.outlet-length", "without bend-radius and bend-angle")
        }
        (Some(_), None) => {
            rules.required("fluid.mesh.pipe.bend-angle", "a bend needs it, for example \"90 deg\"")
        }
        (None, Some(_)) => {
            rules.required("fluid.mesh.pipe.bend-radius", "a bend needs it, for example \"5 cm\"")
        }
        (Some(radius), Some(angle)) => {
            if radius.si() <= mesh.radius.si() {
                let allowed = format!("more than the pipe's radius, {}", mesh.radius);
                return rules.refuse(
                    "fluid.mesh.pipe.bend-radius",
                    format_args!("found {radius}"),
                    allowed,
                    "",
                );
            }
            if angle.si() <= 0.0 || angle.si() > std::f64::consts::PI {
                let found = format!("found {angle}");
                return rules.refuse("fluid.mesh.pipe.bend-angle", found, "more than 0, at most 180 deg", "");
            }
            rules.optional_positive("fluid.mesh.pipe.outlet-length", mesh.outlet_length)
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::document::MeshSource;
    use crate::document::fixture::{CHANNEL, SETTLING, assert_refusals, document};

    const BOX: &str =
        r#"box = { lower = ["-1 m", "-1 m", "0 m"], upper = ["1 m", "1 m", "2 m"], cells = [10, 10, 20] }"#;

    #[test]
    fn a_box_is_divided_in_one_way() {
        assert_refusals(
            SETTLING,
            &[
                (
                    BOX,
                    "",
                    "case.toml:30: fluid.mesh: none of these keys is given; allowed: exactly one of box, pipe, gmsh",
                ),
                (
                    ", cells = [10, 10, 20]",
                    "",
                    "case.toml:31: fluid.mesh.box: none of these keys is given; allowed: exactly one of cells, size",
                ),
                (
                    ", cells = [10, 10, 20]",
                    ", cells = [10, 10]",
                    "case.toml:31: fluid.mesh.box.cells: found 2 components; allowed: 3; case.dimension is 3",
                ),
                (
                    ", cells = [10, 10, 20]",
                    ", cells = [10, 0, 9]",
                    "case.toml:31: fluid.mesh.box.cells[1]: found 0; allowed: 1 or more",
                ),
                (
                    ", cells = [10, 10, 20]",
                    ", size = \"3 m\"",
                    "case.toml:31: fluid.mesh.box.size: found 3 m; allowed: at most the shortest edge, 2 m",
                ),
                (
                    ", cells = [10, 10, 20]",
                    ", size = \"1 m\", jitter = 0.5",
                    "case.toml:31: fluid.mesh.box.jitter: found 0.5; allowed: from 0, less than 0.5",
                ),
                (
                    ", cells = [10, 10, 20]",
                    ", size = \"1 m\", periodic = [\"w\"]",
                    "case.toml:31: fluid.mesh.box.periodic[0]: unknown axis \"w\"; allowed: x, y, z",
                ),
                (
                    ", cells = [10, 10, 20]",
                    ", size = \"1 m\", periodic = [\"x\", \"x\"]",
                    "case.toml:31: fluid.mesh.box.periodic[1]: this axis is named twice; delete one",
                ),
            ],
        );
        assert_refusals(
            CHANNEL,
            &[
                (
                    ", size",
                    ", periodic = [\"z\"], size",
                    "case.toml:12: fluid.mesh.box.periodic[0]: found z in 2D; allowed: x, y",
                ),
                (
                    "box = {",
                    "pipe = { radius = \"1 m\", length = \"1 m\", size = \"1 m\" }\ngmsh = {",
                    "case.toml:13: fluid.mesh.gmsh.lower: unknown key; allowed: path, scale",
                ),
            ],
        );
    }

    #[test]
    fn a_size_that_divides_the_box_takes_no_extra_cell() {
        let fluid = document(CHANNEL).fluid.unwrap();
        let mesh = fluid.mesh.unwrap();
        let Some(MeshSource::Box(mesh)) = mesh.source() else { panic!("the channel is a box") };
        assert_eq!(mesh.cells::<2>(), [40, 10]);
    }

    #[test]
    fn a_bend_is_whole() {
        let pipe =
            |rest: &str| format!("pipe = {{ radius = \"1 cm\", length = \"1 m\", size = \"2 mm\"{rest} }}");
        assert_refusals(
            SETTLING,
            &[
                (
                    BOX,
                    &pipe(", bend-radius = \"5 cm\""),
                    "case.toml:31: fluid.mesh.pipe.bend-angle: missing; a bend needs it, for example \"90 deg\"",
                ),
                (
                    BOX,
                    &pipe(", bend-angle = \"90 deg\""),
                    "case.toml:31: fluid.mesh.pipe.bend-radius: missing; a bend needs it, for example \"5 cm\"",
                ),
                (
                    BOX,
                    &pipe(", outlet-length = \"5 cm\""),
                    "case.toml:31: fluid.mesh.pipe.outlet-length: has no effect without bend-radius and bend-angle; delete it",
                ),
                (
                    BOX,
                    &pipe(", bend-angle = \"90 deg\", bend-radius = \"1 cm\""),
                    "case.toml:31: fluid.mesh.pipe.bend-radius: found 0.01 m; allowed: more than the pipe's radius, 0.01 m",
                ),
                (
                    BOX,
                    &pipe(", bend-angle = \"0 deg\", bend-radius = \"2 cm\""),
                    "case.toml:31: fluid.mesh.pipe.bend-angle: found 0 rad; allowed: more than 0, at most 180 deg",
                ),
                (
                    BOX,
                    &pipe(", bend-angle = \"90 mm\", bend-radius = \"2 cm\""),
                    "case.toml:31: fluid.mesh.pipe.bend-angle: \"90 mm\" is a length (m), not an angle; write for example \"2.5 deg\" (an angle)",
                ),
                (
                    BOX,
                    "gmsh = { path = \"pipe.msh\", scale = -1.0 }",
                    "case.toml:31: fluid.mesh.gmsh.scale: found -1; allowed: more than 0",
                ),
            ],
        );
    }
}
