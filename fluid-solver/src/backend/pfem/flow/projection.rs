//! What v_n has of divergence goes before the step.

use super::chunks::for_each;
use super::contact::moved;
use super::krylov::split_mut;
use super::nodal::Fields;
use super::preconditioner::Preconditioning;
use super::solve::{Flow, Start};
use super::topology::Topology;
use crate::element::simplex::Vector;

/// v_n without (most of) its divergence, and the blow that took it.
#[derive(Debug, Default)]
pub struct Projected<const D: usize> {
    /// v (m/s).
    pub velocity: Vec<Vector<D>>,
    /// ∫φ∇N_i (N), which acts for θΔt.
    pub blow: Vec<Vector<D>>,
    divergence: Vec<f64>,
    blow_pressure: Vec<f64>,
}

impl<const D: usize, const N: usize> Flow<D, N> {
    /// v = v_n + (θΔt/ρV_i) ∫φ∇N_i in the free directions with Pφ = −∫N∇·v_n on the mesh at t_n.
    ///
    /// Blows and changes of the mesh leave a divergence in v_n. The midpoint rule has ∇·v_m = 0 and v_{n+1} = 2v_m − v_n: it would
    /// turn it round in each step for ever, with pressures that alternate and grow. The constraint takes this part of v_n anyway,
    /// so v_m is the same without it. P is the approximate inverse of the step: what it leaves goes in the next ones. Grains
    /// that move leave a divergence that is due: with them v_n stays.
    pub(super) fn project(
        &mut self,
        start: Start<'_, D, N>,
        (topology, preconditioning): &mut (Topology<N>, Preconditioning<D>),
    ) -> Result<(), linear::Error> {
        let Start { cloud, walls, step, forces } = start;
        let nodes = cloud.place.len();
        let Projected { velocity, blow, divergence, blow_pressure } = &mut self.projected;
        velocity.clone_from(&cloud.velocity);
        blow.clear();
        blow.resize(nodes, [0.0; D]);
        if forces.grains.is_some() {
            return Ok(());
        }
        self.contact.constrain(cloud, walls, step, velocity);
        let inertia = self.fluid.density / (self.implicitness * step.length);
        let rheology = &self.fluid.rheology;
        self.assembly.place(topology, |node| cloud.place[node], velocity, inertia, rheology);
        let rates = (inertia, self.fluid.bulk_modulus.map_or(0.0, |modulus| 1.0 / (modulus * step.length)));
        let constraints = &self.contact.constraints;
        preconditioning.refresh(cloud, topology, &self.assembly, constraints, rates, None)?;

        divergence.resize(nodes, 0.0);
        blow_pressure.clear();
        blow_pressure.resize(nodes, 0.0);
        self.excess.fill([0.0; D]);
        let (forces, _) = split_mut::<D>(&mut self.rows);
        let fields = Fields { velocity, pressure: blow_pressure, excess: &self.excess, grains: None };
        self.assembly.evaluate(topology, fields, 0.0, forces, divergence);
        for_each(divergence, |_, rate| *rate = -*rate);
        preconditioning.press(divergence, blow_pressure);
        self.assembly.pressure_forces(topology, None, blow_pressure, blow);
        let volumes = &self.assembly.volumes;
        for_each(velocity, |node, v| {
            if volumes[node] > 0.0 {
                *v = moved(v, 1.0 / (inertia * volumes[node]), &constraints[node].free(&blow[node]));
            }
        });
        Ok(())
    }
}
