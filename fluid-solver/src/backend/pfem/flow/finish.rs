//! The end of a step.

use super::contact::moved;
use super::krylov::split;
use super::solution::FlowSolution;
use super::solve::{Flow, Progress, Start};
use crate::element::simplex::{Vector, difference};
use linear::vector;

impl<const D: usize, const N: usize> Flow<D, N> {
    /// v_n + (v_m − v_n)/θ of a node that has v_m = `middle`: the velocity at the end if no wall held it.
    pub(super) fn unheld(&self, node: usize, middle: &Vector<D>) -> Vector<D> {
        let before = &self.projected.velocity[node];
        let implicitness = if self.assembly.volumes[node] == 0.0 { 0.5 } else { self.implicitness };
        moved(before, 1.0 / implicitness, &difference(middle, before))
    }

    /// The velocity at the end, and what the walls did.
    ///
    /// Σ m_i (v_{n+1} − v_n) = Δt (Σ (forces + reactions) − exchange) to round-off: what the solver left of the rows of free
    /// nodes, their inner forces having no sum but that, is taken from all of them alike.
    pub(super) fn finish(
        &self,
        start: Start<'_, D, N>,
        velocity: Vec<Vector<D>>,
        mut pressure: Vec<f64>,
        progress: Progress,
    ) -> FlowSolution<D> {
        let Start { cloud, walls, step, forces } = start;
        let (rows, _) = split::<D>(&self.rows);
        let volumes = self.assembly.volumes.iter().zip(&cloud.drop);
        let mass: Vec<f64> = volumes.map(|(volume, drop)| self.fluid.density * (volume + drop)).collect();
        let projected = &self.projected;
        let is_free = |node: usize| self.contact.touched[node].is_empty();
        // Of the velocity at the end.
        let drag = |node: usize| forces.grains.map_or(0.0, |grains| grains.drag.resistance[node]);
        let (mut left, mut resistance) = ([0.0; D], 0.0);
        for node in (0..mass.len()).filter(|&node| is_free(node)) {
            resistance += self.fluid.density * self.assembly.volumes[node] / step.length + drag(node);
            left = moved(&left, 1.0, &rows[node]);
            // The masses of the middle are not those that the blow had at t_n.
            let gained = difference(&projected.velocity[node], &cloud.velocity[node]);
            left = moved(&left, mass[node] / step.length, &gained);
            left = moved(&left, -self.implicitness, &projected.blow[node]);
        }
        let exchange = match forces.grains {
            Some(_) => [0.0; D],
            None => {
                let exchange = self.assembly.exchange(&cloud.cells, &velocity, &pressure, &self.excess);
                exchange.map(|exchange| self.fluid.density * exchange)
            }
        };
        let drift = left.map(|left| if resistance > 0.0 { left / resistance } else { 0.0 });
        let mut end_velocity = projected.velocity.clone();
        let mut reaction = vec![[0.0; D]; mass.len()];
        for node in 0..mass.len() {
            let (before, middle) = (&projected.velocity[node], &velocity[node]);
            let flies = self.assembly.volumes[node] == 0.0;
            let unheld = self.unheld(node, middle);
            let change = difference(&unheld, before);
            let end = &mut end_velocity[node];
            *end = unheld;
            let taken = self.rebound.force[node];
            if !flies {
                *end = moved(end, 1.0 / (mass[node] / step.length + drag(node)), &taken);
            }
            if is_free(node) {
                if !flies {
                    *end = moved(end, -1.0, &drift);
                }
                continue;
            }
            *end = self.contact.at_end(cloud, walls, step, node, middle, end);
            let other: Vector<D> = if flies {
                forces.gravity.map(|g| mass[node] * g)
            } else {
                std::array::from_fn(|k| mass[node] * change[k] / step.length - rows[node][k])
            };
            let friction = self.friction.force(node);
            reaction[node] = std::array::from_fn(|k| {
                let inertia = mass[node] * (end[k] - cloud.velocity[node][k]) / step.length;
                let blow = self.implicitness * projected.blow[node][k];
                inertia + drag(node) * (end[k] - unheld[k]) - other[k] - blow - taken[k] + friction[k]
            });
        }
        vector::axpy(1.0, &self.rebound.pressure, &mut pressure);
        FlowSolution {
            contacts: self.contact.left(cloud, walls, step, &velocity),
            velocity,
            end_velocity,
            pressure,
            reaction,
            mass,
            exchange,
            implicitness: self.implicitness,
            friction: self.friction.power(),
            iterations: progress.iterations,
            passes: progress.passes,
            residuals: progress.residuals,
        }
    }
}
