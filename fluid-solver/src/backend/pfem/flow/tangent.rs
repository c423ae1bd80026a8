//! How the stress of a cell follows its rate of shear where the viscosity depends on it.

use super::cell::{Cell, Tensor, product};
use super::rheology::{Law, Rheology};
use crate::element::simplex::{Vector, dot};

/// The linearised law of a cell, with E = ∇v + ∇vᵀ − ⅔∇·v, γ̇ = √(½E:E) and n = E/γ̇:
///
/// δτ = μδE − s ½[w(½n:δE) + n(½w:δE)], s = −γ̇ dμ/dγ̇.
///
/// Newton's method for τ = μ(γ̇)E has w = n, and fails where a small step of v turns n round, as on the rim of a plug.
/// Here τ is an unknown beside v, τ/μ(γ̇) = E: the step of this system eliminated, w is the direction of the stress that the
/// last step arrived at, cut off at ½w:w = 1, so that the tangent is symmetric and not negative. At the solution w = n.
///
/// Source: Chan, Golub and Mulet, *SIAM J. Sci. Comput.* 20 (1999) 1964; Aposporidis, Haber, Olshanskii and Veneziani,
/// *Comput. Methods Appl. Mech. Eng.* 200 (2011) 2434.
#[derive(Clone, Copy, Debug)]
pub struct Tangent<const D: usize> {
    /// s (Pa s).
    softening: f64,
    /// n (-).
    direction: Tensor<D>,
    /// w (-).
    stress_direction: Tensor<D>,
    /// τ that the last step arrived at (Pa); none before the first.
    stress: Option<Tensor<D>>,
}

impl<const D: usize> Tangent<D> {
    /// Of no stress yet.
    pub const UNKNOWN: Self =
        Self { softening: 0.0, direction: [[0.0; D]; D], stress_direction: [[0.0; D]; D], stress: None };

    /// At a cell whose corners have these velocities; the stress is that of the last step.
    pub fn at<const N: usize>(&self, cell: &Cell<D, N>, v: &[Vector<D>; N], rheology: &Rheology) -> Self {
        let strain_rate = cell.strain_rate(v);
        let shear_rate = product(&strain_rate, &strain_rate).sqrt();
        if shear_rate == 0.0 {
            return Self { stress: self.stress, ..Self::UNKNOWN };
        }
        let direction = scaled(&strain_rate, 1.0 / shear_rate);
        let stress_direction = self.stress.map_or(direction, |stress| {
            let direction = scaled(&stress, 1.0 / (cell.viscosity * shear_rate));
            scaled(&direction, 1.0 / product(&direction, &direction).sqrt().max(1.0))
        });
        let softening = rheology.softening(shear_rate);
        Self { softening, direction, stress_direction, stress: self.stress }
    }

    /// Takes ∫(μδE − δτ)∇N_i off the forces on the corners (N).
    pub fn relieve<const N: usize>(
        &self,
        cell: &Cell<D, N>,
        dv: &[Vector<D>; N],
        forces: &mut [Vector<D>; N],
    ) {
        let change = cell.strain_rate(dv);
        let along = 0.5 * self.softening * product(&self.direction, &change);
        let across = 0.5 * self.softening * product(&self.stress_direction, &change);
        for (force, area) in forces.iter_mut().zip(&cell.areas) {
            for k in 0..D {
                force[k] -=
                    along * dot(&self.stress_direction[k], area) + across * dot(&self.direction[k], area);
            }
        }
    }

    /// Goes on to τ + δτ, the corners having v before the step.
    pub fn advance<const N: usize>(&mut self, cell: &Cell<D, N>, v: &[Vector<D>; N], dv: &[Vector<D>; N]) {
        let (strain_rate, change) = (cell.strain_rate(v), cell.strain_rate(dv));
        let softened = self.softening * product(&self.direction, &change);
        self.stress = Some(std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                cell.viscosity * (strain_rate[k][l] + change[k][l]) - softened * self.stress_direction[k][l]
            })
        }));
    }
}

fn scaled<const D: usize>(a: &Tensor<D>, factor: f64) -> Tensor<D> {
    a.map(|row| row.map(|value| factor * value))
}
