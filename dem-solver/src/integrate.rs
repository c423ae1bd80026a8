//! Motion of the grains in a substep.

use interface::HydroRow;
use rayon::prelude::*;

use crate::clumped::Flight;
use crate::engine::{Advance, Arriving, Fastest, Fly, Join, Moved, Rows, Speeds, by_target};
use crate::fault::Fault;
use crate::grains::{AsRows, Motion, Place};
use crate::lanes::{Backend, Row8};
use crate::relaxation::Relaxation;
use crate::scene::{Escape, Scene};
use crate::sleep::{Bed, Quiet, Slumber, Work};
use crate::vector::{Spin, embed, restrict};
use crate::workspace::{ChunkScratch, Impulse, Workspace};
use crate::world::World;

/// Grains that one task flies.
const FLOCK: usize = 8192;

/// Flies all grains for `time` \[s\] at their velocities.
pub fn drift<const D: usize>(world: &mut World<D>, workspace: &mut Workspace<D>, time: f64) {
    let World { grains, contacts, bonds, bodies, .. } = world;
    bonds.fly(time);
    let (backend, frame) = (workspace.backend, contacts.approach.frame);
    let flocks = grains.place.par_chunks_mut(FLOCK).zip(grains.motion.par_chunks(FLOCK));
    let fly = |(places, motions): (&mut [Place], &[Motion])| {
        let (places, motions) = (places.as_rows_mut(), motions.as_rows());
        backend.run(Fly { places, motions, flight: time, frame })
    };
    let fastest = flocks.map(fly).reduce(Fastest::none, |all, of_flock| all.joined(&of_flock));
    let flight = Flight { backend, periods: &workspace.periods, frame, kick: None, time };
    let fastest = fastest.joined(&flight.fly(bodies, grains, &mut workspace.members));
    contacts.approach = fastest.approach();
    contacts.spend(&fastest.approach(), time);
}

/// One chunk at work: it alone writes its grains, their loads and its scratch.
struct Task<'a, const D: usize> {
    first: usize,
    places: &'a mut [Place],
    motions: &'a mut [Motion],
    loads: &'a mut [Row8],
    /// What clumps are to gather of them; empty without clumps.
    gathered: &'a mut [Row8],
    arriving: Vec<Arriving<'a>>,
    scratch: &'a mut ChunkScratch<D>,
    impulses: &'a mut [Impulse<D>],
    work: Work,
    quiet: &'a mut Quiet,
}

/// What the integration reads.
struct Inputs<'a, const D: usize> {
    scene: &'a Scene<D>,
    backend: Backend,
    id: &'a [u64],
    mass: &'a [f64],
    hydro: Option<(&'a [HydroRow], &'a [Relaxation])>,
    step: f64,
    flight: f64,
    frame: [f64; 3],
}

/// Gives the grains the momentum of one substep \[s\], then flies them for `flight` \[s\].
///
/// Positions enter at the middle of the substep, where the forces were found. Over a window of equal substeps
/// this is the central-difference scheme x(½) → v(1) → x(1½) → …, with half a flight at either end
/// (position Verlet): the state between windows is x and v at one instant, and nothing else.
///
/// Loads that chunks put on each other's rows are joined in the order of chunks: the same bits from any number of
/// threads. Members of clumps are first moved as if they were loose, then put where their clumps carry them.
pub fn advance<const D: usize>(
    scene: &Scene<D>,
    world: &mut World<D>,
    workspace: &mut Workspace<D>,
    hydro: Option<&[HydroRow]>,
    step: f64,
    flight: f64,
) {
    let World { grains, contacts, bonds, bodies, .. } = world;
    bonds.fly(flight);
    let Workspace {
        backend,
        chunks: scratches,
        loads,
        relaxation,
        impulse,
        late,
        members,
        periods,
        work,
        survey,
        stale,
        ..
    } = workspace;
    let inputs = Inputs {
        scene,
        backend: *backend,
        id: &grains.id,
        mass: &grains.mass,
        hydro: hydro.map(|rows| (rows, relaxation.as_slice())),
        step,
        flight,
        frame: contacts.approach.frame,
    };
    let (mut places, mut motions) = (grains.place.as_mut_slice(), grains.motion.as_mut_slice());
    let (mut impulses, mut gathered) = (impulse.as_mut_slice(), members.loads.as_mut_slice());
    let mut tasks = Vec::with_capacity(contacts.chunks.len());
    let parts = by_target(&contacts.chunks, loads).into_iter().zip(scratches.iter_mut());
    let sleep = contacts.quiet.iter_mut().zip(work.iter());
    for ((chunk, ((loads, arriving), scratch)), (quiet, &work)) in
        contacts.chunks.iter().zip(parts).zip(sleep)
    {
        let count = chunk.rows.len();
        let (of_places, later_places) = places.split_at_mut(count);
        let (of_motions, later_motions) = motions.split_at_mut(count);
        let (of_impulses, later_impulses) = impulses.split_at_mut(count.min(impulses.len()));
        let (of_clumps, later_gathered) = gathered.split_at_mut(count.min(gathered.len()));
        (places, motions, impulses) = (later_places, later_motions, later_impulses);
        gathered = later_gathered;
        tasks.push(Task {
            first: chunk.rows.start,
            places: of_places,
            motions: of_motions,
            loads,
            gathered: of_clumps,
            arriving,
            scratch,
            impulses: of_impulses,
            work,
            quiet,
        });
    }
    let fastest: Vec<Fastest> = tasks.into_par_iter().map(|task| inputs.advance_chunk(task)).collect();
    if scene.sleep.is_some() {
        *survey = book(scratches, &mut contacts.slumber);
        stale.iter_mut().zip(&contacts.quiet).for_each(|(stale, quiet)| *stale |= !quiet.is_asleep());
    }
    let before = contacts.approach;
    let gravity = embed(&scene.gravity);
    let clumps =
        Flight { backend: *backend, periods, frame: before.frame, kick: Some((gravity, step)), time: flight };
    let of_clumps = clumps.fly(bodies, grains, members);
    let after = fastest.iter().fold(of_clumps, |all, of_chunk| all.joined(of_chunk)).approach();
    contacts.spend(&after, flight);
    // A grain that relaxes to the fluid flies on with some of its velocity before, and catches up.
    contacts.spend(&before, *late * step);
    contacts.spend(&after, *late * step);
    contacts.approach = after;
}

impl<const D: usize> Inputs<'_, D> {
    fn advance_chunk(&self, task: Task<D>) -> Fastest {
        let Task { first, places, motions, loads, gathered, arriving, scratch, impulses, work, quiet } = task;
        for from in arriving {
            match work {
                Work::All => self.backend.run(Join { first, from, to: &mut *loads }),
                Work::ForOthers | Work::Nothing => from.clear(),
            }
        }
        if let Some(bound) = &self.scene.sleep {
            let rows = first..first + motions.len();
            let mut bed = Bed {
                gravity: embed(&self.scene.gravity),
                mass: &self.mass[rows.clone()],
                places,
                motions,
                loads,
                hydro: self
                    .hydro
                    .map(|(fluid, relaxation)| (&fluid[rows.clone()], &relaxation[rows.clone()])),
                impulses,
                scratch,
            };
            if bed.rests(bound, work, quiet, self.step) {
                // All are at rest: two speak for them.
                let motions = &motions.as_rows()[..motions.len().min(2)];
                return self.backend.run(Speeds { motions, frame: self.frame });
            }
        }
        gathered.copy_from_slice(&loads[..gathered.len()]);
        let moved = match self.hydro {
            None => {
                let grains = Rows { places: places.as_rows_mut(), motions: motions.as_rows_mut() };
                let Self { step, flight, frame, .. } = *self;
                let gravity = embed(&self.scene.gravity).into();
                self.backend.run(Advance { grains, loads, gravity, step, flight, frame })
            }
            Some(fluid) => self.advance_in_fluid(first, places, motions, loads, impulses, fluid),
        };
        scratch.frozen_impulse += restrict(&Spin::from(moved.held));
        if !moved.sum.is_finite() {
            let finite =
                |motion: &Motion| (motion.velocity.sum() + motion.angular_velocity.sum()).is_finite();
            let row = motions.iter().position(|motion| !finite(motion)).unwrap_or(0);
            scratch.fault.get_or_insert(Fault::NotFinite { grain: self.id[first + row] });
        }
        if let Some(bound) = &self.scene.sleep {
            *quiet = quiet.after(moved.fastest.speed() < bound.speed, self.step);
        }
        moved.fastest
    }

    fn advance_in_fluid(
        &self,
        first: usize,
        places: &mut [Place],
        motions: &mut [Motion],
        loads: &mut [Row8],
        impulses: &mut [Impulse<D>],
        (hydro, relaxations): (&[HydroRow], &[Relaxation]),
    ) -> Moved {
        let mut moved = Moved::none();
        let grains = places.iter_mut().zip(motions.iter_mut()).zip(loads).zip(impulses).zip(first..);
        for ((((place, motion), load), impulse), row) in grains {
            let Row8([fx, fy, fz, _, tx, ty, tz, _]) = std::mem::take(load);
            let (force, torque) = (Spin::new(fx, fy, fz), Spin::new(tx, ty, tz));
            let before = if motion.is_frozen() { force * self.step } else { Spin::zeros() };
            (0..3).for_each(|axis| moved.held[axis] += before[axis]);
            self.kick((force, torque), row, (&hydro[row], &relaxations[row]), place, motion, impulse);
            moved.sum += motion.velocity.sum() + motion.angular_velocity.sum();
        }
        moved.fastest = self.backend.run(Speeds { motions: motions.as_rows(), frame: self.frame });
        moved
    }

    #[inline]
    fn kick(
        &self,
        (force, torque): (Spin, Spin),
        row: usize,
        (hydro, relaxation): (&HydroRow, &Relaxation),
        place: &mut Place,
        motion: &mut Motion,
        impulse: &mut Impulse<D>,
    ) {
        let step = self.step;
        let beta = hydro.exchange_coefficient;
        let fluid_velocity = flat::<D>(hydro.fluid_velocity);
        if motion.is_frozen() {
            // Its support takes what the grain feels: all other forces hold it against the drag.
            let drag = restrict(&(fluid_velocity * (beta * step)));
            impulse.drag += drag;
            impulse.other -= drag;
            return;
        }
        let others = force + embed(&self.scene.gravity) * self.mass[row] + flat::<D>(hydro.force);
        let before = motion.velocity;
        let pull = others + (fluid_velocity - before) * beta;
        let change = pull * relaxation.gain;
        let mean = before + pull * relaxation.lead;
        motion.velocity += change;
        motion.angular_velocity += (torque + Spin::from(hydro.torque)) * (motion.inverse_inertia * step);
        place.centre += mean * step - before * (0.5 * step) + motion.velocity * (self.flight - 0.5 * step);
        // Two forms of one impulse: each is free of cancellation where it is used.
        let drag = if relaxation.exponent < 1.0 {
            (fluid_velocity - mean) * (beta * step)
        } else {
            change * relaxation.inertia - others * step
        };
        impulse.drag += restrict(&drag);
        impulse.other += restrict(&(others * step));
    }
}

/// Books what was slept in a step, chunk by chunk; tells whether any fell asleep.
fn book<const D: usize>(scratches: &mut [ChunkScratch<D>], slumber: &mut Slumber) -> bool {
    let before = slumber.fallings;
    scratches.iter_mut().for_each(|scratch| *slumber += std::mem::take(&mut scratch.slumber));
    slumber.fallings > before
}

/// The first grain or clump that is nowhere, or has left a domain that it must not leave: looked for once a window.
pub fn misplaced<const D: usize>(scene: &Scene<D>, world: &World<D>) -> Option<Fault> {
    let fault = |centre: &Spin, grain: u64| {
        if !centre.sum().is_finite() {
            Some(Fault::NotFinite { grain })
        } else if scene.escape == Escape::Stop && !scene.domain.holds(&restrict(centre)) {
            Some(Fault::Escaped { grain, at: (*centre).into() })
        } else {
            None
        }
    };
    let World { grains, bodies, .. } = world;
    let rows = grains.place.iter().zip(&grains.motion).zip(&grains.id);
    let mut alone = rows.filter(|((_, motion), _)| !motion.is_carried());
    let of_grains = alone.find_map(|((place, _), &grain)| fault(&place.centre, grain));
    of_grains.or_else(|| bodies.as_slice().iter().find_map(|clump| fault(&clump.body.centre, clump.first)))
}

/// Three components as they come from the coupler; those that the scene does not have are 0.
pub fn flat<const D: usize>(vector: [f64; 3]) -> Spin {
    embed(&restrict::<D>(&Spin::from(vector)))
}
