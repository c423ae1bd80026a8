//! The exchange between grains and fluid: the laws applied to the rows of a window, and what is owed between sides.

use crate::acceleration::Acceleration;
use crate::convergence::{Change, ForceResidual};
use crate::error::CouplerError;
use crate::interaction::{Interaction, Passage, Shape};
use crate::owed::Owed;
use interface::frames::{GrainRow, HydroRow, ImpulseRow, ReactionRow, SampleRow};
use interface::ledger::Vector;
use std::array::from_fn;

/// Rows of the open window. All vectors have one entry per grain, in the order of the frames.
#[derive(Default)]
pub struct Exchange {
    /// Grains when the window opened.
    before: Vec<GrainRow>,
    /// The fluid as it is felt in this iteration.
    felt: Vec<SampleRow>,
    /// What the fluid does to the grains.
    pub hydro: Vec<HydroRow>,
    /// The same in the iteration before.
    last_hydro: Vec<HydroRow>,
    /// What the grains do to the fluid.
    pub reactions: Vec<ReactionRow>,
    /// Impulse owed to each grain from earlier windows, paid in this one.
    owed: Vec<Vector>,
    /// Impulse that each grain received from the fluid, what was owed included.
    received: Vec<Vector>,
    /// Relaxed quantity and its residual.
    relaxed: Vec<f64>,
    residual: Vec<f64>,
}

/// Sums over all grains of what crossed in a window \[N s\].
#[derive(Clone, Copy, Debug, Default)]
pub struct Crossed {
    /// Given by the fluid's equations.
    pub given: Vector,
    /// Received by the grains.
    pub received: Vector,
}

impl Exchange {
    /// Keeps the grains of the opening.
    pub fn open(&mut self, grains: &[GrainRow]) {
        self.before.clear();
        self.before.extend_from_slice(grains);
    }

    /// Evaluates the laws at the newest samples, with the newest velocities of the grains. From the second iteration
    /// on, the change of force is relaxed.
    ///
    /// # Errors
    /// A law's input out of range (which grain).
    pub fn evaluate(
        &mut self,
        interaction: &Interaction,
        (grains, samples): (&[GrainRow], &[SampleRow]),
        owed: &Owed,
        step: f64,
        relaxation: Option<&mut Acceleration>,
    ) -> Result<(), CouplerError> {
        self.felt.clear();
        self.felt.extend_from_slice(samples);
        std::mem::swap(&mut self.hydro, &mut self.last_hydro);
        self.hydro.clear();
        self.owed.clear();
        self.owed.extend_from_slice(owed.impulses());
        for (row, ((before, now), sample)) in self.before.iter().zip(grains).zip(samples).enumerate() {
            let grain = GrainRow { velocity: now.velocity, ..*before };
            self.hydro.push(interaction.evaluate(&grain, sample, owed.impulses()[row], step)?);
        }
        if let Some(relaxation) = relaxation {
            self.relax(relaxation);
        }
        Ok(())
    }

    /// x ← x + ω r on the force F + βu_f that the fluid's fields exert, r the plain change.
    fn relax(&mut self, relaxation: &mut Acceleration) {
        self.relaxed.clear();
        self.residual.clear();
        for (old, new) in self.last_hydro.iter().zip(&self.hydro) {
            for k in 0..3 {
                let felt = |row: &HydroRow| row.force[k] + new.exchange_coefficient * row.fluid_velocity[k];
                self.relaxed.push(felt(old));
                self.residual.push(felt(new) - felt(old));
            }
        }
        let factor = relaxation.relax(&mut self.relaxed, &self.residual);
        for (old, new) in self.last_hydro.iter().zip(&mut self.hydro) {
            let mixed = |old: Vector, new: Vector| from_fn(|k| old[k] + factor * (new[k] - old[k]));
            new.force = mixed(old.force, new.force);
            new.fluid_velocity = mixed(old.fluid_velocity, new.fluid_velocity);
        }
    }

    /// The reactions, now that the grains have moved; and what the grains have received.
    pub fn react(
        &mut self,
        grains: &[GrainRow],
        impulses: &[ImpulseRow],
        step: f64,
        reaction: impl Fn(&Passage<'_>) -> ReactionRow,
    ) {
        self.reactions.clear();
        self.received.clear();
        for (row, before) in self.before.iter().enumerate() {
            let (sample, hydro) = (&self.felt[row], &self.hydro[row]);
            let impulse = &impulses[row];
            let passage = Passage { before, after: &grains[row], sample, hydro, impulse };
            // Outside the fluid nothing is exchanged.
            let is_inside = sample.density > 0.0;
            self.reactions.push(if is_inside { reaction(&passage) } else { ReactionRow::default() });
            let change: Vector = from_fn(|k| grains[row].velocity[k] - before.velocity[k]);
            self.received
                .push(from_fn(|k| impulse.drag[k] + hydro.force[k] * step - hydro.added_mass * change[k]));
        }
    }

    /// Impulse that the fluid's equations give to the grain of a row by drag and stress, at these samples \[N s\].
    fn given(&self, row: usize, sample: &SampleRow, shape: Shape, step: f64) -> Vector {
        // A grain that has left the fluid has exchanged nothing with it in this window.
        if sample.density == 0.0 {
            return [0.0; 3];
        }
        let volume = sample.wetted_fraction * shape.volume(self.before[row].radius);
        let reaction = &self.reactions[row];
        from_fn(|k| {
            let drag = reaction.exchange_coefficient * (sample.velocity[k] - reaction.target_velocity[k]);
            let stress = volume * (sample.viscous_stress_divergence[k] - sample.pressure_gradient[k]);
            (drag + sample.relayed_force[k] + stress) * step
        })
    }

    /// Books the window. What the fluid gave without its grain receiving it is owed to the grain from now on; what was owed
    /// before is paid.
    pub fn settle(&self, samples: &[SampleRow], shape: Shape, step: f64, owed: &mut Owed) -> Crossed {
        let mut crossed = Crossed::default();
        for (row, sample) in samples.iter().enumerate() {
            let (given, received) = (self.given(row, sample, shape, step), self.received[row]);
            owed.add(row, from_fn(|k| given[k] - received[k]));
            for k in 0..3 {
                crossed.given[k] += given[k];
                crossed.received[k] += received[k];
            }
        }
        crossed
    }

    /// The change of the forces in this iteration: what the fluid gives by its newest samples against what the grains
    /// received.
    pub fn force_change(&self, samples: &[SampleRow], shape: Shape, step: f64) -> Change {
        let force = |impulse: Vector| impulse.map(|component| component / step);
        let given: Vec<Vector> = samples
            .iter()
            .enumerate()
            .map(|(row, sample)| force(self.given(row, sample, shape, step)))
            .collect();
        let net = |(received, owed): (&Vector, &Vector)| force(from_fn(|k| received[k] - owed[k]));
        let received: Vec<Vector> = self.received.iter().zip(&self.owed).map(net).collect();
        ForceResidual::change(&received, &given)
    }
}
