//! The world on disk: all of it, so that a resumed run gives the same bits.

use std::path::Path;

use case_io::checkpoint::{Checkpoint, CheckpointWriter};
use serde::{Deserialize, Serialize};

use crate::contact::{CHUNK, Chunk, ContactList, Pair, Remembered, Spring, WallContact, chunk_count};
use crate::domain::Image;
use crate::error::DemError;
use crate::grains::{Grains, Motion, Place, inertia};
use crate::insertion::{Feed, Random};
use crate::scene::Scene;
use crate::search::{candidate, complete, incoming};
use crate::vector::{Spin, Vector};
use crate::wall::{Received, WallImpulse};
use crate::world::World;

const KIND: &str = "dem-solver";

#[derive(Serialize, Deserialize)]
struct Metadata {
    dimension: usize,
    time: f64,
    born: u64,
    removed: u64,
    list_time: f64,
    walls_since: f64,
    skin: f64,
    valid: bool,
    built_since_order: u32,
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
        let metadata = Metadata {
            dimension: D,
            time: self.time,
            born: self.born,
            removed: self.removed,
            list_time: self.list_time,
            walls_since: self.received.since,
            skin: contacts.skin,
            valid: contacts.valid,
            built_since_order: contacts.built_since_order,
            feeds: self.feeds.iter().map(FeedState::of).collect(),
        };
        let place: Vec<f64> = grains.place.iter().flat_map(|p| floats(&p.centre, [p.radius])).collect();
        let motion: Vec<f64> =
            grains.motion.iter().flat_map(|m| floats(&m.velocity, m.angular_velocity.into())).collect();
        let frozen: Vec<u8> = grains.motion.iter().map(|motion| u8::from(motion.is_frozen())).collect();
        let reference: Vec<f64> = contacts.reference.iter().flat_map(|x| floats(x, [])).collect();
        let chunks = || contacts.chunks.iter();
        let pairs: Vec<u32> = chunks().flat_map(|c| &c.pairs).flat_map(|p| [p.i, p.j, p.image.0]).collect();
        let springs: Vec<f64> = chunks().flat_map(|c| &c.springs).flat_map(spring_floats).collect();
        let near_walls: Vec<u32> =
            chunks().flat_map(|c| &c.candidates).flat_map(|c| [c.grain, c.surface, c.image.0]).collect();
        let on_walls: Vec<u32> =
            chunks().flat_map(|c| &c.wall_contacts).flat_map(|c| [c.grain, c.wall]).collect();
        let wall_springs: Vec<f64> = chunks()
            .flat_map(|c| &c.wall_contacts)
            .flat_map(|c| floats(&c.normal, []).chain(spring_floats(&c.spring)))
            .collect();
        let remembered: Vec<u32> = chunks().flat_map(|c| &c.remembered).flat_map(|r| [r.i, r.j]).collect();
        let remembered_springs: Vec<f64> =
            chunks().flat_map(|c| &c.remembered).flat_map(|r| spring_floats(&r.spring)).collect();
        let received: Vec<f64> =
            self.received.impulse.iter().flat_map(|wall| floats(&wall.linear, wall.angular.into())).collect();
        CheckpointWriter::new(KIND, &metadata)
            .array("id", &grains.id)
            .array("place", &place)
            .array("motion", &motion)
            .array("mass", &grains.mass)
            .array("material", &grains.material)
            .array("frozen", &frozen)
            .array("reference", &reference)
            .array("pairs", &pairs)
            .array("springs", &springs)
            .array("near walls", &near_walls)
            .array("on walls", &on_walls)
            .array("wall springs", &wall_springs)
            .array("remembered", &remembered)
            .array("remembered springs", &remembered_springs)
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
        let grains = read_grains(&file)?.ok_or_else(|| foreign("its grains are incomplete"))?;
        if grains.material.iter().any(|&material| material as usize >= scene.materials.len()) {
            return Err(foreign("a grain is of a material that the case does not have"));
        }
        let contacts = read_contacts(&file, &metadata, scene, &grains)?;
        let contacts = contacts.ok_or_else(|| foreign("its contacts do not fit the grains and walls"))?;
        let feeds = resume(feeds, metadata.feeds).ok_or_else(|| foreign("its insertions are others"))?;
        let impulse = file.array::<f64>("received")?;
        let impulse = impulse
            .chunks_exact(D + 3)
            .map(|row| WallImpulse { linear: vector(row), angular: Spin::from_column_slice(&row[D..]) });
        let Metadata { time, list_time, walls_since, born, removed, .. } = metadata;
        let received = Received { since: walls_since, impulse: impulse.collect() };
        Ok(Self { time, grains, contacts, list_time, received, born, removed, feeds })
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

fn read_grains<const D: usize>(file: &Checkpoint) -> Result<Option<Grains<D>>, DemError> {
    let (place, motion, frozen) =
        (file.array::<f64>("place")?, file.array::<f64>("motion")?, file.array::<u8>("frozen")?);
    let (id, mass, material) =
        (file.array::<u64>("id")?, file.array::<f64>("mass")?, file.array::<u32>("material")?);
    let lengths = [place.len() / (D + 1), motion.len() / (D + 3), frozen.len(), mass.len(), material.len()];
    if lengths.iter().any(|&length| length != id.len()) {
        return Ok(None);
    }
    let place: Vec<_> =
        place.chunks_exact(D + 1).map(|row| Place { centre: vector(row), radius: row[D] }).collect();
    let motion = motion.chunks_exact(D + 3).enumerate().map(|(k, row)| {
        if frozen[k] != 0 {
            return Motion::frozen();
        }
        Motion {
            velocity: vector(row),
            inverse_mass: 1.0 / mass[k],
            angular_velocity: Spin::from_column_slice(&row[D..]),
            inverse_inertia: 1.0 / inertia::<D>(mass[k], place[k].radius),
        }
    });
    Ok(Some(Grains { motion: motion.collect(), id, place, mass, material }))
}

fn read_contacts<const D: usize>(
    file: &Checkpoint,
    metadata: &Metadata,
    scene: &Scene<D>,
    grains: &Grains<D>,
) -> Result<Option<ContactList<D>>, DemError> {
    let (pairs, springs) = (file.array::<u32>("pairs")?, file.array::<f64>("springs")?);
    let (remembered, kept) = (file.array::<u32>("remembered")?, file.array::<f64>("remembered springs")?);
    let (on_walls, wall_springs) = (file.array::<u32>("on walls")?, file.array::<f64>("wall springs")?);
    let near_walls = file.array::<u32>("near walls")?;
    let reference = file.array::<f64>("reference")?;
    let (rows, images) = (grains.len() as u32, scene.shifts.len() as u32);
    let (surfaces, walls) = (scene.walls.surfaces.len() as u32, scene.walls.len() as u32);
    let fits = pairs.chunks(3).all(|p| p[0] < p[1] && p[1] < rows && p[2] < images)
        && (springs.is_empty() || springs.len() == pairs.len() / 3 * (D + 1))
        && remembered.chunks(2).all(|p| p[0] < p[1] && p[1] < rows)
        && kept.len() == remembered.len() / 2 * (D + 1)
        && near_walls.chunks(3).all(|c| c[0] < rows && c[1] < surfaces && c[2] < images)
        && on_walls.chunks(2).all(|c| c[0] < rows && c[1] < walls)
        && wall_springs.len() == on_walls.len() / 2 * (2 * D + 1);
    if !fits {
        return Ok(None);
    }
    let mut chunks = vec![Chunk::new(); chunk_count(grains.len())];
    for (k, p) in pairs.chunks(3).enumerate() {
        let chunk = &mut chunks[p[0] as usize / CHUNK];
        chunk.pairs.push(Pair { i: p[0], j: p[1], slot: 0, image: Image(p[2]) });
        chunk.springs.extend(springs.chunks(D + 1).nth(k).map(spring));
    }
    for (p, row) in remembered.chunks(2).zip(kept.chunks(D + 1)) {
        chunks[p[0] as usize / CHUNK].remembered.push(Remembered { i: p[0], j: p[1], spring: spring(row) });
    }
    for c in near_walls.chunks(3) {
        chunks[c[0] as usize / CHUNK].candidates.extend(candidate(scene, grains, c[0], c[1], Image(c[2])));
    }
    for (c, row) in on_walls.chunks(2).zip(wall_springs.chunks(2 * D + 1)) {
        let contact = WallContact { grain: c[0], wall: c[1], normal: vector(row), spring: spring(&row[D..]) };
        chunks[c[0] as usize / CHUNK].wall_contacts.push(contact);
    }
    for (index, chunk) in chunks.iter_mut().enumerate() {
        complete(scene, grains, index, chunk);
    }
    let list = ContactList {
        incoming: if metadata.valid { incoming(&chunks) } else { vec![] },
        chunks,
        reference: reference.chunks_exact(D).map(vector).collect(),
        skin: metadata.skin,
        valid: metadata.valid,
        built_since_order: metadata.built_since_order,
    };
    Ok(Some(list))
}

fn floats<const D: usize, const N: usize>(
    vector: &Vector<D>,
    more: [f64; N],
) -> impl Iterator<Item = f64> + use<D, N> {
    vector.data.0.into_iter().flatten().chain(more)
}

fn spring_floats<const D: usize>(spring: &Spring<D>) -> impl Iterator<Item = f64> + use<D> {
    floats(&spring.elongation, [spring.stiffness])
}

fn vector<const D: usize>(row: &[f64]) -> Vector<D> {
    Vector::from_column_slice(&row[..D])
}

fn spring<const D: usize>(row: &[f64]) -> Spring<D> {
    Spring { elongation: vector(row), stiffness: row[D] }
}
