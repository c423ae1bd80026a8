//! Planes at rest, and grains that nothing else of the walls is near.

use super::block::{ConstantsBlock, ExtrasBlock, PlaneBlock, WIDTH};
use super::springs::{Memory, Springs};
use crate::contact::{Coefficients, ExtraConstants, History};
use crate::grains::Place;
use crate::lanes::Row4;
use crate::scene::Scene;
use crate::vector::{Spin, embed};
use crate::wall::Shape;

/// A plane that no grain reaches.
const FAR_PLANE: Row4 = Row4([0.0, 0.0, 1.0, -1e300]);

/// Cosine of the angle below which two planes may be one wall to a grain that touches both: whether they are is found
/// one by one.
const NEARLY_PARALLEL: f64 = 0.5;

/// The planes at rest of a scene that grains touch one at a time or at an angle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Planes {
    /// `[n d]`: the points of the plane are n·x = d, grains are on the side of n. The last row is a plane that no
    /// grain reaches.
    pub rows: Vec<Row4>,
    /// Which surface each is.
    pub surface: Vec<u32>,
    /// Which wall each belongs to.
    pub wall: Vec<u32>,
}

impl Planes {
    /// The planes at rest of a scene.
    pub fn of<const D: usize>(scene: &Scene<D>) -> Self {
        let mut planes = Self::default();
        let at_rest: Vec<_> = scene
            .walls
            .surfaces
            .iter()
            .enumerate()
            .filter_map(|(surface, piece)| {
                let Shape::Plane(plane) = piece.shape else { return None };
                (!scene.walls.moves(piece.wall as usize)).then_some((surface as u32, piece.wall, plane))
            })
            .collect();
        for (surface, wall, plane) in &at_rest {
            let alone = at_rest.iter().all(|(other, _, beside)| {
                other == surface || beside.normal.dot(&plane.normal) < NEARLY_PARALLEL
            });
            if alone {
                let n = embed(&plane.normal);
                planes.rows.push(Row4([n.x, n.y, n.z, plane.normal.dot(&plane.point)]));
                planes.surface.push(*surface);
                planes.wall.push(*wall);
            }
        }
        planes.rows.push(FAR_PLANE);
        planes
    }

    /// Unit normal from a grain to a plane.
    pub fn normal(&self, plane: u32) -> Spin {
        let n = self.rows[plane as usize].0;
        -Spin::new(n[0], n[1], n[2])
    }

    /// How far a grain reaches into a plane \[m\].
    pub fn overlap(&self, plane: usize, place: &Place) -> f64 {
        let [x, y, z, offset] = self.rows[plane].0;
        place.radius - (Spin::new(x, y, z).dot(&place.centre) - offset)
    }

    /// The plane that is this surface.
    pub fn of_surface(&self, surface: u32) -> Option<u32> {
        self.surface.binary_search(&surface).ok().map(|plane| plane as u32)
    }
}

/// Grains near planes, in blocks; the last block is filled up with the far plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NearPlanes {
    /// Number of contacts.
    pub count: usize,
    /// Who they are.
    pub blocks: Vec<PlaneBlock>,
    /// What they remember; empty without friction.
    pub springs: Springs,
    /// Their constants.
    pub constants: Vec<ConstantsBlock>,
    /// Constants of their laws besides normal and tangential force; empty without such.
    pub extras: Vec<ExtrasBlock>,
}

/// A grain, a plane, and the spring between them.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneSpring {
    /// Row of the grain.
    pub grain: u32,
    /// Index of the plane.
    pub plane: u32,
    /// The spring, and all the contact remembers besides.
    pub spring: History,
}

/// A grain near a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearPlane {
    /// Row of the grain.
    pub grain: u32,
    /// Index of the plane.
    pub plane: u32,
    /// Radius of the grain \[m\].
    pub radius: f64,
    /// Constants of the contact.
    pub coefficients: Coefficients,
    /// Constants of its laws besides normal and tangential force, if there are any.
    pub extras: Option<ExtraConstants>,
}

impl NearPlanes {
    /// The springs that are loaded.
    pub fn loaded(&self) -> impl Iterator<Item = PlaneSpring> {
        let all = self.all_springs().enumerate().map(|(k, spring)| {
            let (grain, plane) = self.contact(k);
            PlaneSpring { grain, plane, spring }
        });
        all.filter(|contact| contact.spring.is_active())
    }

    /// The springs of all contacts, if they remember.
    pub fn all_springs(&self) -> impl Iterator<Item = History> {
        let count = if self.springs.is_empty() { 0 } else { self.count };
        (0..count).map(|k| self.springs.get(k))
    }

    /// Grain, plane and constants of all contacts.
    pub fn contacts(&self) -> impl Iterator<Item = (usize, usize, Coefficients)> {
        (0..self.count).map(|k| {
            let (grain, plane) = self.contact(k);
            (grain as usize, plane as usize, self.constants[k / WIDTH].coefficients(k % WIDTH))
        })
    }

    /// Grain and plane of a contact.
    pub fn contact(&self, k: usize) -> (u32, u32) {
        let block = &self.blocks[k / WIDTH];
        (block.grain[k % WIDTH], block.plane[k % WIDTH])
    }

    /// Appends a contact of a chunk that begins at row `first`; `spring` is what it remembers, if it remembers.
    pub fn push(&mut self, near: &NearPlane, first: u32, far_plane: u32, spring: &History, memory: Memory) {
        let (block, lane) = (self.count / WIDTH, self.count % WIDTH);
        if lane == 0 {
            let (grain, plane) = ([first; WIDTH], [far_plane; WIDTH]);
            self.blocks.push(PlaneBlock { grain, slot: [0; WIDTH], plane });
            self.constants.push(ConstantsBlock::default());
            self.springs.push_block(memory);
            if near.extras.is_some() {
                self.extras.push(ExtrasBlock::default());
            }
        }
        self.blocks[block].grain[lane] = near.grain;
        self.blocks[block].slot[lane] = near.grain - first;
        self.blocks[block].plane[lane] = near.plane;
        self.constants[block].set(lane, (near.radius, near.radius), &near.coefficients);
        if let Some(extras) = &near.extras {
            self.extras[block].set(lane, extras);
        }
        self.springs.set(self.count, spring);
        self.count += 1;
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.count = 0;
        self.blocks.clear();
        self.springs.clear();
        self.constants.clear();
        self.extras.clear();
    }

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        self.count = other.count;
        self.blocks.clone_from(&other.blocks);
        self.springs.copy_from(&other.springs);
        self.constants.clone_from(&other.constants);
        self.extras.clone_from(&other.extras);
    }
}
