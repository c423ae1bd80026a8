//! What v_n has of divergence goes before the step.

use super::chunks::for_each;
use super::contact::moved;
use super::krylov::split_mut;
use super::nodal::{Fields, Part};
use super::preconditioner::{Preconditioning, Rates};
use super::setting::Fluid;
use super::solve::{Flow, Start};
use super::topology::Topology;
use crate::element::simplex::Vector;
use interface::usage::ThreadClock;
use linear::Preconditioner;

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
    /// Whether the divergence of v_n is to go first: what grains leave that move is due.
    pub(super) fn projects(&self, start: Start<'_, D, N>) -> bool {
        start.forces.grains.is_none() && self.turns_round()
    }

    /// Whether steps keep what is left of a divergence: what pressure compresses is due, and a yield stress has steps of θ = 1.
    pub(super) fn turns_round(&self) -> bool {
        let Fluid { rheology, bulk_modulus, .. } = &self.fluid;
        bulk_modulus.is_none() && rheology.is_newtonian() && self.scheme.projects()
    }

    /// v = v_n + (θΔt/ρV_i) ∫φ∇N_i in the free directions with Pφ = −∫N∇·v_n on the mesh at t_n.
    ///
    /// Blows and changes of the mesh leave a divergence in v_n. The midpoint rule has ∇·v_m = 0 and v_{n+1} = 2v_m − v_n: it would
    /// turn it round in each step for ever, with pressures that alternate and grow. The constraint takes this part of v_n anyway,
    /// so v_m is the same without it. P is that of the approximate inverse of the step: what it leaves goes in the next ones, and
    /// as it is not less than D M⁻¹ Dᵀ nothing is taken twice.
    pub(super) fn project(
        &mut self,
        start: Start<'_, D, N>,
        (topology, preconditioning): &mut (Topology<N>, Preconditioning<D>),
    ) -> Result<(), linear::Error> {
        let Start { cloud, walls, step, .. } = start;
        let (nodes, projects, inertia) = (cloud.place.len(), self.projects(start), self.inertia(step));
        let Projected { velocity, blow, divergence, blow_pressure } = &mut self.projected;
        velocity.clone_from(&cloud.velocity);
        blow.clear();
        blow.resize(nodes, [0.0; D]);
        if !projects {
            return Ok(());
        }
        let mut clock = ThreadClock::start();
        self.contact.constrain(cloud, walls, step, velocity);
        let rheology = &self.fluid.rheology;
        self.assembly.place(topology, |node| cloud.place[node], velocity, inertia, rheology);
        let constraints = &self.contact.constraints;
        let rates = Rates { inertia, compressibility: 0.0, mobility: None, friction: &self.friction };
        self.spent.assembly += clock.lap();
        preconditioning.refresh(cloud, topology, &self.assembly, constraints, rates, None)?;
        self.spent.solve += clock.lap();

        divergence.resize(nodes, 0.0);
        blow_pressure.clear();
        blow_pressure.resize(nodes, 0.0);
        self.excess.fill([0.0; D]);
        let (forces, _) = split_mut::<D>(&mut self.rows);
        let fields = Fields {
            velocity,
            pressure: blow_pressure,
            excess: &self.excess,
            density: 0.0,
            bulk: 0.0,
            part: Part::Linear,
            grains: None,
        };
        self.assembly.evaluate(topology, fields, 0.0, forces, divergence);
        for_each(divergence, |_, rate| *rate = -*rate);
        self.spent.assembly += clock.lap();
        preconditioning.pressure.apply(divergence, blow_pressure);
        self.spent.solve += clock.lap();
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
