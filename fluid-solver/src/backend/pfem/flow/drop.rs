//! Nodes of no cell: drops, which fly, stop at walls and run along them.

use super::contact::moved;
use super::rheology::Law;
use super::solve::{Flow, Start};
use super::topology::Topology;
use crate::backend::pfem::wall::Grip;
use crate::element::simplex::{Vector, dot};

impl<const D: usize, const N: usize> Flow<D, N> {
    /// v_m of the drops: they fly, stop at walls and are dragged by those that grip and that they do not leave.
    pub(super) fn fly(&mut self, start: Start<'_, D, N>, topology: &Topology<N>, velocity: &mut [Vector<D>]) {
        let Start { cloud, walls, step, forces } = start;
        for (node, v) in velocity.iter_mut().enumerate().filter(|(node, _)| topology.is_drop(*node)) {
            *v = moved(v, 0.5 * step.length, &forces.gravity);
            self.contact.let_fly(walls, step, node, &cloud.place[node], v);
            let drag = self.drag_of_walls(start, node);
            *v = moved(v, -0.5, &drag);
        }
        self.contact.find(cloud, walls, step, velocity);
    }

    /// What a drop of volume V = d^D that runs along walls loses of its velocity u (m/s) in a step: a film of thickness d,
    /// parabolic from a wall that it sticks to to the surface, has the stress μ(γ̇)γ̇ there, γ̇ = 3u/d. Hence du/dt = −ru,
    /// r = 3μ/(ρd²), in one implicit step; a wall function has an r of its own.
    fn drag_of_walls(&self, start: Start<'_, D, N>, node: usize) -> Vector<D> {
        let Start { cloud, walls, step, .. } = start;
        let thickness = cloud.drop[node].powf(1.0 / D as f64);
        let mut lost = [0.0; D];
        for wall in self.contact.touched[node].iter().filter(|&wall| walls[wall].grip != Grip::Slip) {
            let touch = walls[wall].touch(&cloud.place[node], step.time);
            let relative = moved(&cloud.velocity[node], -1.0, &touch.velocity);
            let along = moved(&relative, -dot(&relative, &touch.normal), &touch.normal);
            let speed = dot(&along, &along).sqrt();
            let rate = if walls[wall].grip == Grip::WallFunction {
                self.fluid.friction_rate(thickness, speed)
            } else {
                let viscosity = self.fluid.rheology.viscosity(3.0 * speed / thickness);
                3.0 * viscosity / (self.fluid.density * thickness * thickness)
            };
            let decay = rate * step.length;
            lost = moved(&lost, decay / (1.0 + decay), &along);
        }
        lost
    }
}
