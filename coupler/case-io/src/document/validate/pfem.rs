//! `[fluid.pfem]`, `[[fluid.body]]`, and what of `[fluid.mesh]` a fluid of moving nodes does not have.

use super::fluid::velocity;
use super::rules::Rules;
use crate::document::quantity::Length;
use crate::document::vector::extent;
use crate::document::{Body, Document, FlowScheme, Fluid, MeshSource, Region};
use crate::error::CaseError;

pub(super) fn check(document: &Document, fluid: &Fluid, rules: &Rules) -> Result<(), CaseError> {
    if fluid.pfem.as_ref().is_some_and(|pfem| pfem.scheme != FlowScheme::Monolithic) {
        let beside = match (&document.grains, &fluid.rheology) {
            (Some(_), _) => Some("[grains]"),
            (None, Some(_)) => Some("[fluid.rheology]"),
            (None, None) => None,
        };
        if let Some(table) = beside {
            let found = format_args!("only \"monolithic\" computes with {table}");
            return rules.refuse("fluid.pfem.scheme", found, "", "delete it");
        }
    }
    let source = fluid.mesh.as_ref().and_then(|mesh| mesh.source());
    if let Some(MeshSource::Box(mesh)) = source {
        if !mesh.periodic.is_empty() {
            let found = "the nodes of backend \"pfem\" move, and no axis wraps";
            return rules.refuse("fluid.mesh.box.periodic", found, "", "delete it");
        }
        shortest(fluid, &extent(&mesh.lower, &mesh.upper), "fluid.mesh.box", rules)?;
    }
    let size = fluid.pfem.as_ref().and_then(|pfem| pfem.size);
    rules.optional_positive("fluid.pfem.size", size)?;
    rules.optional_positive(
        "fluid.pfem.bulk-modulus",
        fluid.pfem.as_ref().and_then(|pfem| pfem.bulk_modulus),
    )?;
    if source.is_none() {
        rules
            .required("fluid.pfem.size", "without [fluid.mesh] nothing else says how fine the bodies are")?;
    }
    if document.grains.is_none() {
        rules.no_effect("fluid.pfem.grains", "without [grains]")?;
    }
    if let Some(pfem) = &fluid.pfem {
        super::refinement::check(pfem, rules)?;
    }
    fluid.body.iter().enumerate().try_for_each(|(k, stated)| body(fluid, stated, k, rules))
}

fn body(fluid: &Fluid, body: &Body, index: usize, rules: &Rules) -> Result<(), CaseError> {
    let table = format!("fluid.body[{index}]");
    rules.exactly_one(&table, &["box", "sphere"])?;
    match body.region() {
        Some(Region::Box(lower, upper)) => {
            let key = format!("{table}.box");
            rules.corners(&key, lower, upper)?;
            shortest(fluid, &extent(lower, upper), &key, rules)?;
        }
        Some(Region::Sphere(centre, radius)) => {
            rules.vector(&format!("{table}.sphere.centre"), centre)?;
            rules.positive(&format!("{table}.sphere.radius"), radius)?;
            shortest(fluid, &[2.0 * radius.si(); 3], &format!("{table}.sphere"), rules)?;
        }
        _ => {}
    }
    velocity(&format!("{table}.velocity"), body.velocity.as_ref(), rules)
}

/// The size of the cells is at most the shortest edge of a body of this extent (m).
fn shortest(fluid: &Fluid, extent: &[f64; 3], table: &str, rules: &Rules) -> Result<(), CaseError> {
    let Some(size) = fluid.pfem.as_ref().and_then(|pfem| pfem.size) else { return Ok(()) };
    let shortest = extent[..rules.dimension.count()].iter().copied().fold(f64::INFINITY, f64::min);
    if size.si() <= shortest {
        return Ok(());
    }
    let allowed = format!("at most the shortest edge of {table}, {}", Length::from_si(shortest));
    rules.refuse("fluid.pfem.size", format_args!("found {size}"), allowed, "")
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{TANK, assert_refusals, document};

    #[test]
    fn a_tank_of_moving_nodes_is_walls_and_a_free_surface() {
        document(TANK);
        assert_refusals(
            TANK,
            &[
                (
                    "kind = \"free-surface\"",
                    "kind = \"moving-wall\"",
                    "case.toml:19: fluid.boundary[1].kind: backend \"pfem\" has no kind \"moving-wall\"; allowed: no-slip, slip, wall-function, inlet, outlet, free-surface; state a wall that moves as [[wall]] with motion",
                ),
                (
                    "backend = \"pfem\"",
                    "backend = \"eulerian\"",
                    "case.toml:23: wall: has no effect without [grains]; delete it",
                ),
                (
                    "size = \"0.1 m\" }",
                    "size = \"0.1 m\", periodic = [\"x\"] }",
                    "case.toml:13: fluid.mesh.box.periodic: the nodes of backend \"pfem\" move, and no axis wraps; delete it",
                ),
                (
                    "[fluid.mesh]",
                    "pfem = { size = \"2 m\" }\n[fluid.mesh]",
                    "case.toml:12: fluid.pfem.size: found 2 m; allowed: at most the shortest edge of fluid.mesh.box, 1 m",
                ),
                (
                    "[fluid.mesh]",
                    "pfem = { scheme = \"segregated\" }\nrheology = { law = \"bingham\", yield-stress = \"1 Pa\" }\n[fluid.mesh]",
                    "case.toml:12: fluid.pfem.scheme: only \"monolithic\" computes with [fluid.rheology]; delete it",
                ),
                (
                    "[fluid.mesh]\nbox = { lower = [\"0 m\", \"0 m\"], upper = [\"2 m\", \"1 m\"], size = \"0.1 m\" }\n[[fluid.boundary]]\non = [\"x-min\", \"y-min\"]\nkind = \"slip\"",
                    "rheology = { law = \"bingham\", yield-stress = \"1 Pa\" }\n[fluid.mesh]\nbox = { lower = [\"0 m\", \"0 m\"], upper = [\"2 m\", \"1 m\"], size = \"0.1 m\" }\n[[fluid.boundary]]\non = [\"x-min\", \"y-min\"]\nkind = \"wall-function\"",
                    "case.toml:17: fluid.boundary[0].kind: the law of the wall is that of a Newtonian fluid; allowed: no-slip, slip beside [fluid.rheology]",
                ),
                (
                    "[fluid.mesh]",
                    "pfem = { scheme = \"fractional\" }\n[fluid.mesh]",
                    "case.toml:12: fluid.pfem.scheme: unknown scheme \"fractional\"; allowed: monolithic, segregated, fractional-step; did you mean \"fractional-step\"?",
                ),
                (
                    "[fluid.mesh]",
                    "pfem = { grains = \"nodal\" }\n[fluid.mesh]",
                    "case.toml:12: fluid.pfem.grains: has no effect without [grains]; delete it",
                ),
                (
                    "[fluid.mesh]",
                    "pfem = { grains = \"node\" }\n[fluid.mesh]",
                    "case.toml:12: fluid.pfem.grains: unknown nodes \"node\"; allowed: kernel, nodal; did you mean \"nodal\"?",
                ),
                (
                    "[fluid.mesh]",
                    "pfem = { bulk-modulus = \"0 GPa\" }\n[fluid.mesh]",
                    "case.toml:12: fluid.pfem.bulk-modulus: found 0 Pa; allowed: more than 0 Pa",
                ),
                (
                    "\"y-max\"",
                    "\"weir\"",
                    "case.toml:21: fluid.boundary[2].on[0]: boundary \"weir\" is named twice; delete one",
                ),
                (
                    "[[fluid.boundary]]\non = [\"weir\"]\nkind = \"slip\"\n",
                    "",
                    "case.toml:20: wall[0]: \"weir\" holds neither grains nor the fluid; name it in a [[fluid.boundary]], or delete it",
                ),
                (
                    "name = \"weir\"",
                    "name = \"weir\"\nmaterial = \"steel\"",
                    "case.toml:25: wall[0].material: has no effect without [grains]; delete it",
                ),
                (
                    "[\"3 m\", \"1 m\"]",
                    "[\"3 m\", \"0 m\"]",
                    "case.toml:25: wall[0].polyline.points: the points 1 and 2 are the same; delete one; closed = true needs no repetition of the first",
                ),
            ],
        );
    }

    #[test]
    fn a_body_has_one_shape_and_a_size() {
        let with = |body: &str| format!("[[fluid.body]]\n{body}\n[fluid.mesh]");
        let rows = [
            (
                with("velocity = [\"1 m/s\", \"0 m/s\"]"),
                "case.toml:12: fluid.body[0]: none of these keys is given; allowed: exactly one of box, sphere",
            ),
            (
                with("sphere = { centre = [\"1 m\", \"2 m\"], radius = \"0 m\" }"),
                "case.toml:13: fluid.body[0].sphere.radius: found 0 m; allowed: more than 0 m",
            ),
        ];
        for (to, message) in &rows {
            assert_refusals(TANK, &[("[fluid.mesh]", to, message)]);
        }
        document(
            &TANK.replace(
                "[fluid.mesh]",
                &with("sphere = { centre = [\"1 m\", \"2 m\"], radius = \"0.2 m\" }"),
            ),
        );
    }
}
