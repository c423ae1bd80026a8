//! What the flow is, and all that the next step depends on.

use crate::element::simplex::Vector;

/// Fields at the nodes: the present iterate, and the history that the time rule needs.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct State<const D: usize> {
    /// u (m/s): the iterate at t_{n+1}, or uⁿ when the last step is history.
    pub velocity: Vec<Vector<D>>,
    /// uⁿ.
    pub velocity_old: Vec<Vector<D>>,
    /// uⁿ⁻¹.
    pub velocity_older: Vec<Vector<D>>,
    /// p (Pa).
    pub pressure: Vec<f64>,
    /// ε (-).
    pub void_fraction: Vec<f64>,
    /// εⁿ.
    pub void_fraction_old: Vec<f64>,
    /// εⁿ⁻¹.
    pub void_fraction_older: Vec<f64>,
    /// D_t u of the last solve (m/s²).
    pub acceleration: Vec<Vector<D>>,
    /// Length of the last step that is history (s); none before the first.
    pub previous_step: Option<f64>,
}

impl<const D: usize> State<D> {
    /// A state at rest without pressure and grains.
    pub fn new(nodes: usize) -> Self {
        Self {
            velocity: vec![[0.0; D]; nodes],
            velocity_old: vec![[0.0; D]; nodes],
            velocity_older: vec![[0.0; D]; nodes],
            pressure: vec![0.0; nodes],
            void_fraction: vec![1.0; nodes],
            void_fraction_old: vec![1.0; nodes],
            void_fraction_older: vec![1.0; nodes],
            acceleration: vec![[0.0; D]; nodes],
            previous_step: None,
        }
    }

    /// Becomes a copy, without allocation.
    pub fn copy_from(&mut self, other: &Self) {
        self.velocity.copy_from_slice(&other.velocity);
        self.velocity_old.copy_from_slice(&other.velocity_old);
        self.velocity_older.copy_from_slice(&other.velocity_older);
        self.pressure.copy_from_slice(&other.pressure);
        self.void_fraction.copy_from_slice(&other.void_fraction);
        self.void_fraction_old.copy_from_slice(&other.void_fraction_old);
        self.void_fraction_older.copy_from_slice(&other.void_fraction_older);
        self.acceleration.copy_from_slice(&other.acceleration);
        self.previous_step = other.previous_step;
    }

    /// Makes a history before the first step (s): uⁿ⁻¹ = uⁿ, and ε as it goes on from there, εⁿ⁻¹ = 2εⁿ − ε.
    ///
    /// What the grains give in a step changes 3/2 Mⁿ⁺¹ − 2 Mⁿ + 1/2 Mⁿ⁻¹; from Mⁿ⁻¹ = Mⁿ all of it reaches M, two thirds at
    /// once. A first step by backward Euler, second order where forces begin smoothly, would take it one and a half times.
    pub fn begin_with_grains(&mut self, step: f64) {
        self.velocity_older.copy_from_slice(&self.velocity_old);
        let (new, old) = (&self.void_fraction, &self.void_fraction_old);
        for (older, (new, old)) in self.void_fraction_older.iter_mut().zip(new.iter().zip(old)) {
            *older = 2.0 * old - new;
        }
        self.previous_step = Some(step);
    }

    /// The iterate becomes history after a step of the given length (s).
    pub fn commit(&mut self, step: f64) {
        std::mem::swap(&mut self.velocity_older, &mut self.velocity_old);
        self.velocity_old.copy_from_slice(&self.velocity);
        std::mem::swap(&mut self.void_fraction_older, &mut self.void_fraction_old);
        self.void_fraction_old.copy_from_slice(&self.void_fraction);
        self.previous_step = Some(step);
    }

    /// Takes ε as that of tₙ: grains that came or went leave no rate of change behind.
    pub fn reset_void_fraction(&mut self, void_fraction: &[f64]) {
        for (older, (old, new)) in
            self.void_fraction_older.iter_mut().zip(self.void_fraction_old.iter().zip(void_fraction))
        {
            *older += new - old;
        }
        self.void_fraction_old.copy_from_slice(void_fraction);
        self.void_fraction.copy_from_slice(void_fraction);
    }
}
