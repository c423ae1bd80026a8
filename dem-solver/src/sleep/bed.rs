//! A chunk at the moment of the kick, when all loads on its rows are there.

use interface::HydroRow;

use super::bound::SleepBound;
use super::quiet::Quiet;
use super::slumber::Slumber;
use super::work::Work;
use crate::grains::{Motion, Place};
use crate::integrate::flat;
use crate::lanes::Row8;
use crate::relaxation::Relaxation;
use crate::vector::{Spin, restrict};
use crate::workspace::{ChunkScratch, Impulse};

/// What holds a sleeping chunk at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// Sum of all forces on grains that could move \[N\].
    pub asleep: Spin,
    /// Sum of the contact forces on frozen grains \[N\].
    pub frozen: Spin,
}

/// A chunk of grains and what acts on them; all but the scene are those of its rows.
pub struct Bed<'a, const D: usize> {
    /// Gravity \[m/s²\].
    pub gravity: Spin,
    /// Masses \[kg\].
    pub mass: &'a [f64],
    /// Places.
    pub places: &'a [Place],
    /// Motions.
    pub motions: &'a mut [Motion],
    /// Loads of contacts and bonds.
    pub loads: &'a mut [Row8],
    /// The fluid's action, and how grains relax to it.
    pub hydro: Option<(&'a [HydroRow], &'a [Relaxation])>,
    /// What grains received in this window; empty without fluid.
    pub impulses: &'a mut [Impulse<D>],
    /// Scratch of the chunk.
    pub scratch: &'a mut ChunkScratch<D>,
}

impl<const D: usize> Bed<'_, D> {
    /// Lets the chunk fall asleep, or wakes it; whether it rests in this step \[s\], which then is done with.
    pub fn rests(&mut self, bound: &SleepBound, work: Work, quiet: &mut Quiet, step: f64) -> bool {
        let all = self.motions.len() as u64;
        let mut slumber = Slumber::default();
        if !quiet.is_asleep() {
            if quiet.time() < bound.patience() {
                return false;
            }
            if !self.every_mover(|bed, row| bound.lets_sleep(bed.acceleration(row), bed.surface_speed(row))) {
                *quiet = Quiet::default();
                return false;
            }
            slumber.energy = self.stop();
            slumber.fallings = all;
            *quiet = Quiet::ASLEEP;
            self.scratch.held = self.held();
        } else if work == Work::All {
            if !self.every_mover(|bed, row| !bound.wakes(bed.acceleration(row))) {
                self.scratch.slumber.wakings += all;
                *quiet = Quiet::default();
                return false;
            }
            self.scratch.held = self.held();
        }
        slumber.grain_steps = all;
        slumber.grain_steps_without_forces = if work.finds_forces() { 0 } else { all };
        self.scratch.slumber += slumber;
        self.hold(step);
        if work.finds_forces() {
            self.loads.fill(Row8::default());
        }
        true
    }

    fn every_mover(&self, claim: impl Fn(&Self, usize) -> bool) -> bool {
        self.motions.iter().enumerate().all(|(row, motion)| motion.is_frozen() || claim(self, row))
    }

    /// Sum of forces and of torques on a grain.
    fn action(&self, row: usize) -> (Spin, Spin) {
        let Row8([fx, fy, fz, _, tx, ty, tz, _]) = self.loads[row];
        let (mut force, mut torque) = (Spin::new(fx, fy, fz), Spin::new(tx, ty, tz));
        force += self.gravity * self.mass[row];
        if let Some((hydro, _)) = self.hydro {
            let HydroRow { exchange_coefficient, fluid_velocity, force: explicit, .. } = hydro[row];
            let slip = flat::<D>(fluid_velocity) - self.motions[row].velocity;
            force += flat::<D>(explicit) + slip * exchange_coefficient;
            torque += Spin::from(hydro[row].torque);
        }
        (force, torque)
    }

    /// a = |F|/m + r |T|/I \[m/s²\].
    fn acceleration(&self, row: usize) -> f64 {
        let (force, torque) = self.action(row);
        let Motion { inverse_mass, inverse_inertia, .. } = self.motions[row];
        force.norm() * inverse_mass + torque.norm() * inverse_inertia * self.places[row].radius
    }

    /// r ω \[m/s\].
    fn surface_speed(&self, row: usize) -> f64 {
        self.motions[row].angular_velocity.norm() * self.places[row].radius
    }

    /// Takes all motion away; tells the energy \[J\].
    fn stop(&mut self) -> f64 {
        let mut energy = 0.0;
        for (row, motion) in self.motions.iter_mut().enumerate().filter(|(_, motion)| !motion.is_frozen()) {
            energy += motion.kinetic_energy();
            let inertia = self.hydro.map_or(self.mass[row], |(_, relaxation)| relaxation[row].inertia);
            let momentum = restrict::<D>(&motion.velocity) * inertia;
            self.scratch.asleep_impulse -= momentum;
            if let Some(impulse) = self.impulses.get_mut(row) {
                impulse.other -= momentum;
            }
            (motion.velocity, motion.angular_velocity) = (Spin::zeros(), Spin::zeros());
        }
        energy
    }

    fn held(&self) -> Held {
        let mut held = Held::default();
        for (row, motion) in self.motions.iter().enumerate() {
            if motion.is_frozen() {
                let Row8([x, y, z, ..]) = self.loads[row];
                held.frozen += Spin::new(x, y, z);
            } else {
                held.asleep += self.action(row).0;
            }
        }
        held
    }

    /// Books a step \[s\] at rest: all other forces hold what a grain feels of the fluid.
    fn hold(&mut self, step: f64) {
        self.scratch.asleep_impulse -= restrict::<D>(&self.scratch.held.asleep) * step;
        self.scratch.frozen_impulse += restrict::<D>(&self.scratch.held.frozen) * step;
        let Some((hydro, _)) = self.hydro else { return };
        for (impulse, hydro) in self.impulses.iter_mut().zip(hydro) {
            let drag = restrict(&(flat::<D>(hydro.fluid_velocity) * (hydro.exchange_coefficient * step)));
            impulse.drag += drag;
            impulse.other -= drag;
        }
    }
}
