//! The state: all that a checkpoint holds, and all that a coupling iteration goes back to.

use crate::body::{Bodies, Body, ClumpKind, Rigid};
use crate::bond::Bonds;
use crate::deletion::Taken;
use crate::engine::ContactList;
use crate::grains::{Grain, Grains, volume};
use crate::insertion::Feed;
use crate::scene::Scene;
use crate::wall::{Poses, Received, Slide};

/// Grains with the memory of their contacts, at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct World<const D: usize> {
    /// Time t \[s\].
    pub time: f64,
    /// The grains.
    pub grains: Grains,
    /// The clumps that some of them are members of.
    pub bodies: Bodies,
    /// Who is near whom, and what contacts remember.
    pub contacts: ContactList,
    /// Who is bonded to whom.
    pub bonds: Bonds,
    /// How far walls have slid, by wall; nothing before the first window.
    pub slides: Vec<Slide>,
    /// What the walls received since the last row of the series.
    pub received: Received<D>,
    /// How many grains were ever born: the identity of the next.
    pub born: u64,
    /// How many were ever removed.
    pub removed: u64,
    /// What each deletion took, and last those that left the domain; nothing before the first grain goes.
    pub taken: Vec<Taken>,
    /// Insertions that go on over time.
    pub feeds: Vec<Feed<D>>,
}

/// A state put aside, in memory that is reused.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Saved<const D: usize>(World<D>);

impl<const D: usize> World<D> {
    /// No grain, at t = 0.
    pub fn new() -> Self {
        Self {
            time: 0.0,
            grains: Grains::new(),
            bodies: Bodies::default(),
            contacts: ContactList::new(),
            bonds: Bonds::default(),
            slides: vec![],
            received: Received::default(),
            born: 0,
            removed: 0,
            taken: vec![],
            feeds: vec![],
        }
    }

    /// Gives birth to a grain of the scene.
    pub fn add(&mut self, scene: &Scene<D>, grain: &Grain<D>) {
        let density = scene.materials.get(grain.material).density;
        let mass = density * volume::<D>(grain.radius, scene.depth);
        self.grains.push(self.born, grain, mass, scene.materials.is_micro(grain.material));
        self.born += 1;
        self.contacts.expire();
    }

    /// Gives birth to a clump of this kind of the scene, and to the grains that are its members.
    pub fn add_clump(&mut self, scene: &Scene<D>, kind: u32, body: Body) {
        let ClumpKind { shape, material, .. } = &scene.clumps[kind as usize];
        self.bodies.push(Rigid { first: self.born, kind, shape: shape.clone(), body });
        for (carried, member) in body.members(shape).zip(shape.members()) {
            self.grains.push_member(self.born, &carried, member.radius, shape.mass(), *material);
            self.born += 1;
        }
        self.contacts.expire();
    }

    /// Where the walls of the scene are.
    pub fn wall_poses(&self, scene: &Scene<D>) -> Poses<D> {
        scene.walls.poses(self.time, &self.slides)
    }

    /// Keeps the rows `order`, in that order; contacts keep their memory.
    pub fn reorder(&mut self, order: &[u32]) {
        let mut new_row = vec![None; self.grains.len()];
        for (row, &old) in order.iter().enumerate() {
            new_row[old as usize] = Some(row as u32);
        }
        self.grains.reorder(order);
        self.contacts.renumber(&new_row, order.len());
    }

    /// Puts the state aside, every bit of it.
    pub fn save(&self, saved: &mut Saved<D>) {
        saved.0.copy_from(self);
    }

    /// Goes back to the saved state.
    pub fn restore(&mut self, saved: &Saved<D>) {
        self.copy_from(&saved.0);
    }

    fn copy_from(&mut self, other: &Self) {
        let Self { time, grains, bodies, contacts, bonds, slides, received, born, removed, taken, feeds } =
            other;
        (self.time, self.born, self.removed) = (*time, *born, *removed);
        self.grains.copy_from(grains);
        self.bodies.copy_from(bodies);
        self.contacts.copy_from(contacts);
        self.bonds.copy_from(bonds);
        self.slides.clone_from(slides);
        self.received.copy_from(received);
        self.taken.clone_from(taken);
        self.feeds.clone_from(feeds);
    }
}

impl<const D: usize> Default for World<D> {
    fn default() -> Self {
        Self::new()
    }
}
