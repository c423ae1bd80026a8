//! Who is near whom, and what contacts remember: part of the state.

use super::approach::Approach;
use super::chunk::{Chunk, ranges};
use super::constants::Alike;
use super::near_planes::PlaneSpring;
use super::order::LISTS_PER_ORDER;
use super::wall_contact::WallContact;
use crate::contact::Remembered;
use crate::sleep::{Quiet, Slumber, regroup};

/// How far beyond touch the lists reach, or how much of that is spent \[m\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Skins {
    /// Of the outer list of pairs.
    pub outer: f64,
    /// Of the inner one.
    pub inner: f64,
    /// Of the list of grains near walls.
    pub walls: f64,
}

impl Skins {
    const ALL: Self = Self { outer: f64::INFINITY, inner: f64::INFINITY, walls: f64::INFINITY };
}

/// How often lists were made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Outer lists.
    pub outer: u64,
    /// Inner lists, those of new outer lists too.
    pub inner: u64,
    /// Lists of grains near walls.
    pub walls: u64,
}

/// The lists with the memory of all contacts.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactList {
    /// Contacts of each chunk of grains.
    pub chunks: Vec<Chunk>,
    /// What all pairs share, if they do.
    pub alike: Option<Alike>,
    /// How far the lists reach.
    pub skins: Skins,
    /// How far grains may have come nearer to each other and to walls since the lists were made; infinite where
    /// there is none.
    pub spent: Skins,
    /// How fast they did so in the last step.
    pub approach: Approach,
    /// The walls as the list of grains near them knows them are those of this time \[s\].
    pub walls_time: f64,
    /// Outer lists since the grains were last put in order.
    pub built_since_order: u32,
    /// How often lists were made.
    pub counters: Counters,
    /// By chunk: for how long its grains have been slow, or that they sleep.
    pub quiet: Vec<Quiet>,
    /// How much was slept.
    pub slumber: Slumber,
}

impl ContactList {
    /// No list yet.
    pub fn new() -> Self {
        Self {
            chunks: vec![],
            alike: None,
            skins: Skins { outer: 0.0, inner: 0.0, walls: 0.0 },
            spent: Skins::ALL,
            approach: Approach::none(),
            walls_time: 0.0,
            // Grains are born in any order.
            built_since_order: LISTS_PER_ORDER,
            counters: Counters::default(),
            quiet: vec![],
            slumber: Slumber::default(),
        }
    }

    /// The lists must be made anew, as after births.
    pub fn expire(&mut self) {
        self.spent = Skins::ALL;
    }

    /// Whether the lists must be made anew.
    pub fn has_expired(&self) -> bool {
        self.spent.outer.is_infinite()
    }

    /// Books what grains may have come nearer in a flight of `time` \[s\].
    pub fn spend(&mut self, approach: &Approach, time: f64) {
        self.spent.outer += time * approach.between_grains;
        self.spent.inner += time * approach.between_grains;
        self.spent.walls += time * approach.to_walls;
    }

    /// Takes all springs out and shares them out anew, for grains that get new rows: `new_row[row]`, or nothing for
    /// a removed grain.
    pub fn renumber(&mut self, new_row: &[Option<u32>], grains: usize) {
        let (mut pairs, mut on_planes, mut on_walls) = (Vec::new(), Vec::new(), Vec::new());
        let mut quiet_of_row = vec![Quiet::default(); grains];
        for (chunk, quiet) in self.chunks.iter_mut().zip(&self.quiet) {
            new_row[chunk.rows.clone()].iter().flatten().for_each(|&row| quiet_of_row[row as usize] = *quiet);
            chunk.stow();
            pairs.extend(chunk.remembered.drain(..).filter_map(|Remembered { i, j, spring }| {
                let (i, j) = (new_row[i as usize]?, new_row[j as usize]?);
                let spring = if i < j { spring } else { spring.reversed() };
                Some(Remembered { i: i.min(j), j: i.max(j), spring })
            }));
            on_planes.extend(chunk.plane_springs.drain(..).filter_map(|contact| {
                Some(PlaneSpring { grain: new_row[contact.grain as usize]?, ..contact })
            }));
            on_walls.extend(chunk.wall_contacts.drain(..).filter_map(|contact| {
                Some(WallContact { grain: new_row[contact.grain as usize]?, ..contact })
            }));
        }
        pairs.sort_unstable_by_key(|entry| (entry.i, entry.j));
        on_planes.sort_by_key(|contact| contact.grain);
        on_walls.sort_by_key(|contact| contact.grain);
        self.chunks = ranges(grains).map(Chunk::new).collect();
        let woken;
        (self.quiet, woken) = regroup(&self.chunks, &quiet_of_row);
        self.slumber.wakings += woken;
        let mut pairs = pairs.into_iter().peekable();
        let mut on_planes = on_planes.into_iter().peekable();
        let mut on_walls = on_walls.into_iter().peekable();
        for chunk in &mut self.chunks {
            let end = chunk.rows.end as u32;
            chunk.remembered.extend(std::iter::from_fn(|| pairs.next_if(|entry| entry.i < end)));
            chunk
                .plane_springs
                .extend(std::iter::from_fn(|| on_planes.next_if(|contact| contact.grain < end)));
            chunk
                .wall_contacts
                .extend(std::iter::from_fn(|| on_walls.next_if(|contact| contact.grain < end)));
        }
        self.expire();
    }

    /// Shares the grains out to chunks if their number has changed; tells whether it has.
    pub fn fit(&mut self, grains: usize) -> bool {
        let known = self.chunks.last().map_or(0, |chunk| chunk.rows.end);
        if known != grains {
            let same: Vec<_> = (0..known as u32).map(Some).collect();
            self.renumber(&same, grains);
        }
        known != grains
    }

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        let Self { chunks, alike, skins, spent, approach, walls_time, built_since_order, .. } = other;
        let Self { counters, quiet, slumber, .. } = other;
        self.chunks.resize_with(chunks.len(), Chunk::default);
        for (mine, theirs) in self.chunks.iter_mut().zip(chunks) {
            mine.copy_from(theirs);
        }
        (self.alike, self.skins, self.spent, self.approach) = (*alike, *skins, *spent, *approach);
        (self.walls_time, self.built_since_order) = (*walls_time, *built_since_order);
        (self.counters, self.slumber) = (*counters, *slumber);
        self.quiet.clone_from(quiet);
    }
}

impl Default for ContactList {
    fn default() -> Self {
        Self::new()
    }
}
