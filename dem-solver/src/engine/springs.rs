//! What the contacts of a list remember.

use super::block::{SpringBlock, TorqueBlock, WIDTH};
use crate::contact::Spring;
use crate::scene::Scene;

/// How much contacts remember.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Memory {
    /// Nothing: smooth grains.
    Nothing,
    /// Force and stiffness of the tangential spring.
    Force,
    /// These, and the torque of the spring against rolling.
    ForceAndTorque,
}

impl Memory {
    /// How much the contacts of a scene remember.
    pub fn of<const D: usize>(scene: &Scene<D>) -> Self {
        match scene.extras.rolling {
            _ if !scene.materials.rub() => Self::Nothing,
            Some(law) if law.remembers() => Self::ForceAndTorque,
            _ => Self::Force,
        }
    }
}

/// Springs of contacts, block by block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Springs {
    /// The tangential springs; empty without friction.
    pub forces: Vec<SpringBlock>,
    /// What the springs against rolling hold; empty without them.
    pub torques: Vec<TorqueBlock>,
}

impl Springs {
    /// Relaxed springs of so many blocks.
    pub fn relaxed(memory: Memory, blocks: usize) -> Self {
        let mut springs = Self::default();
        (0..blocks).for_each(|_| springs.push_block(memory));
        springs
    }

    /// Appends a block of relaxed springs.
    pub fn push_block(&mut self, memory: Memory) {
        if memory != Memory::Nothing {
            self.forces.push(SpringBlock::default());
        }
        if memory == Memory::ForceAndTorque {
            self.torques.push(TorqueBlock::default());
        }
    }

    /// Whether contacts remember nothing.
    pub fn is_empty(&self) -> bool {
        self.forces.is_empty()
    }

    /// The spring of a contact; relaxed if contacts remember nothing.
    pub fn get(&self, contact: usize) -> Spring {
        let (block, lane) = (contact / WIDTH, contact % WIDTH);
        let mut spring = self.forces.get(block).map_or(Spring::relaxed(), |forces| forces.load(lane));
        if let Some(torques) = self.torques.get(block) {
            spring.torque = torques.load(lane);
        }
        spring
    }

    /// Sets the spring of a contact, if contacts remember.
    pub fn set(&mut self, contact: usize, spring: &Spring) {
        let (block, lane) = (contact / WIDTH, contact % WIDTH);
        if let Some(forces) = self.forces.get_mut(block) {
            forces.store(lane, spring);
        }
        if let Some(torques) = self.torques.get_mut(block) {
            torques.store(lane, spring.torque);
        }
    }

    /// Energy of all tangential springs \[J\].
    pub fn energy(&self) -> f64 {
        self.forces.iter().map(SpringBlock::energy).sum()
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.forces.clear();
        self.torques.clear();
    }

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        self.forces.clone_from(&other.forces);
        self.torques.clone_from(&other.torques);
    }
}
