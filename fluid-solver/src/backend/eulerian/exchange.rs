//! Momentum exchange with the grains: the reaction F − β_e(u − v*) of every grain, spread by its weights.

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
}

/// The reactions of all grains on the fluid.
#[derive(Debug, Default)]
pub struct Exchange<const D: usize> {
    /// w_pa, Σ_a w_pa = 1; none for a grain outside the fluid.
    weights: Weights,
    reactions: Vec<Reaction<D>>,
    silent: bool,
    scratch: RefCell<Scratch<D>>,
}

#[derive(Debug, Default)]
struct Scratch<const D: usize> {
    at_grains: Vec<Vector<D>>,
    coefficients: Vec<[f64; 1]>,
    deposit: Deposit<D>,
    deposit_scalar: Deposit<1>,
}

/// Which part of an affine map is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Without constants: the map of increments.
    Linear,
    /// With constants.
    Affine,
}

impl<const D: usize> Reaction<D> {
    const NONE: Self = Self { coefficient: 0.0, target: [0.0; D], force: [0.0; D] };

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
    }

    /// Whether no grain acts on the fluid.
    pub fn is_silent(&self) -> bool {
        self.silent || self.weights.grains() == 0
    }

    /// Σ_p w_pa [β_e(u − v*) − F], or its linear part: the force on the grains, by nodes (N).
    pub fn force_on_grains(&self, part: Part, velocity: &[Vector<D>], nodal: &mut [Vector<D>]) {
        let Scratch { at_grains, deposit, .. } = &mut *self.scratch.borrow_mut();
        at_grains.resize(self.weights.grains(), [0.0; D]);
        sample(&self.weights, velocity, at_grains);
        for (value, reaction) in at_grains.iter_mut().zip(&self.reactions) {
            *value = match part {
                Part::Linear => value.map(|u| reaction.coefficient * u),
                Part::Affine => {
                    let drag = reaction.drag(value);
                    std::array::from_fn(|k| drag[k] - reaction.force[k])
                }
            };
        }
        deposit.apply(&self.weights, at_grains, nodal);
    }

    /// Σ_p w_pa β_e: the lumped diagonal of the drag (kg/s).
    pub fn lumped(&self, nodal: &mut [f64]) {
        let Scratch { coefficients, deposit_scalar, .. } = &mut *self.scratch.borrow_mut();
        coefficients.clear();
        coefficients.extend(self.reactions.iter().map(|reaction| [reaction.coefficient]));
        deposit_scalar.apply(&self.weights, coefficients, nodal.as_chunks_mut().0);
    }

    /// Σ_p w_pa² β_e: the diagonal of the drag (kg/s), small against the lumped one for kernels of many nodes.
    pub fn diagonal(&self, nodal: &mut [f64]) {
        nodal.fill(0.0);
        for (p, reaction) in self.reactions.iter().enumerate() {
            let (nodes, weights) = self.weights.row(p);
            for (&node, weight) in nodes.iter().zip(weights) {
                nodal[node as usize] += weight * weight * reaction.coefficient;
            }
        }
    }

    /// Sums over the grains in the fluid: drag Σβ_e(u − v*), explicit force ΣF, and Σ of the sizes of both (N).
    pub fn totals(&self, velocity: &[Vector<D>]) -> (Vector<D>, Vector<D>, f64) {
        let at_grains = &mut self.scratch.borrow_mut().at_grains;
        at_grains.resize(self.weights.grains(), [0.0; D]);
        sample(&self.weights, velocity, at_grains);
        let (mut drag, mut explicit, mut scale) = ([0.0; D], [0.0; D], 0.0);
        for (p, (u, reaction)) in at_grains.iter().zip(&self.reactions).enumerate() {
            if self.weights.row(p).0.is_empty() {
                continue;
            }
            let force = reaction.drag(u);
            for k in 0..D {
                drag[k] += force[k];
                explicit[k] += reaction.force[k];
                scale += force[k].abs() + reaction.force[k].abs();
            }
        }
        (drag, explicit, scale)
    }
}
