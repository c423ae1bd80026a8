//! The clumps of a case.

use std::sync::Arc;

use case_io::document::{self, Case, Insertion, unit_vector};
use case_io::error::CaseError;
use nalgebra::UnitQuaternion;

use super::surroundings::material_index;
use crate::body::{BodyError, Clump, ClumpKind, MassProperties, Member};
use crate::insertion::{ClumpStart, Orientation};
use crate::scene::Scene;
use crate::vector::{Spin, Vector};

/// The kinds of clumps of a case: one for each insertion of clumps, in their order.
///
/// # Errors
/// A clump that no matter can be.
pub fn kinds<const D: usize>(case: &Case) -> Result<Vec<ClumpKind>, CaseError> {
    let insertions = case.document.insertion.iter().enumerate();
    let stated =
        insertions.filter_map(|(index, insertion)| Some((index, insertion, clump(case, insertion)?)));
    stated.map(|(index, insertion, (k, clump))| kind::<D>(case, (index, insertion), (k, clump))).collect()
}

/// The clump that an insertion names, with its index.
fn clump<'a>(case: &'a Case, insertion: &Insertion) -> Option<(usize, &'a document::Clump)> {
    let name = insertion.clump.as_ref()?;
    case.document.clump.iter().enumerate().find(|(_, clump)| clump.name == *name)
}

fn kind<const D: usize>(
    case: &Case,
    (index, insertion): (usize, &Insertion),
    (k, stated): (usize, &document::Clump),
) -> Result<ClumpKind, CaseError> {
    let material = material_index(case, &insertion.material, &format!("insertion[{index}].material"))?;
    let depth = case.document.case.depth();
    let members: Vec<Member> = stated
        .spheres
        .iter()
        .map(|sphere| Member { offset: Vector::from(sphere.centre.to_array()), radius: sphere.radius.si() })
        .collect();
    // Of density 1 its mass is its volume.
    let union = if D == 2 {
        MassProperties::of_discs(&members, 1.0, depth)
    } else {
        MassProperties::of_spheres(&members, 1.0)
    };
    let volume = union.mass;
    let of_material = case.document.materials[&insertion.material].density.si();
    let density = stated.mass.map_or(of_material, |mass| mass.si() / volume);
    let shape = if D == 2 {
        Clump::of_discs(&members, density, depth)
    } else {
        let properties = MassProperties { mass: density * volume, inertia: union.inertia * density, ..union };
        Clump::with_mass(&members, &properties)
    };
    let refused = |error: BodyError| case.error(&format!("clump[{k}]"), error, "", "");
    Ok(ClumpKind { shape: Arc::new(shape.map_err(refused)?), material, volume })
}

/// No clump reaches itself across a periodic side.
pub fn check_periods<const D: usize>(case: &Case, scene: &Scene<D>) -> Result<(), CaseError> {
    let longest = scene.clumps.iter().map(|kind| 2.0 * kind.shape.bounding_radius()).fold(0.0, f64::max);
    let short = (0..D).find(|&axis| scene.domain.periodic[axis] && scene.domain.period(axis) <= longest);
    short.map_or(Ok(()), |axis| {
        let found =
            format!("the domain is {} m long in {}", scene.domain.period(axis), ["x", "y", "z"][axis]);
        let allowed = format!("more than {longest} m, the sphere around the largest clump");
        Err(case.error("grains.periodic", found, allowed, "lengthen the domain or use smaller clumps"))
    })
}

/// How the clumps of an insertion begin; nothing if it inserts grains.
pub fn start(case: &Case, index: usize) -> Option<ClumpStart> {
    let insertion = &case.document.insertion[index];
    insertion.clump.as_ref()?;
    let earlier = case.document.insertion[..index].iter().filter(|insertion| insertion.clump.is_some());
    let turn =
        insertion.orientation.as_ref().map_or(Spin::zeros(), |turn| about(&turn.axis, turn.angle.si()));
    let given = Orientation::Given(UnitQuaternion::from_scaled_axis(turn));
    Some(ClumpStart {
        kind: earlier.count() as u32,
        orientation: if insertion.random_orientation { Orientation::Random } else { given },
        angular_velocity: insertion
            .spin
            .as_ref()
            .map_or(Spin::zeros(), |spin| about(&spin.axis, spin.rate.si())),
    })
}

/// A vector of this size along an axis, which is z in 2D.
fn about(axis: &Option<Vec<f64>>, size: f64) -> Spin {
    let axis = axis.as_ref().map_or(Spin::z(), |axis| Spin::from(unit_vector::<3>(axis)));
    axis * size
}
