//! The world on disk: all of it, so that a resumed run gives the same bits.

use std::collections::HashSet;
use std::path::Path;

use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use serde::{Deserialize, Serialize};

use crate::body::{Bodies, BodyArrays, Rigid};
use crate::bond::{BondArrays, Bonds};
use crate::deletion::Taken;
use crate::engine::{Approach, ContactArrays, ContactList, Counters, Skins};
use crate::error::DemError;
use crate::grains::{AsRows, CARRIED_INERTIA, Grains, Motion, Place, inertia};
use crate::insertion::{Feed, Random};
use crate::scene::Scene;
use crate::sleep::Slumber;
use crate::vector::{Spin, Vector};
use crate::wall::{Received, Slide, WallImpulse};
use crate::world::World;

const KIND: &str = "dem-solver";
/// What moves a grain: itself, nothing, its clump.
const LOOSE: u8 = 0;
const FROZEN: u8 = 1;
const CARRIED: u8 = 2;

#[derive(Serialize, Deserialize)]
struct Metadata {
    dimension: usize,
    time: f64,
    born: u64,
    removed: u64,
    taken: Vec<(u64, f64)>,
    walls_since: f64,
    slides: Vec<[f64; 3]>,
    rows: u64,
    spring_width: u64,
    skins: [f64; 3],
    spent: [f64; 3],
    approach: [f64; 5],
    walls_time: f64,
    built_since_order: u32,
    counters: [u64; 3],
    slumber: ([u64; 4], f64),
    since_pull: f64,
    broken: [u64; 3],
    feeds: Vec<FeedState>,
}

#[derive(Serialize, Deserialize)]
struct FeedState {
    name: String,
    random: [u64; 4],
    fed: f64,
    count: u64,
    refused: u64,
    waiting: Option<f64>,
}

impl<const D: usize> World<D> {
    /// Writes the world to a file.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write_checkpoint(&self, path: &Path) -> Result<(), DemError> {
        let Self { grains, contacts, .. } = self;
        let ContactList { skins, spent, approach, counters, slumber, .. } = contacts;
        let Slumber { fallings, wakings, grain_steps, grain_steps_without_forces, energy } = *slumber;
        let [fx, fy, fz] = approach.frame;
        let arrays = ContactArrays::of(contacts);
        let bonds = BondArrays::of(&self.bonds);
        let bodies = BodyArrays::of(&self.bodies);
        let metadata = Metadata {
            dimension: D,
            time: self.time,
            born: self.born,
            removed: self.removed,
            taken: self.taken.iter().map(|taken| (taken.count, taken.mass)).collect(),
            slides: self.slides.iter().map(|s| [s.displacement, s.velocity, s.listed]).collect(),
            walls_since: self.received.since,
            rows: arrays.rows,
            spring_width: arrays.width,
            skins: [skins.outer, skins.inner, skins.walls],
            spent: [spent.outer, spent.inner, spent.walls],
            approach: [approach.between_grains, approach.to_walls, fx, fy, fz],
            walls_time: contacts.walls_time,
            built_since_order: contacts.built_since_order,
            counters: [counters.outer, counters.inner, counters.walls],
            slumber: ([fallings, wakings, grain_steps, grain_steps_without_forces], energy),
            since_pull: bonds.elapsed,
            broken: bonds.broken,
            feeds: self.feeds.iter().map(FeedState::of).collect(),
        };
        let place: Vec<f64> = grains.place.as_rows().iter().flat_map(|row| row.0).collect();
        let motion: Vec<f64> =
            grains.motion.iter().flat_map(|m| floats(&m.velocity, m.angular_velocity.into())).collect();
        let hold = |motion: &Motion| match (motion.is_frozen(), motion.is_carried()) {
            (true, _) => FROZEN,
            (_, true) => CARRIED,
            _ => LOOSE,
        };
        let held: Vec<u8> = grains.motion.iter().map(hold).collect();
        let received: Vec<f64> =
            self.received.impulse.iter().flat_map(|wall| floats(&wall.linear, wall.angular.into())).collect();
        CheckpointWriter::new(KIND, &metadata)
            .array("id", &grains.id)
            .array("place", &place)
            .array("motion", &motion)
            .array("mass", &grains.mass)
            .array("material", &grains.material)
            .array("held", &held)
            .array("outer pairs", &arrays.outer)
            .array("inner pairs", &arrays.inner)
            .array("springs", &arrays.springs)
            .array("remembered", &arrays.remembered)
            .array("remembered springs", &arrays.remembered_springs)
            .array("near planes", &arrays.near_planes)
            .array("plane springs", &arrays.plane_springs)
            .array("on planes", &arrays.on_planes)
            .array("springs on planes", &arrays.on_planes_springs)
            .array("near walls", &arrays.near_walls)
            .array("on walls", &arrays.on_walls)
            .array("wall springs", &arrays.wall_springs)
            .array("quiet time of chunks", &arrays.quiet)
            .array("bonded grains", &bonds.grains)
            .array("bond laws", &bonds.laws)
            .array("bond numbers", &bonds.numbers)
            .array("bond failures", &bonds.failures)
            .array("clumps", &bodies.firsts)
            .array("kinds of clumps", &bodies.kinds)
            .array("motion of clumps", &bodies.motions)
            .array("received", &received)
            .write(path)?;
        Ok(())
    }

    /// Reads a world of this scene from a file; `feeds` are those of the case, which go on where they were.
    ///
    /// # Errors
    /// The file cannot be read, is damaged, or belongs to another case.
    pub fn read_checkpoint(path: &Path, scene: &Scene<D>, feeds: Vec<Feed<D>>) -> Result<Self, DemError> {
        let file = Checkpoint::read(path, KIND)?;
        let metadata: Metadata = file.metadata()?;
        let foreign = |what: &'static str| DemError::ForeignCheckpoint { path: path.into(), what };
        if metadata.dimension != D {
            return Err(foreign("it is of another dimension"));
        }
        let grains = read_grains(&file, scene)?.ok_or_else(|| foreign("its grains are incomplete"))?;
        if grains.material.iter().any(|&material| material as usize >= scene.materials.len()) {
            return Err(foreign("a grain is of a material that the case does not have"));
        }
        let contacts = read_contacts(&file, &metadata)?.restore(scene, &grains, list(&metadata));
        let contacts = contacts.ok_or_else(|| foreign("its contacts do not fit the grains and walls"))?;
        let bonds = read_bonds(&file, &metadata)?.filter(|bonds| fit(bonds, scene, &grains));
        let bonds = bonds.ok_or_else(|| foreign("its bonds do not fit the grains and laws"))?;
        let arrays = BodyArrays {
            firsts: file.array("clumps")?,
            kinds: file.array("kinds of clumps")?,
            motions: file.array("motion of clumps")?,
        };
        let bodies = arrays.restore(&scene.clumps).filter(|bodies| carry(bodies, &grains));
        let bodies = bodies.ok_or_else(|| foreign("its clumps do not fit the grains and kinds"))?;
        let feeds = resume(feeds, metadata.feeds).ok_or_else(|| foreign("its insertions are others"))?;
        let impulse = file.array::<f64>("received")?;
        let impulse = impulse.chunks_exact(D + 3).map(|row| WallImpulse {
            linear: Vector::from_column_slice(&row[..D]),
            angular: Spin::from_column_slice(&row[D..]),
        });
        let Metadata { time, walls_since, slides, born, removed, taken, .. } = metadata;
        let slides = slides
            .into_iter()
            .map(|[displacement, velocity, listed]| Slide { displacement, velocity, listed })
            .collect();
        let taken = taken.into_iter().map(|(count, mass)| Taken { count, mass }).collect();
        let received = Received { since: walls_since, impulse: impulse.collect() };
        Ok(Self { time, grains, bodies, contacts, bonds, slides, received, born, removed, taken, feeds })
    }
}

impl FeedState {
    fn of<const D: usize>(feed: &Feed<D>) -> Self {
        Self {
            name: feed.batch.name.clone(),
            random: feed.random.state(),
            fed: feed.fed,
            count: feed.count,
            refused: feed.refused,
            waiting: feed.waiting,
        }
    }
}

fn resume<const D: usize>(feeds: Vec<Feed<D>>, states: Vec<FeedState>) -> Option<Vec<Feed<D>>> {
    let names = feeds.iter().map(|feed| &feed.batch.name);
    if !names.eq(states.iter().map(|state| &state.name)) {
        return None;
    }
    let resumed = feeds.into_iter().zip(states).map(|(feed, state)| {
        let FeedState { fed, count, refused, waiting, .. } = state;
        Feed { random: Random::resume(state.random), fed, count, refused, waiting, ..feed }
    });
    Some(resumed.collect())
}

fn read_grains<const D: usize>(file: &Checkpoint, scene: &Scene<D>) -> Result<Option<Grains>, DemError> {
    let (place, motion, held) =
        (file.array::<f64>("place")?, file.array::<f64>("motion")?, file.array::<u8>("held")?);
    let (id, mass, material) =
        (file.array::<u64>("id")?, file.array::<f64>("mass")?, file.array::<u32>("material")?);
    let lengths = [place.len() / 4, motion.len() / 6, held.len(), mass.len(), material.len()];
    if lengths.iter().any(|&length| length != id.len()) {
        return Ok(None);
    }
    let place: Vec<_> =
        place.chunks_exact(4).map(|row| Place { centre: spin(row), radius: row[3] }).collect();
    // A material that the case does not have is refused by the caller.
    let micro =
        |material: u32| (material as usize) < scene.materials.len() && scene.materials.is_micro(material);
    let motion = motion.chunks_exact(6).enumerate().map(|(k, row)| {
        let inverse_inertia = match held[k] {
            FROZEN => return Motion::frozen(),
            CARRIED => CARRIED_INERTIA,
            _ if micro(material[k]) => 0.0,
            _ => 1.0 / inertia::<D>(mass[k], place[k].radius),
        };
        Motion {
            velocity: spin(row),
            inverse_mass: 1.0 / mass[k],
            angular_velocity: spin(&row[3..]),
            inverse_inertia,
        }
    });
    Ok(Some(Grains { motion: motion.collect(), id, place, mass, material }))
}

fn read_contacts(file: &Checkpoint, metadata: &Metadata) -> Result<ContactArrays, DemError> {
    Ok(ContactArrays {
        rows: metadata.rows,
        width: metadata.spring_width,
        outer: file.array("outer pairs")?,
        inner: file.array("inner pairs")?,
        springs: file.array("springs")?,
        remembered: file.array("remembered")?,
        remembered_springs: file.array("remembered springs")?,
        near_planes: file.array("near planes")?,
        plane_springs: file.array("plane springs")?,
        on_planes: file.array("on planes")?,
        on_planes_springs: file.array("springs on planes")?,
        near_walls: file.array("near walls")?,
        on_walls: file.array("on walls")?,
        wall_springs: file.array("wall springs")?,
        quiet: file.array("quiet time of chunks")?,
    })
}

fn read_bonds(file: &Checkpoint, metadata: &Metadata) -> Result<Option<Bonds>, DemError> {
    let arrays = BondArrays {
        elapsed: metadata.since_pull,
        broken: metadata.broken,
        grains: file.array("bonded grains")?,
        laws: file.array("bond laws")?,
        numbers: file.array("bond numbers")?,
        failures: file.array("bond failures")?,
    };
    Ok(arrays.restore()?)
}

/// Whether each bond has its grains and its law.
fn fit<const D: usize>(bonds: &Bonds, scene: &Scene<D>, grains: &Grains) -> bool {
    let known: HashSet<u64> = grains.id.iter().copied().collect();
    let laws = scene.bond_laws.len();
    bonds.iter().all(|bond| (bond.law as usize) < laws && bond.grains.iter().all(|id| known.contains(id)))
}

/// Whether the members of all clumps, and they alone, are carried.
fn carry(bodies: &Bodies, grains: &Grains) -> bool {
    let members: usize = bodies.as_slice().iter().map(Rigid::count).sum();
    let carried = |(motion, id): (&Motion, &u64)| motion.is_carried() == bodies.of(*id).is_some();
    let there = grains.id.iter().filter(|id| bodies.of(**id).is_some()).count();
    there == members && grains.motion.iter().zip(&grains.id).all(carried)
}

/// What the lists know beside their pairs.
fn list(metadata: &Metadata) -> ContactList {
    let skins = |[outer, inner, walls]: [f64; 3]| Skins { outer, inner, walls };
    let [between_grains, to_walls, fx, fy, fz] = metadata.approach;
    let [outer, inner, walls] = metadata.counters;
    let ([fallings, wakings, grain_steps, grain_steps_without_forces], energy) = metadata.slumber;
    ContactList {
        skins: skins(metadata.skins),
        spent: skins(metadata.spent),
        approach: Approach { between_grains, to_walls, frame: [fx, fy, fz] },
        walls_time: metadata.walls_time,
        built_since_order: metadata.built_since_order,
        counters: Counters { outer, inner, walls },
        slumber: Slumber { fallings, wakings, grain_steps, grain_steps_without_forces, energy },
        ..ContactList::new()
    }
}

fn floats<const D: usize, const N: usize>(
    vector: &Vector<D>,
    more: [f64; N],
) -> impl Iterator<Item = f64> + use<D, N> {
    vector.data.0.into_iter().flatten().chain(more)
}

fn spin(row: &[f64]) -> Spin {
    Spin::new(row[0], row[1], row[2])
}
