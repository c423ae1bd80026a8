//! Scenes that run as in a case: at a fraction of the critical step, found anew for each window.

use crate::contact::stored_energy;
use crate::critical_time_step::{Substep, critical_time_step, substeps};
use crate::error::DemError;
use crate::grains::Grain;
use crate::kinetic_energy::kinetic_energies;
use crate::scene::Scene;
use crate::window::window;
use crate::workspace::Workspace;
use crate::world::World;

/// A scene with its state and scratch.
pub struct Runner {
    pub scene: Scene<3>,
    pub world: World<3>,
    workspace: Workspace<3>,
}

impl Runner {
    pub fn new(scene: Scene<3>, grains: &[Grain<3>]) -> Self {
        let mut world = World::new();
        grains.iter().for_each(|grain| world.add(&scene, grain));
        Self { scene, world, workspace: Workspace::new() }
    }

    /// Makes the lists: a window in which nothing moves to speak of.
    pub fn begin(&mut self) -> Result<(), DemError> {
        self.window(1e-15, 1)
    }

    /// The critical step now \[s\].
    pub fn critical(&self) -> f64 {
        critical_time_step(&self.scene, &self.world).step
    }

    /// A window in so many substeps.
    pub fn window(&mut self, duration: f64, substeps: u32) -> Result<(), DemError> {
        window(&self.scene, &mut self.world, &mut self.workspace, None, duration, substeps).map(drop)
    }

    /// A window of so many steps, each this fraction of the critical one.
    pub fn steps(&mut self, steps: u32, fraction: f64) -> Result<(), DemError> {
        let step = fraction * self.critical();
        self.window(f64::from(steps) * step, steps)
    }

    /// Windows of `interval` \[s\] at half the critical step until `duration` \[s\] is over.
    pub fn run(&mut self, duration: f64, interval: f64) -> Result<(), DemError> {
        let end = self.world.time + duration;
        while self.world.time < end - 0.5 * interval {
            let critical = critical_time_step(&self.scene, &self.world);
            self.window(interval, substeps(interval, Substep::Fraction(0.5), &critical)?)?;
        }
        Ok(())
    }

    /// Kinetic energy \[J\].
    pub fn kinetic_energy(&self) -> f64 {
        kinetic_energies(&self.world).iter().sum()
    }

    /// Kinetic, stored and potential energy \[J\].
    pub fn energy(&self) -> f64 {
        let grains = &self.world.grains;
        let height = grains.place.iter().zip(&grains.mass).map(|(place, &mass)| place.centre * mass);
        let potential = -height.map(|moment| self.scene.gravity.dot(&moment)).sum::<f64>();
        self.kinetic_energy() + stored_energy(&self.scene, &self.world) + potential
    }
}
