//! Motion of the grains in a substep.

use interface::HydroRow;
use rayon::prelude::*;

use crate::contact::{CHUNK, Chunk, Incoming, Load};
use crate::fault::Fault;
use crate::grains::{Motion, Place};
use crate::relaxation::Relaxation;
use crate::scene::{Escape, Scene};
use crate::vector::{Spin, Vector, embed, restrict};
use crate::workspace::{ChunkScratch, Impulse, Workspace};
use crate::world::World;

/// Smallest box around the displacements of grains since the neighbour list was built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacement<const D: usize> {
    lower: Vector<D>,
    upper: Vector<D>,
}

impl<const D: usize> Displacement<D> {
    /// Of no grain.
    pub fn none() -> Self {
        Self { lower: Vector::from_element(f64::INFINITY), upper: Vector::from_element(f64::NEG_INFINITY) }
    }

    /// Of walls, which stay.
    pub fn of_rest() -> Self {
        Self { lower: Vector::zeros(), upper: Vector::zeros() }
    }

    #[inline]
    fn add(&mut self, displacement: &Vector<D>) {
        self.lower = self.lower.inf(displacement);
        self.upper = self.upper.sup(displacement);
    }

    /// Around both.
    pub fn joined(&self, other: &Self) -> Self {
        Self { lower: self.lower.inf(&other.lower), upper: self.upper.sup(&other.upper) }
    }

    /// No two bodies came nearer by more than this \[m\]; a motion that all share does not count.
    pub fn largest_approach(&self) -> f64 {
        if self.lower[0] > self.upper[0] { 0.0 } else { (self.upper - self.lower).norm() }
    }
}

/// Flies all grains for `time` \[s\] at their velocities.
pub fn drift<const D: usize>(world: &mut World<D>, workspace: &mut Workspace<D>, time: f64) {
    let World { grains, contacts, .. } = world;
    let (motion, reference) = (&grains.motion, &contacts.reference);
    let chunks = grains.place.par_chunks_mut(CHUNK).zip(&mut workspace.chunks).enumerate();
    chunks.for_each(|(index, (places, scratch))| {
        scratch.displacement = Displacement::none();
        for (place, row) in places.iter_mut().zip(index * CHUNK..) {
            place.centre += motion[row].velocity * time;
            if let Some(reference) = reference.get(row) {
                scratch.displacement.add(&(place.centre - reference));
            }
        }
    });
}

/// What the integration of a chunk reads.
struct Inputs<'a, const D: usize> {
    scene: &'a Scene<D>,
    id: &'a [u64],
    mass: &'a [f64],
    reference: &'a [Vector<D>],
    loads: &'a [Vec<Load<D>>],
    contacts: &'a [Chunk<D>],
    incoming: &'a [Vec<Incoming>],
    hydro: Option<(&'a [HydroRow], &'a [Relaxation])>,
    step: f64,
    flight: f64,
}

/// Gives the grains the momentum of one substep \[s\], then flies them for `flight` \[s\].
///
/// Positions enter at the middle of the substep, where the forces were found. Over a window of equal substeps
/// this is the central-difference scheme x(½) → v(1) → x(1½) → …, with half a flight at either end
/// (position Verlet): the state between windows is x and v at one instant, and nothing else.
pub fn advance<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    hydro: Option<&[HydroRow]>,
    step: f64,
    flight: f64,
) {
    let World { grains, contacts, .. } = world;
    let Workspace { chunks: scratches, loads, relaxation, impulse, .. } = workspace;
    let inputs = Inputs {
        scene,
        id: &grains.id,
        mass: &grains.mass,
        reference: &contacts.reference,
        loads,
        contacts: &contacts.chunks,
        incoming: &contacts.incoming,
        hydro: hydro.map(|rows| (rows, relaxation.as_slice())),
        step,
        flight,
    };
    let rows = grains.place.par_chunks_mut(CHUNK).zip(grains.motion.par_chunks_mut(CHUNK));
    let chunks = rows.zip(scratches).enumerate();
    if hydro.is_some() {
        chunks.zip(impulse.par_chunks_mut(CHUNK)).for_each(
            |((index, ((places, motions), scratch)), impulses)| {
                inputs.advance_chunk(index, places, motions, scratch, impulses);
            },
        );
    } else {
        chunks.for_each(|(index, ((places, motions), scratch))| {
            inputs.advance_chunk(index, places, motions, scratch, &mut []);
        });
    }
}

impl<const D: usize> Inputs<'_, D> {
    fn advance_chunk(
        &self,
        index: usize,
        places: &mut [Place<D>],
        motions: &mut [Motion<D>],
        scratch: &mut ChunkScratch<D>,
        impulses: &mut [Impulse<D>],
    ) {
        self.join_loads(index, places.len(), &mut scratch.total);
        scratch.displacement = Displacement::none();
        for (k, (place, motion)) in places.iter_mut().zip(motions).enumerate() {
            let row = index * CHUNK + k;
            let load = scratch.total[k];
            if motion.is_frozen() {
                scratch.frozen_impulse += load.force * self.step;
            }
            match self.hydro {
                None => self.kick(load, place, motion),
                Some((rows, relaxations)) => {
                    let fluid = (&rows[row], &relaxations[row]);
                    self.kick_in_fluid(row, load, fluid, place, motion, &mut impulses[k]);
                }
            }
            if let Some(reference) = self.reference.get(row) {
                scratch.displacement.add(&(place.centre - reference));
            }
            self.inspect(row, place, motion, &mut scratch.fault);
        }
    }

    /// Loads of the chunk's own pairs, then those that earlier chunks put on its rows, in their order.
    fn join_loads(&self, index: usize, rows: usize, total: &mut Vec<Load<D>>) {
        total.clear();
        total.extend_from_slice(&self.loads[index][..rows]);
        for part in self.incoming.get(index).into_iter().flatten() {
            let source = part.source as usize;
            let overhang = &self.loads[source][CHUNK..];
            let range = part.begin as usize..part.end as usize;
            for (&row, &load) in self.contacts[source].overhang[range.clone()].iter().zip(&overhang[range]) {
                total[row as usize - index * CHUNK] += load;
            }
        }
    }

    #[inline]
    fn kick(&self, load: Load<D>, place: &mut Place<D>, motion: &mut Motion<D>) {
        if !motion.is_frozen() {
            motion.velocity += (load.force * motion.inverse_mass + self.scene.gravity) * self.step;
            motion.angular_velocity += load.torque * (motion.inverse_inertia * self.step);
            place.centre += motion.velocity * self.flight;
        }
    }

    #[inline]
    fn kick_in_fluid(
        &self,
        row: usize,
        load: Load<D>,
        (hydro, relaxation): (&HydroRow, &Relaxation),
        place: &mut Place<D>,
        motion: &mut Motion<D>,
        impulse: &mut Impulse<D>,
    ) {
        let step = self.step;
        let beta = hydro.exchange_coefficient;
        let fluid_velocity: Vector<D> = restrict(&Spin::from(hydro.fluid_velocity));
        if motion.is_frozen() {
            // Its support takes what the grain feels: all other forces hold it against the drag.
            let drag = fluid_velocity * (beta * step);
            impulse.drag += drag;
            impulse.other -= drag;
            return;
        }
        let explicit: Vector<D> = restrict(&Spin::from(hydro.force));
        let others = load.force + self.scene.gravity * self.mass[row] + explicit;
        let before = motion.velocity;
        let pull = others + (fluid_velocity - before) * beta;
        let change = pull * relaxation.gain;
        let mean = before + pull * relaxation.lead;
        motion.velocity += change;
        motion.angular_velocity += (load.torque + Spin::from(hydro.torque)) * (motion.inverse_inertia * step);
        place.centre += mean * step - before * (0.5 * step) + motion.velocity * (self.flight - 0.5 * step);
        // Two forms of one impulse: each is free of cancellation where it is used.
        impulse.drag += if relaxation.exponent < 1.0 {
            (fluid_velocity - mean) * (beta * step)
        } else {
            change * relaxation.inertia - others * step
        };
        impulse.other += others * step;
    }

    #[inline]
    fn inspect(&self, row: usize, place: &Place<D>, motion: &Motion<D>, fault: &mut Option<Fault>) {
        let grain = self.id[row];
        // A sum is finite only if every term is.
        if !(motion.velocity.sum() + motion.angular_velocity.sum() + place.centre.sum()).is_finite() {
            fault.get_or_insert(Fault::NotFinite { grain });
        } else if self.scene.escape == Escape::Stop && !self.scene.domain.holds(&place.centre) {
            fault.get_or_insert(Fault::Escaped { grain, at: embed(&place.centre).into() });
        }
    }
}
