//! What is worked on in a step.

use super::quiet::Quiet;
use crate::engine::{Chunk, ContactList};
use crate::scene::Scene;
use crate::workspace::Workspace;
use crate::world::World;

/// What a step does with the forces of a chunk.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Work {
    /// All loads on its rows are found, by it and by the chunks that reach it.
    #[default]
    All,
    /// It sleeps, but finds its forces for a chunk that it reaches; loads on its own rows are not complete.
    ForOthers,
    /// It and all chunks that it reaches sleep, and nothing of theirs has changed.
    Nothing,
}

impl Work {
    /// Whether the chunk finds its forces.
    pub fn finds_forces(self) -> bool {
        self != Self::Nothing
    }
}

/// Says for each chunk what the coming step does with its forces.
///
/// Asked are chunks that are awake, that may touch or are bonded to one that is, or that a moving wall is near; all of
/// them after [`Workspace::survey`].
pub fn assign_work<const D: usize>(scene: &Scene<D>, world: &World<D>, workspace: &mut Workspace<D>) {
    if scene.sleep.is_none() {
        return;
    }
    let Workspace { work, survey, links, .. } = workspace;
    let ContactList { chunks, quiet, .. } = &world.contacts;
    work.clear();
    work.resize(chunks.len(), Work::All);
    if std::mem::take(survey) || !quiet.iter().any(|quiet| quiet.is_asleep()) {
        return;
    }
    let awake = |chunk: usize| !quiet[chunk].is_asleep();
    let mut asked: Vec<bool> =
        chunks.iter().zip(quiet).map(|(chunk, quiet)| !quiet.is_asleep() || stirred(scene, chunk)).collect();
    let mut link = |one: usize, other: usize| {
        asked[one] |= awake(other);
        asked[other] |= awake(one);
    };
    for (k, chunk) in chunks.iter().enumerate() {
        chunk.stretches.iter().for_each(|stretch| link(k, stretch.target));
    }
    let size = chunks[0].rows.len();
    links.rows().iter().for_each(|[i, j]| link(*i as usize / size, *j as usize / size));
    for (k, chunk) in chunks.iter().enumerate() {
        if !asked[k] {
            let reaches = chunk.stretches.iter().any(|stretch| asked[stretch.target]);
            work[k] = if reaches { Work::ForOthers } else { Work::Nothing };
        }
    }
}

/// Whether a wall that moves is near a grain of the chunk.
fn stirred<const D: usize>(scene: &Scene<D>, chunk: &Chunk) -> bool {
    let wall = |surface: u32| scene.walls.surfaces[surface as usize].wall as usize;
    chunk.candidates.iter().any(|candidate| scene.walls.moves(wall(candidate.surface)))
}

/// How quiet chunks are whose rows came from elsewhere: as the least quiet of their grains; `of_row` says how quiet each is.
/// Tells how many grains slept that now do not.
pub fn regroup(chunks: &[Chunk], of_row: &[Quiet]) -> (Vec<Quiet>, u64) {
    let mut woken = 0;
    let of_chunk = chunks.iter().map(|chunk| {
        let rows = &of_row[chunk.rows.clone()];
        let quiet = rows.iter().copied().fold(Quiet::ASLEEP, Quiet::joined);
        if !quiet.is_asleep() {
            woken += rows.iter().filter(|row| row.is_asleep()).count() as u64;
        }
        quiet
    });
    (of_chunk.collect(), woken)
}
