//! Who may touch whom, and what touching contacts remember.

use super::coefficients::Coefficients;
use super::tangential::Spring;
use crate::domain::Image;
use crate::vector::Vector;

/// Grains per chunk: a fixed number, so that sums do not depend on the number of threads.
pub const CHUNK: usize = 1024;

/// Number of chunks of so many grains.
pub fn chunk_count(grains: usize) -> usize {
    grains.div_ceil(CHUNK)
}

/// Two grains near each other, `i` < `j`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Pair {
    /// Row of the first grain.
    pub i: u32,
    /// Row of the second grain.
    pub j: u32,
    /// Where the chunk adds up the load on `j`: in its own rows, or behind them in its overhang.
    pub slot: u32,
    /// Which image of `j` is near `i`.
    pub image: Image,
}

/// A grain and a surface of a wall near it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Row of the grain.
    pub grain: u32,
    /// Index of the surface.
    pub surface: u32,
    /// Which image of the grain's surroundings the surface is seen in.
    pub image: Image,
    /// Constants of the contact.
    pub coefficients: Coefficients,
}

/// A grain that touched a wall in the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallContact<const D: usize> {
    /// Row of the grain.
    pub grain: u32,
    /// Index of the wall.
    pub wall: u32,
    /// Unit normal, from the grain to the wall.
    pub normal: Vector<D>,
    /// The tangential spring.
    pub spring: Spring<D>,
}

/// The spring of a touching pair while the list is built anew.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remembered<const D: usize> {
    /// Row of the first grain.
    pub i: u32,
    /// Row of the second grain.
    pub j: u32,
    /// Its spring.
    pub spring: Spring<D>,
}

/// The contacts of [`CHUNK`] successive grains with later grains and with walls.
#[derive(Clone, Debug, PartialEq)]
pub struct Chunk<const D: usize> {
    /// Near pairs, ascending in `(i, j)`.
    pub pairs: Vec<Pair>,
    /// Constants of each pair.
    pub coefficients: Vec<Coefficients>,
    /// Spring of each pair; empty in a scene without friction.
    pub springs: Vec<Spring<D>>,
    /// Rows behind the chunk that its pairs load, ascending.
    pub overhang: Vec<u32>,
    /// Near surfaces, ascending in the grain.
    pub candidates: Vec<Candidate>,
    /// Walls touched in the last step, ascending in the grain.
    pub wall_contacts: Vec<WallContact<D>>,
    /// Springs on their way from the last list to the next, ascending in `(i, j)`.
    pub remembered: Vec<Remembered<D>>,
}

impl<const D: usize> Chunk<D> {
    /// No contact.
    pub fn new() -> Self {
        Self {
            pairs: vec![],
            coefficients: vec![],
            springs: vec![],
            overhang: vec![],
            candidates: vec![],
            wall_contacts: vec![],
            remembered: vec![],
        }
    }

    /// Clears the list of pairs and keeps the springs of those that touch.
    pub fn stow(&mut self) {
        let active = self.pairs.iter().zip(&self.springs).filter(|(_, spring)| spring.is_active());
        self.remembered.extend(active.map(|(pair, &spring)| Remembered { i: pair.i, j: pair.j, spring }));
        self.pairs.clear();
        self.coefficients.clear();
        self.springs.clear();
        self.overhang.clear();
        self.candidates.clear();
    }

    fn copy_from(&mut self, other: &Self) {
        self.pairs.clone_from(&other.pairs);
        self.coefficients.clone_from(&other.coefficients);
        self.springs.clone_from(&other.springs);
        self.overhang.clone_from(&other.overhang);
        self.candidates.clone_from(&other.candidates);
        self.wall_contacts.clone_from(&other.wall_contacts);
        self.remembered.clone_from(&other.remembered);
    }
}

impl<const D: usize> Default for Chunk<D> {
    fn default() -> Self {
        Self::new()
    }
}

/// A stretch of a chunk's overhang that lies in another chunk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Incoming {
    /// The chunk that pushes.
    pub source: u32,
    /// First entry of its overhang.
    pub begin: u32,
    /// One past the last entry.
    pub end: u32,
}

/// The neighbour list with the memory of all contacts.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactList<const D: usize> {
    /// Contacts of each chunk of grains.
    pub chunks: Vec<Chunk<D>>,
    /// For each chunk, the overhangs of earlier chunks that load it, in their order.
    pub incoming: Vec<Vec<Incoming>>,
    /// Centres when the list was built \[m\].
    pub reference: Vec<Vector<D>>,
    /// Gap up to which pairs are listed \[m\].
    pub skin: f64,
    /// Whether the list may be used; false after births, removals and a new order.
    pub valid: bool,
    /// How often it was built since the grains were last put in order.
    pub built_since_order: u32,
}

impl<const D: usize> ContactList<D> {
    /// No list yet.
    pub fn new() -> Self {
        Self {
            chunks: vec![],
            incoming: vec![],
            reference: vec![],
            skin: 0.0,
            valid: false,
            built_since_order: 0,
        }
    }

    /// Takes all springs out, for grains that get new rows: `new_row[row]`, or nothing for a removed grain.
    pub fn renumber(&mut self, new_row: &[Option<u32>], grains: usize) {
        let mut remembered = Vec::new();
        let mut wall_contacts = Vec::new();
        for chunk in &mut self.chunks {
            chunk.stow();
            remembered.append(&mut chunk.remembered);
            wall_contacts.append(&mut chunk.wall_contacts);
        }
        self.chunks.resize_with(chunk_count(grains), Chunk::new);
        let mut remembered: Vec<_> = remembered
            .into_iter()
            .filter_map(|Remembered { i, j, spring }| {
                let (i, j) = (new_row[i as usize]?, new_row[j as usize]?);
                Some(if i < j {
                    Remembered { i, j, spring }
                } else {
                    Remembered { i: j, j: i, spring: spring.reversed() }
                })
            })
            .collect();
        remembered.sort_unstable_by_key(|entry| (entry.i, entry.j));
        for entry in remembered {
            self.chunks[entry.i as usize / CHUNK].remembered.push(entry);
        }
        let mut wall_contacts: Vec<_> = wall_contacts
            .into_iter()
            .filter_map(|contact| Some(WallContact { grain: new_row[contact.grain as usize]?, ..contact }))
            .collect();
        wall_contacts.sort_by_key(|contact| contact.grain);
        for contact in wall_contacts {
            self.chunks[contact.grain as usize / CHUNK].wall_contacts.push(contact);
        }
        self.incoming.clear();
        self.valid = false;
    }

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        self.chunks.resize_with(other.chunks.len(), Chunk::new);
        for (mine, theirs) in self.chunks.iter_mut().zip(&other.chunks) {
            mine.copy_from(theirs);
        }
        self.incoming.resize_with(other.incoming.len(), Vec::new);
        for (mine, theirs) in self.incoming.iter_mut().zip(&other.incoming) {
            mine.clone_from(theirs);
        }
        self.reference.clone_from(&other.reference);
        self.skin = other.skin;
        self.valid = other.valid;
        self.built_since_order = other.built_since_order;
    }
}

impl<const D: usize> Default for ContactList<D> {
    fn default() -> Self {
        Self::new()
    }
}
