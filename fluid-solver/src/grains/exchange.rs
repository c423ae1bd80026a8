//! Momentum exchange with the grains: the reaction F − β_e(u − v*) of every grain, spread by its weights.

use super::compliance::Compliance;
use crate::deposit::Deposit;
use crate::element::simplex::Vector;
use crate::sample::sample;
use crate::void_fraction::Weights;
use std::cell::RefCell;

/// A grain's reaction on the fluid, per depth of the slab in 2D.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reaction<const D: usize> {
    /// β_e (kg/s; kg/(m s) in 2D).
    pub coefficient: f64,
    /// v* (m/s).
    pub target: Vector<D>,
    /// F (N; N/m in 2D).
    pub force: Vector<D>,
    /// R (m³; m² in 2D).
    pub relayed_volume: f64,
    /// V (m³; m² in 2D).
    pub volume: f64,
    /// 1/m (1/kg; m/kg in 2D); 0 for a grain that does not give way.
    pub inverse_mass: f64,
}

/// The grains' drag at the nodes, d_a u_a − g_a (N).
///
/// A node takes the share w_pa of a grain's resistance at its *own* velocity: Σ_a w_pa β_e(u_a − v*) = β_e(u_p − v*) is the
/// force by the sampled velocity u_p, so the grain feels nothing of it, the sum over nodes is exact, the system stays
/// sparse, and a bed resists flow on every wavelength, also those that its kernels average out.
#[derive(Debug, Clone, Default)]
pub struct NodalDrag<const D: usize> {
    /// d_a = Σ_p w_pa β_e (kg/s).
    pub resistance: Vec<f64>,
    /// g_a = Σ_p w_pa (β_e v* + F) (N).
    pub given: Vec<Vector<D>>,
}

impl<const D: usize> NodalDrag<D> {
    /// No drag at this many nodes.
    pub fn clear(&mut self, nodes: usize) {
        self.resistance.clear();
        self.resistance.resize(nodes, 0.0);
        self.given.clear();
        self.given.resize(nodes, [0.0; D]);
    }
}

/// The reactions of all grains on the fluid.
#[derive(Debug, Default)]
pub struct Exchange<const D: usize> {
    /// w_pa, Σ_a w_pa = 1; none for a grain outside the fluid.
    weights: Weights,
    reactions: Vec<Reaction<D>>,
    silent: bool,
    /// The grains give way inside the step.
    compliant: bool,
    scratch: RefCell<Scratch<D>>,
}

#[derive(Debug, Default)]
struct Scratch<const D: usize> {
    at_grains: Vec<Vector<D>>,
    gradients: Vec<Vector<D>>,
    coefficients: Vec<[f64; 4]>,
    lumped: Vec<[f64; 4]>,
    deposit: Deposit<D>,
    deposit_lumped: Deposit<4>,
}

impl<const D: usize> Reaction<D> {
    const NONE: Self = Self {
        coefficient: 0.0,
        target: [0.0; D],
        force: [0.0; D],
        relayed_volume: 0.0,
        volume: 0.0,
        inverse_mass: 0.0,
    };

    /// β_e v* + F: the force on a fluid at rest.
    fn at_rest(&self) -> Vector<D> {
        std::array::from_fn(|k| self.coefficient * self.target[k] + self.force[k])
    }

    /// β_e(u − v*).
    fn drag(&self, velocity: &Vector<D>) -> Vector<D> {
        std::array::from_fn(|k| self.coefficient * (velocity[k] - self.target[k]))
    }
}

impl<const D: usize> Exchange<D> {
    /// The weights of the grains.
    pub fn weights(&self) -> &Weights {
        &self.weights
    }

    /// The weights, to be rebuilt; the grains are silent until they are given reactions.
    pub fn weights_mut(&mut self) -> &mut Weights {
        self.silent = true;
        &mut self.weights
    }

    /// Gives every grain its reaction; those without one stay silent.
    pub fn react(&mut self, reactions: impl IntoIterator<Item = Reaction<D>>) {
        self.reactions.clear();
        self.reactions.extend(reactions);
        self.reactions.resize(self.weights.grains(), Reaction::NONE);
        self.silent = self.reactions.iter().all(|r| r.coefficient == 0.0 && r.force == [0.0; D]);
        self.compliant = self.reactions.iter().any(|r| r.relayed_volume > 0.0 || r.inverse_mass > 0.0);
    }

    /// Whether no grain acts on the fluid.
    pub fn is_silent(&self) -> bool {
        self.silent || self.weights.grains() == 0
    }

    /// The drag at the nodes, and how the grains give way in a step (s) of a time rule with the leading coefficient `rate`
    /// (1/s).
    pub fn lump(
        &self,
        measure: &[f64],
        (rate, step): (f64, f64),
        drag: &mut NodalDrag<D>,
        compliance: &mut Vec<Compliance>,
    ) {
        compliance.clear();
        drag.clear(measure.len());
        if self.is_silent() {
            return;
        }
        let Scratch { at_grains, coefficients, lumped, deposit, deposit_lumped, .. } =
            &mut *self.scratch.borrow_mut();
        at_grains.clear();
        at_grains.extend(self.reactions.iter().map(Reaction::at_rest));
        deposit.apply(&self.weights, at_grains, &mut drag.given);
        coefficients.clear();
        coefficients.extend(self.reactions.iter().map(|grain| {
            let moved = rate * step * step * grain.volume * grain.inverse_mass;
            let kept = grain.volume - grain.relayed_volume;
            [grain.coefficient, grain.relayed_volume, moved * grain.coefficient, moved * kept]
        }));
        lumped.resize(measure.len(), [0.0; 4]);
        deposit_lumped.apply(&self.weights, coefficients, lumped);
        for ((sums, measure), resistance) in lumped.iter().zip(measure).zip(&mut drag.resistance) {
            *resistance = sums[0];
            if self.compliant {
                let [_, relayed, entrained, pressed] = sums.map(|sum| sum / measure);
                compliance.push(Compliance { relayed, entrained, pressed });
            }
        }
    }

    /// Sums over the grains in the fluid: drag Σ[β_e(u − v*) + R ∇(p − p′)], explicit force ΣF, and Σ of the sizes (N);
    /// `gradient` is the nodal ∇(p − p′).
    pub fn totals(&self, velocity: &[Vector<D>], gradient: &[Vector<D>]) -> (Vector<D>, Vector<D>, f64) {
        let Scratch { at_grains, gradients, .. } = &mut *self.scratch.borrow_mut();
        at_grains.resize(self.weights.grains(), [0.0; D]);
        gradients.resize(self.weights.grains(), [0.0; D]);
        sample(&self.weights, velocity, at_grains);
        sample(&self.weights, gradient, gradients);
        let (mut drag, mut explicit, mut scale) = ([0.0; D], [0.0; D], 0.0);
        for (p, ((u, gradient), reaction)) in at_grains.iter().zip(gradients).zip(&self.reactions).enumerate()
        {
            if self.weights.row(p).0.is_empty() {
                continue;
            }
            let force = reaction.drag(u);
            for k in 0..D {
                let relayed = reaction.relayed_volume * gradient[k];
                drag[k] += force[k] + relayed;
                explicit[k] += reaction.force[k];
                scale += force[k].abs() + relayed.abs() + reaction.force[k].abs();
            }
        }
        (drag, explicit, scale)
    }

    /// R of a grain (m³; m² in 2D); 0 while the grains are silent.
    pub fn relayed_volume(&self, grain: usize) -> f64 {
        if self.is_silent() { 0.0 } else { self.reactions[grain].relayed_volume }
    }
}
