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

    /// Takes ∫(μδE − δτ)∇N_i, or ∇(εN_i) where grains are, off the forces on the corners (N); `areas` are the integrals of
    /// these gradients (m²).
    pub fn relieve<const N: usize>(
        &self,
        cell: &Cell<D, N>,
        areas: &[Vector<D>; N],
        dv: &[Vector<D>; N],
        forces: &mut [Vector<D>; N],
    ) {
        let change = cell.strain_rate(dv);
        let along = 0.5 * self.softening * product(&self.direction, &change);
        let across = 0.5 * self.softening * product(&self.stress_direction, &change);
        for (force, area) in forces.iter_mut().zip(areas) {
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

#[cfg(test)]
mod tests {
    use super::super::rheology::HerschelBulkley;
    use super::*;

    const CORNERS: [[f64; 3]; 4] = [[0.1, 0.2, 0.3], [1.3, 0.1, 0.2], [0.2, 1.5, 0.4], [0.3, 0.1, 1.9]];
    const V: [[f64; 3]; 4] = [[0.3, -0.1, 0.2], [-0.4, 0.2, 0.1], [0.5, 0.6, -0.7], [-0.2, 0.3, 0.9]];
    const CHANGE: [[f64; 3]; 4] = [[0.1, 0.7, -0.3], [0.2, -0.5, 0.4], [-0.6, 0.1, 0.8], [0.9, -0.2, 0.3]];
    const MUD: Rheology = Rheology::HerschelBulkley(HerschelBulkley {
        consistency: 2.0,
        exponent: 0.6,
        yield_stress: 5.0,
        creep_rate: 0.3,
    });

    fn forces(v: &[[f64; 3]; 4], cell: &Cell<3, 4>) -> [[f64; 3]; 4] {
        cell.rows(v, &[0.0; 4], &[0.0; 4], 0.0).0
    }

    fn work(forces: &[[f64; 3]; 4], v: &[[f64; 3]; 4]) -> f64 {
        forces.iter().zip(v).map(|(force, v)| dot(force, v)).sum()
    }

    #[test]
    fn before_a_step_the_tangent_is_the_derivative_of_the_forces() {
        let cell = Cell::new(&CORNERS, &V, 1.0, &MUD);
        let mut found = forces(&CHANGE, &cell);
        Tangent::UNKNOWN.at(&cell, &V, &MUD).relieve(&cell, &cell.areas, &CHANGE, &mut found);
        let after = |t: f64| {
            let v: [[f64; 3]; 4] =
                std::array::from_fn(|i| std::array::from_fn(|k| V[i][k] + t * CHANGE[i][k]));
            forces(&v, &Cell::new(&CORNERS, &v, 1.0, &MUD))
        };
        let (less, more) = (after(-1e-5), after(1e-5));
        for i in 0..4 {
            for k in 0..3 {
                let slope = (more[i][k] - less[i][k]) / 2e-5;
                assert!((found[i][k] - slope).abs() < 1e-7, "{i} {k}: {} {slope}", found[i][k]);
            }
        }
    }

    #[test]
    fn after_a_step_it_is_symmetric_and_never_negative() {
        let cell = Cell::new(&CORNERS, &V, 1.0, &MUD);
        let mut tangent = Tangent::UNKNOWN.at(&cell, &V, &MUD);
        tangent.advance(&cell, &V, &CHANGE);
        let tangent = tangent.at(&cell, &V, &MUD);
        let through = |v: &[[f64; 3]; 4]| {
            let mut found = forces(v, &cell);
            tangent.relieve(&cell, &cell.areas, v, &mut found);
            found
        };
        let (one, other) = (work(&through(&V), &CHANGE), work(&through(&CHANGE), &V));
        assert!((one - other).abs() < 1e-12 * one.abs(), "{one} {other}");
        for k in 0..16 {
            let share = k as f64 / 8.0 - 1.0;
            let v: [[f64; 3]; 4] =
                std::array::from_fn(|i| std::array::from_fn(|k| CHANGE[i][k] + share * V[i][k]));
            assert!(work(&through(&v), &v) >= 0.0);
        }
    }
}
