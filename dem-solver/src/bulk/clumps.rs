//! Contacts of clumps.

use super::contacts::Contact;
use crate::body::Rigid;
use crate::clumped::Members;
use crate::vector::Spin;
use crate::world::World;

/// The contacts as bodies have them: a contact of a member is one of its clump, known by the row of its first member, and
/// its branch begins, and ends, at the centre of mass.
pub fn contacts_of_bodies<const D: usize>(world: &World<D>, mut contacts: Vec<Contact>) -> Vec<Contact> {
    let mut first: Vec<usize> = (0..world.grains.len()).collect();
    let mut arm = vec![Spin::zeros(); world.grains.len()];
    let members = Members::tie(&world.bodies, &world.grains);
    for (Rigid { shape, body, .. }, rows) in members.of_each(&world.bodies) {
        for (&row, member) in rows.iter().zip(shape.members()) {
            first[row as usize] = rows[0] as usize;
            arm[row as usize] = body.orientation * member.offset;
        }
    }
    for contact in &mut contacts {
        let Contact { grain, other, branch, .. } = contact;
        *branch += arm[*grain] - other.map_or(Spin::zeros(), |other| arm[other]);
        *grain = first[*grain];
        *other = other.map(|other| first[other]);
    }
    contacts
}
