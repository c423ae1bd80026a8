//! Sliding walls through a window.

use crate::scene::Scene;
use crate::wall::{Slide, WallImpulse, drift};
use crate::workspace::Workspace;
use crate::world::World;

/// What walls had received up to the last substep of a window; nothing where no wall slides.
pub struct Sliding<const D: usize>(Vec<WallImpulse<D>>);

impl<const D: usize> Sliding<D> {
    /// Slides the walls to the middle of the first substep, `flight` \[s\] on.
    pub fn open(scene: &Scene<D>, world: &mut World<D>, flight: f64) -> Self {
        if !scene.walls.slide() {
            return Self(vec![]);
        }
        world.slides.resize(scene.walls.len(), Slide::default());
        drift(&mut world.slides, flight);
        Self(vec![WallImpulse::zero(); scene.walls.len()])
    }

    /// Gives the walls the momentum of a substep \[s\], and slides them on for `flight` \[s\].
    pub fn on(
        &mut self,
        scene: &Scene<D>,
        world: &mut World<D>,
        workspace: &Workspace<D>,
        step: f64,
        flight: f64,
    ) {
        if self.0.is_empty() {
            return;
        }
        let so_far = workspace.wall_impulse(scene.walls.len());
        let received: Vec<_> = so_far.iter().zip(&self.0).map(|(&now, &before)| now - before).collect();
        scene.walls.kick(&mut world.slides, &received, step);
        drift(&mut world.slides, flight);
        self.0 = so_far;
    }
}
