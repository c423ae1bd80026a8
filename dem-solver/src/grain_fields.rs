//! Fields of the grains in a frame.

use std::path::Path;

use case_io::document::GrainField;
use case_io::output::OutputError;
use case_io::output::vtk::{Field, Format, GrainPoints};

use crate::bulk::{Contact, contacts_at_rest};
use crate::scene::Scene;
use crate::vector::Spin;
use crate::world::World;

/// One value for each grain.
enum Values {
    Whole(Vec<u64>),
    Scalar(Vec<f64>),
    Vector(Vec<[f64; 3]>),
}

/// Writes the grains with these fields as a `.vtp` file.
///
/// # Errors
/// The disk's.
pub fn write_grains<const D: usize>(
    path: &Path,
    format: Format,
    fields: &[GrainField],
    scene: &Scene<D>,
    world: &World<D>,
) -> Result<(), OutputError> {
    let of_contacts = fields.iter().any(|field| field.is_of_contacts());
    let contacts = if of_contacts { contacts_at_rest(scene, world) } else { vec![] };
    let mut all: Vec<_> =
        fields.iter().map(|&field| (field.name(), values(field, world, &contacts))).collect();
    if !scene.clumps.is_empty() {
        all.push(("body", Values::Whole(body_of_each(world))));
    }
    let fields: Vec<_> = all
        .iter()
        .map(|(name, values)| match values {
            Values::Whole(values) => Field::whole(name, values),
            Values::Scalar(values) => Field::scalar(name, values),
            Values::Vector(values) => Field::vector(name, values),
        })
        .collect();
    let centres: Vec<[f64; D]> = world.grains.place.iter().map(|place| place.at::<D>().into()).collect();
    GrainPoints { centres: &centres, fields: &fields }.write(path, format)
}

fn values<const D: usize>(field: GrainField, world: &World<D>, contacts: &[Contact]) -> Values {
    let grains = &world.grains;
    let motions = grains.motion.iter();
    match field {
        GrainField::Id => Values::Whole(grains.id.clone()),
        GrainField::Radius => Values::Scalar(grains.place.iter().map(|place| place.radius).collect()),
        GrainField::Mass => Values::Scalar(grains.mass.clone()),
        GrainField::Velocity => Values::Vector(motions.map(|motion| motion.velocity.into()).collect()),
        GrainField::AngularVelocity => {
            Values::Vector(motions.map(|motion| motion.angular_velocity.into()).collect())
        }
        GrainField::Material => {
            Values::Whole(grains.material.iter().map(|&index| u64::from(index)).collect())
        }
        GrainField::ContactForce => sums(grains.len(), contacts, |contact| [contact.force, -contact.force]),
        GrainField::ContactTorque => sums(grains.len(), contacts, |contact| {
            // Opposite forces on opposite arms: both torques turn the same way.
            contact.arms.map(|arm| (contact.normal * arm).cross(&contact.force))
        }),
        GrainField::Coordination => {
            let mut counts = vec![0; grains.len()];
            for contact in contacts.iter().filter(|contact| contact.touches) {
                counts[contact.grain] += 1;
                contact.other.into_iter().for_each(|other| counts[other] += 1);
            }
            Values::Whole(counts)
        }
        GrainField::KineticEnergy => Values::Scalar(motions.map(|motion| motion.kinetic_energy()).collect()),
    }
}

/// Sums over the contacts of each grain of what they do to their first and to their second body.
fn sums(count: usize, contacts: &[Contact], of: impl Fn(&Contact) -> [Spin; 2]) -> Values {
    let mut sums = vec![Spin::zeros(); count];
    for contact in contacts {
        let [first, second] = of(contact);
        sums[contact.grain] += first;
        contact.other.into_iter().for_each(|other| sums[other] += second);
    }
    Values::Vector(sums.into_iter().map(Into::into).collect())
}

/// The body that each grain is of: the first member of its clump, or itself.
fn body_of_each<const D: usize>(world: &World<D>) -> Vec<u64> {
    let World { grains, bodies, .. } = world;
    let body = |&id: &u64| bodies.of(id).map_or(id, |(clump, _)| bodies.as_slice()[clump].first);
    grains.id.iter().map(body).collect()
}
