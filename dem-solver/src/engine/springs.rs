//! What the contacts of a list remember.

use super::block::{AnnuliBlock, BridgeBlock, SpringBlock, TorqueBlock, TwistBlock, WIDTH};
use crate::contact::{History, NormalLaw, Spring};
use crate::scene::Scene;

/// What contacts remember.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Memory {
    /// Force and stiffness of the tangential spring.
    pub force: bool,
    /// The torque of the spring against rolling.
    pub torque: bool,
    /// Whether something holds the bodies together.
    pub bridge: bool,
    /// Torque and stiffness of the spring against twisting.
    pub twist: bool,
    /// Annuli that slip one by one.
    pub annuli: bool,
}

impl Memory {
    /// What the contacts of a scene remember.
    pub fn of<const D: usize>(scene: &Scene<D>) -> Self {
        let force = scene.materials.rub();
        Self {
            force,
            torque: force && scene.extras.rolling.is_some_and(|law| law.remembers()),
            bridge: scene.extras.cohesion.is_some_and(|law| law.remembers()),
            twist: force && scene.extras.twisting.is_some(),
            annuli: force && matches!(scene.normal_law, NormalLaw::HertzPartialSlip(_)),
        }
    }

    /// Whether they remember anything.
    pub fn any(self) -> bool {
        self != Self::default()
    }
}

/// Springs of contacts, block by block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Springs {
    /// The tangential springs; empty without friction.
    pub forces: Vec<SpringBlock>,
    /// What the springs against rolling hold; empty without them.
    pub torques: Vec<TorqueBlock>,
    /// Whether something holds the bodies together; empty where nothing outlasts touch.
    pub bridges: Vec<BridgeBlock>,
    /// What the springs against twisting hold; empty without them.
    pub twists: Vec<TwistBlock>,
    /// Their annuli; empty unless contacts slip in part.
    pub annuli: Vec<AnnuliBlock>,
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
        if memory.force {
            self.forces.push(SpringBlock::default());
        }
        if memory.torque {
            self.torques.push(TorqueBlock::default());
        }
        if memory.bridge {
            self.bridges.push(BridgeBlock::default());
        }
        if memory.twist {
            self.twists.push(TwistBlock::default());
        }
        if memory.annuli {
            self.annuli.push(AnnuliBlock::default());
        }
    }

    /// Whether contacts remember nothing.
    pub fn is_empty(&self) -> bool {
        self.forces.is_empty() && self.bridges.is_empty()
    }

    /// The spring of a contact; relaxed if contacts remember nothing.
    pub fn get(&self, contact: usize) -> History {
        let (block, lane) = (contact / WIDTH, contact % WIDTH);
        let mut spring = self.forces.get(block).map_or(Spring::relaxed(), |forces| forces.load(lane));
        if let Some(torques) = self.torques.get(block) {
            spring.torque = torques.load(lane);
        }
        if let Some(bridges) = self.bridges.get(block) {
            spring.bridge = bridges.load(lane);
        }
        if let Some(twists) = self.twists.get(block) {
            spring.twist = twists.load(lane);
        }
        let annuli = self.annuli.get(block).map(|annuli| Box::new(annuli.load(lane)));
        History { spring, annuli }
    }

    /// Sets the spring of a contact, if contacts remember.
    pub fn set(&mut self, contact: usize, history: &History) {
        let (block, lane) = (contact / WIDTH, contact % WIDTH);
        let History { spring, annuli } = history;
        if let Some(forces) = self.forces.get_mut(block) {
            forces.store(lane, spring);
        }
        if let Some(torques) = self.torques.get_mut(block) {
            torques.store(lane, spring.torque);
        }
        if let Some(bridges) = self.bridges.get_mut(block) {
            bridges.store(lane, spring.bridge);
        }
        if let Some(twists) = self.twists.get_mut(block) {
            twists.store(lane, spring.twist);
        }
        if let (Some(blocks), Some(annuli)) = (self.annuli.get_mut(block), annuli) {
            blocks.store(lane, annuli);
        }
    }

    /// Energy of all tangential springs \[J\].
    pub fn energy(&self) -> f64 {
        if self.annuli.is_empty() {
            return self.forces.iter().map(SpringBlock::energy).sum();
        }
        (0..self.annuli.len() * WIDTH).map(|contact| self.get(contact).energy()).sum()
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.forces.clear();
        self.torques.clear();
        self.bridges.clear();
        self.twists.clear();
        self.annuli.clear();
    }

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        self.forces.clone_from(&other.forces);
        self.torques.clone_from(&other.torques);
        self.bridges.clone_from(&other.bridges);
        self.twists.clone_from(&other.twists);
        self.annuli.clone_from(&other.annuli);
    }
}
