//! `[grains]`

use super::rules::Rules;
use crate::document::quantity::Length;
use crate::document::{Backend, Document, Grains, MeshSource, NormalLaw, Point, TangentialLaw};
use crate::error::CaseError;

pub(super) fn check(document: &Document, rules: &Rules) -> Result<(), CaseError> {
    let Some(grains) = &document.grains else { return Ok(()) };
    let key = "grains.characteristic-velocity";
    match grains.normal_law {
        NormalLaw::Hooke => {
            rules.required(key, "the stiffness of \"hooke\" is found from it, for example \"1 m/s\"")?
        }
        NormalLaw::LiggghtsHooke => rules
            .required(key, "the stiffness of \"liggghts-hooke\" is found from it, for example \"1 m/s\"")?,
        NormalLaw::Hertz => rules.no_effect(key, "with normal-law = \"hertz\"")?,
        NormalLaw::Onate => rules.no_effect(key, "with normal-law = \"onate\"")?,
        NormalLaw::LiggghtsHertz => rules.no_effect(key, "with normal-law = \"liggghts-hertz\"")?,
        NormalLaw::None => rules.no_effect(key, "with normal-law = \"none\"")?,
    }
    rules.optional_positive(key, grains.characteristic_velocity)?;
    if document.case.dimension.count() == 2
        && matches!(grains.normal_law, NormalLaw::LiggghtsHooke | NormalLaw::LiggghtsHertz)
    {
        let allowed = "\"hooke\", \"hertz\", \"onate\", \"none\"";
        return rules.refuse("grains.normal-law", "the laws of LIGGGHTS are for spheres", allowed, "");
    }
    area_factor(grains, rules)?;
    tangential(document, grains, rules)?;
    if let Some(domain) = &grains.domain {
        rules.corners("grains.domain", &domain.lower, &domain.upper)?;
    }
    rules.axes("grains.periodic", &grains.periodic)?;
    let (key, overlap) = ("grains.start-overlap", grains.start_overlap);
    if grains.normal_law == NormalLaw::None {
        rules.no_effect(key, "with normal-law = \"none\"")?;
    }
    rules.number(key, overlap, (0.0..0.5).contains(&overlap), "from 0, less than 0.5")?;
    periodic(document, grains, rules)
}

fn area_factor(grains: &Grains, rules: &Rules) -> Result<(), CaseError> {
    let key = "grains.area-factor";
    if grains.normal_law != NormalLaw::Onate {
        rules.no_effect(key, "without normal-law = \"onate\"")?;
    }
    let factor = grains.area_factor.unwrap_or(1.0);
    rules.number(key, factor, factor > 0.0, "more than 0")
}

/// Laws that have their own tangential law name none, and partial slip is of spheres under Hertz's law.
fn tangential(document: &Document, grains: &Grains, rules: &Rules) -> Result<(), CaseError> {
    let key = "grains.tangential-law";
    match grains.normal_law {
        NormalLaw::None => rules.no_effect(key, "with normal-law = \"none\"")?,
        NormalLaw::LiggghtsHooke => rules.no_effect(key, "with normal-law = \"liggghts-hooke\"")?,
        NormalLaw::LiggghtsHertz => rules.no_effect(key, "with normal-law = \"liggghts-hertz\"")?,
        NormalLaw::Hooke | NormalLaw::Hertz | NormalLaw::Onate => {}
    }
    if document.pairs.values().all(|pair| pair.sliding_friction == 0.0) {
        rules.no_effect(key, "without sliding friction in any pair")?;
    }
    if grains.tangential_law != Some(TangentialLaw::PartialSlip) {
        return Ok(());
    }
    let advice = "take normal-law = \"hertz\"";
    match grains.normal_law {
        NormalLaw::Hertz if document.case.dimension.count() == 3 => Ok(()),
        NormalLaw::Hertz => rules.refuse(key, "\"partial-slip\" is for spheres", "\"coulomb\"", ""),
        _ => rules.refuse(key, "\"partial-slip\" slips by the pressure of \"hertz\"", "\"coulomb\"", advice),
    }
}

/// Grains wrap where the mesh wraps, at the same places.
fn periodic(document: &Document, grains: &Grains, rules: &Rules) -> Result<(), CaseError> {
    let key = "grains.periodic";
    if grains.periodic.len() == document.case.dimension.count() {
        rules.no_effect("grains.escape", "where all axes are periodic")?;
    }
    let fluid = document.fluid.as_ref().filter(|fluid| fluid.backend != Backend::Imposed);
    match fluid.and_then(|fluid| fluid.mesh.as_ref()).and_then(|mesh| mesh.source()) {
        Some(MeshSource::Box(mesh)) => {
            let (mut of_grains, mut of_mesh) = (grains.periodic.clone(), mesh.periodic.clone());
            of_grains.sort();
            of_mesh.sort();
            if of_grains != of_mesh {
                let found = format!("grains wrap in {of_grains:?}, the mesh in {of_mesh:?}").to_lowercase();
                return rules.refuse(
                    key,
                    found,
                    "the same axes in grains.periodic and fluid.mesh.box.periodic",
                    "",
                );
            }
            let Some(domain) = &grains.domain else { return Ok(()) };
            for axis in of_grains {
                let ends = |lower: &Point, upper: &Point| {
                    [lower, upper].map(|corner| Length::from_si(corner.to_array::<3>()[axis.index()]))
                };
                let [from, to] = ends(&domain.lower, &domain.upper);
                let [mesh_from, mesh_to] = ends(&mesh.lower, &mesh.upper);
                if [from, to] != [mesh_from, mesh_to] {
                    let found =
                        format!("goes from {from} to {to} on the periodic axis {axis:?}").to_lowercase();
                    let allowed = format!("{mesh_from} to {mesh_to}, as the mesh");
                    return rules.refuse("grains.domain", found, allowed, "");
                }
            }
            Ok(())
        }
        Some(_) if !grains.periodic.is_empty() => {
            rules.refuse(key, "only a box mesh can wrap", "[] or fluid.mesh.box", "delete it")
        }
        None if !grains.periodic.is_empty() => {
            rules.required("grains.domain", "grains.periodic needs it: it says where the axes wrap")
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use crate::document::fixture::{CARRIED, DRY, SETTLING, assert_refusals};

    #[test]
    fn the_stiffness_has_one_source() {
        assert_refusals(
            DRY,
            &[
                (
                    "\"hooke\"",
                    "\"hertz\"",
                    "case.toml:24: grains.characteristic-velocity: has no effect with normal-law = \"hertz\"; delete it",
                ),
                (
                    "\"hooke\"",
                    "\"herz\"",
                    "case.toml:23: grains.normal-law: unknown law \"herz\"; allowed: hooke, hertz, onate, liggghts-hooke, liggghts-hertz, none; did you mean \"hertz\"?",
                ),
                (
                    "characteristic-velocity = \"1 m/s\"",
                    "",
                    "case.toml:22: grains.characteristic-velocity: missing; the stiffness of \"hooke\" is found from it, for example \"1 m/s\"",
                ),
                (
                    "characteristic-velocity = \"1 m/s\"",
                    "characteristic-velocity = \"0 m/s\"",
                    "case.toml:24: grains.characteristic-velocity: found 0 m/s; allowed: more than 0 m/s",
                ),
            ],
        );
        assert_refusals(
            CARRIED,
            &[(
                "[[insertion]]",
                "characteristic-velocity = \"1 m/s\"\n[[insertion]]",
                "case.toml:12: grains.characteristic-velocity: has no effect with normal-law = \"none\"; delete it",
            )],
        );
    }

    #[test]
    fn the_laws_of_liggghts_are_for_spheres() {
        assert_refusals(
            DRY,
            &[(
                "\"hooke\"",
                "\"liggghts-hooke\"",
                "case.toml:23: grains.normal-law: the laws of LIGGGHTS are for spheres; allowed: \"hooke\", \"hertz\", \"onate\", \"none\"",
            )],
        );
    }

    #[test]
    fn partial_slip_is_of_spheres_under_hertzs_law() {
        let law = |normal: &str, tangential: &str| {
            format!(
                "normal-law = \"{normal}\"\ntangential-law = \"{tangential}\"\n[[insertion]]\nname = \"bed\""
            )
        };
        let settling = "normal-law = \"hertz\"\n[[insertion]]\nname = \"bed\"";
        assert_refusals(
            SETTLING,
            &[
                (
                    settling,
                    &law("onate", "partial-slip"),
                    "case.toml:17: grains.tangential-law: \"partial-slip\" slips by the pressure of \"hertz\"; allowed: \"coulomb\"; take normal-law = \"hertz\"",
                ),
                (
                    settling,
                    &law("liggghts-hertz", "coulomb"),
                    "case.toml:17: grains.tangential-law: has no effect with normal-law = \"liggghts-hertz\"; delete it",
                ),
                (
                    settling,
                    &law("hertz", "partial"),
                    "case.toml:17: grains.tangential-law: unknown law \"partial\"; allowed: coulomb, partial-slip; did you mean \"partial-slip\"?",
                ),
            ],
        );
        assert_refusals(
            DRY,
            &[(
                "normal-law = \"hooke\"\ncharacteristic-velocity = \"1 m/s\"",
                "normal-law = \"hertz\"\ntangential-law = \"partial-slip\"",
                "case.toml:24: grains.tangential-law: \"partial-slip\" is for spheres; allowed: \"coulomb\"",
            )],
        );
    }

    #[test]
    fn the_effective_area_is_of_the_law_that_has_one() {
        assert_refusals(
            SETTLING,
            &[
                (
                    "[[insertion]]",
                    "area-factor = 1\n[[insertion]]",
                    "case.toml:17: grains.area-factor: has no effect without normal-law = \"onate\"; delete it",
                ),
                (
                    "normal-law = \"hertz\"",
                    "normal-law = \"onate\"\narea-factor = 0",
                    "case.toml:17: grains.area-factor: found 0; allowed: more than 0",
                ),
            ],
        );
    }

    #[test]
    fn an_overlap_at_the_start_is_a_fraction_of_a_diameter() {
        assert_refusals(
            DRY,
            &[(
                "[[insertion]]",
                "start-overlap = 0.5\n[[insertion]]",
                "case.toml:27: grains.start-overlap: found 0.5; allowed: from 0, less than 0.5",
            )],
        );
        assert_refusals(
            CARRIED,
            &[(
                "[[insertion]]",
                "start-overlap = 0.02\n[[insertion]]",
                "case.toml:12: grains.start-overlap: has no effect with normal-law = \"none\"; delete it",
            )],
        );
    }

    #[test]
    fn grains_wrap_where_the_mesh_wraps() {
        assert_refusals(
            DRY,
            &[
                (
                    r#"upper = ["1 m", "1 m"] }"#,
                    r#"upper = ["1 m", "-1 m"] }"#,
                    "case.toml:25: grains.domain.upper[1]: found -1 m; allowed: more than lower, 0 m",
                ),
                (
                    "periodic = [\"x\"]",
                    "periodic = [\"z\"]",
                    "case.toml:26: grains.periodic[0]: found z in 2D; allowed: x, y",
                ),
                (
                    "periodic = [\"x\"]",
                    "periodic = [\"x\", \"y\"]\nescape = \"stop\"",
                    "case.toml:27: grains.escape: has no effect where all axes are periodic; delete it",
                ),
            ],
        );
        let domain = |upper: &str| {
            format!("domain = {{ lower = [\"-1 m\", \"-1 m\", \"0 m\"], upper = [{upper}] }}\n")
        };
        let periodic = "periodic = [\"x\"]\n[[insertion]]";
        assert_refusals(
            SETTLING,
            &[(
                "[[insertion]]",
                periodic,
                "case.toml:17: grains.periodic: grains wrap in [x], the mesh in []; allowed: the same axes in grains.periodic and fluid.mesh.box.periodic",
            )],
        );
        let wrapping = SETTLING
            .replace("[[insertion]]", &format!("{}{periodic}", domain("\"1 m\", \"1 m\", \"2 m\"")))
            .replace("cells =", "periodic = [\"x\"], cells =")
            .replace("\"x-min\", \"x-max\", ", "");
        assert_refusals(
            &wrapping,
            &[(
                &domain("\"1 m\", \"1 m\", \"2 m\""),
                &domain("\"2 m\", \"1 m\", \"2 m\""),
                "case.toml:17: grains.domain: goes from -1 m to 2 m on the periodic axis x; allowed: -1 m to 1 m, as the mesh",
            )],
        );
        assert_refusals(
            CARRIED,
            &[(
                "[[insertion]]",
                periodic,
                "case.toml:10: grains.domain: missing; grains.periodic needs it: it says where the axes wrap",
            )],
        );
    }
}
