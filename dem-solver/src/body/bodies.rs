//! The clumps among the grains.

use std::sync::Arc;

use super::{Body, Clump};

/// A kind of clump that a scene knows.
#[derive(Clone, Debug, PartialEq)]
pub struct ClumpKind {
    /// Its shape, shared by all clumps of the kind.
    pub shape: Arc<Clump>,
    /// Index of the material of its members.
    pub material: u32,
    /// Volume of the union of its members \[m³\].
    pub volume: f64,
}

/// A clump whose members are grains.
#[derive(Clone, Debug, PartialEq)]
pub struct Rigid {
    /// Identity of its first member, and of the clump; the others follow.
    pub first: u64,
    /// Which of the scene's kinds it is.
    pub kind: u32,
    /// Its shape.
    pub shape: Arc<Clump>,
    /// Where it is and how it moves.
    pub body: Body,
}

/// All clumps, in order of birth.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bodies(Vec<Rigid>);

impl Rigid {
    /// Number of its members.
    pub fn count(&self) -> usize {
        self.shape.members().len()
    }

    /// Kinetic energy of translation, M V²/2, and of rotation, ω·L/2 \[J\].
    pub fn kinetic_energies(&self) -> [f64; 2] {
        let translation = 0.5 * self.shape.mass() * self.body.velocity.norm_squared();
        [translation, self.body.kinetic_energy(&self.shape) - translation]
    }
}

impl Bodies {
    /// These clumps, if each has grains of its own and they are in order of birth.
    pub fn new(clumps: Vec<Rigid>) -> Option<Self> {
        let apart = clumps.windows(2).all(|pair| pair[0].first + pair[0].count() as u64 <= pair[1].first);
        apart.then_some(Self(clumps))
    }

    /// Adds the youngest.
    pub fn push(&mut self, clump: Rigid) {
        self.0.push(clump);
    }

    /// All of them.
    pub fn as_slice(&self) -> &[Rigid] {
        &self.0
    }

    /// All of them.
    pub fn as_mut_slice(&mut self) -> &mut [Rigid] {
        &mut self.0
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Keeps those of which `stays` is true.
    pub fn retain(&mut self, stays: impl FnMut(&Rigid) -> bool) {
        self.0.retain(stays);
    }

    /// Index of the clump that this grain is a member of, and which of its members it is.
    pub fn of(&self, grain: u64) -> Option<(usize, usize)> {
        let index = self.0.partition_point(|clump| clump.first <= grain).checked_sub(1)?;
        let member = (grain - self.0[index].first) as usize;
        (member < self.0[index].count()).then_some((index, member))
    }

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        self.0.clone_from(&other.0);
    }
}
