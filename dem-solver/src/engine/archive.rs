//! The lists as arrays, for a checkpoint, and back.

use super::chunk::{Chunk, find_stretches, ranges};
use super::constants::Alike;
use super::inner::Refresh;
use super::list::ContactList;
use super::near_planes::{NearPlane, PlaneSpring, Planes};
use super::near_walls::{candidate, extras_near};
use super::outer::assign_slots;
use super::periods::Periods;
use super::springs::Memory;
use super::wall_contact::WallContact;
use crate::contact::tangential::{ANNULI, Annuli};
use crate::contact::twisting::Twist;
use crate::contact::{History, Remembered, Spring};
use crate::domain::Image;
use crate::grains::Grains;
use crate::lanes::Vec3;
use crate::scene::Scene;
use crate::sleep::Quiet;
use crate::vector::Spin;

/// All that cannot be found again from the grains; rows are those of the world.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactArrays {
    /// Grains that the lists know.
    pub rows: u64,
    /// Numbers stored of each spring; those left out are 0 in all.
    pub width: u64,
    /// Outer pairs, two rows each.
    pub outer: Vec<u32>,
    /// Which of them are inner ones.
    pub inner: Vec<u32>,
    /// Force and stiffness of the spring of each inner pair; empty without friction.
    pub springs: Vec<f64>,
    /// Pairs whose springs are on their way to the next list, two rows each.
    pub remembered: Vec<u32>,
    /// Their springs.
    pub remembered_springs: Vec<f64>,
    /// Grains near planes, row and plane each.
    pub near_planes: Vec<u32>,
    /// Their springs; empty without friction.
    pub plane_springs: Vec<f64>,
    /// Contacts with planes on their way to the next list, row and plane each.
    pub on_planes: Vec<u32>,
    /// Their springs.
    pub on_planes_springs: Vec<f64>,
    /// Other grains near walls: row, surface and image each.
    pub near_walls: Vec<u32>,
    /// Those that touched: row and wall each.
    pub on_walls: Vec<u32>,
    /// Their normals and springs.
    pub wall_springs: Vec<f64>,
    /// Quiet time of each chunk \[s\], infinite where it sleeps.
    pub quiet: Vec<f64>,
}

/// Numbers of a spring: force and stiffness, the torque against rolling, the bridge, the twist, its annuli.
const ALL: usize = OF_SPRING + 3 * ANNULI + 4;
/// Those before the annuli.
const OF_SPRING: usize = 10;
/// Those that are always stored.
const FEWEST: usize = 4;

fn all_floats(history: &History) -> [f64; ALL] {
    let mut all = [0.0; ALL];
    let (Spring { force: f, stiffness, torque: t, bridge, twist }, annuli) = history.parts();
    let Annuli { force, full_stiffness, normal } = annuli;
    all[..OF_SPRING].copy_from_slice(&[
        f.x,
        f.y,
        f.z,
        stiffness,
        t.x,
        t.y,
        t.z,
        bridge,
        twist.torque,
        twist.stiffness,
    ]);
    for (row, f) in all[OF_SPRING..].chunks_mut(3).zip(force) {
        row.copy_from_slice(&[f.x, f.y, f.z]);
    }
    all[ALL - 4..].copy_from_slice(&[normal.x, normal.y, normal.z, full_stiffness]);
    all
}

fn floats(history: &History, width: usize) -> impl Iterator<Item = f64> + use<> {
    all_floats(history).into_iter().take(width)
}

fn history(row: &[f64]) -> History {
    let mut all = [0.0; ALL];
    all[..row.len()].copy_from_slice(row);
    let vector = |at: usize| Vec3::new(all[at], all[at + 1], all[at + 2]);
    let twist = Twist { torque: all[8], stiffness: all[9] };
    let spring = Spring { force: vector(0), stiffness: all[3], torque: vector(4), bridge: all[7], twist };
    let annuli = Annuli {
        force: std::array::from_fn(|k| vector(OF_SPRING + 3 * k)),
        normal: vector(ALL - 4),
        full_stiffness: all[ALL - 1],
    };
    History { spring, annuli: (row.len() > OF_SPRING).then(|| Box::new(annuli)) }
}

/// How many numbers of the springs must be stored so that none is lost.
fn width(list: &ContactList) -> usize {
    let used =
        |history: &History| all_floats(history).iter().rposition(|&x| x != 0.0).map_or(0, |last| last + 1);
    let of_chunk = |chunk: &Chunk| {
        let listed = chunk.inner.all_springs().chain(chunk.planes.all_springs()).map(|spring| used(&spring));
        let remembered = chunk.remembered.iter().map(|entry| used(&entry.spring));
        let on_planes = chunk.plane_springs.iter().map(|entry| used(&entry.spring));
        let on_walls = chunk.wall_contacts.iter().map(|contact| used(&contact.spring));
        listed.chain(remembered).chain(on_planes).chain(on_walls).max()
    };
    list.chunks.iter().filter_map(of_chunk).fold(FEWEST, usize::max)
}

impl ContactArrays {
    /// The lists as arrays.
    pub fn of(list: &ContactList) -> Self {
        let width = width(list);
        let quiet = list.quiet.iter().map(|quiet| quiet.time()).collect();
        let mut arrays = Self { width: width as u64, quiet, ..Self::default() };
        for chunk in &list.chunks {
            arrays.rows = chunk.rows.end as u64;
            let before = arrays.outer.len() as u32 / 2;
            let pairs = chunk.outer.i.iter().zip(&chunk.outer.slot);
            arrays.outer.extend(pairs.flat_map(|(&i, &slot)| [i, chunk.grain_of_slot[slot as usize]]));
            arrays.inner.extend(chunk.inner.source.iter().map(|pair| before + pair));
            arrays.springs.extend(chunk.inner.all_springs().flat_map(move |spring| floats(&spring, width)));
            arrays.remembered.extend(chunk.remembered.iter().flat_map(|entry| [entry.i, entry.j]));
            arrays
                .remembered_springs
                .extend(chunk.remembered.iter().flat_map(|entry| floats(&entry.spring, width)));
            arrays
                .near_planes
                .extend(chunk.planes.contacts().flat_map(|(row, plane, _)| [row as u32, plane as u32]));
            arrays
                .plane_springs
                .extend(chunk.planes.all_springs().flat_map(move |spring| floats(&spring, width)));
            arrays.on_planes.extend(chunk.plane_springs.iter().flat_map(|entry| [entry.grain, entry.plane]));
            arrays
                .on_planes_springs
                .extend(chunk.plane_springs.iter().flat_map(|entry| floats(&entry.spring, width)));
            arrays.near_walls.extend(chunk.candidates.iter().flat_map(|c| [c.grain, c.surface, c.image.0]));
            arrays.on_walls.extend(chunk.wall_contacts.iter().flat_map(|c| [c.grain, c.wall]));
            arrays.wall_springs.extend(
                chunk
                    .wall_contacts
                    .iter()
                    .flat_map(|c| c.normal.iter().copied().chain(floats(&c.spring, width)))
                    .collect::<Vec<_>>(),
            );
        }
        arrays
    }

    /// Whether they are of this scene and these grains.
    fn fit<const D: usize>(&self, scene: &Scene<D>, planes: &Planes, grains: usize) -> bool {
        fn ascends<const N: usize>(list: &[u32]) -> bool {
            list.len().is_multiple_of(N) && list.as_chunks::<N>().0.is_sorted_by_key(|row| row[0])
        }
        let (rows, images) = (self.rows as u32, scene.shifts.len() as u32);
        let (surfaces, walls) = (scene.walls.surfaces.len() as u32, scene.walls.len() as u32);
        let pairs = |list: &[u32]| ascends::<2>(list) && list.chunks(2).all(|p| p[0] < p[1] && p[1] < rows);
        let on_planes = |list: &[u32]| {
            ascends::<2>(list) && list.chunks(2).all(|c| c[0] < rows && (c[1] as usize) < planes.wall.len())
        };
        let width = self.width as usize;
        let springs = |list: &[f64], contacts: usize| list.len() == width * contacts;
        let remember = Memory::of(scene).any();
        (FEWEST..=ALL).contains(&width)
            && self.rows <= grains as u64
            && pairs(&self.outer)
            && pairs(&self.remembered)
            && self.inner.is_sorted()
            && self.inner.last().is_none_or(|&pair| (pair as usize) < self.outer.len() / 2)
            && springs(&self.springs, if remember { self.inner.len() } else { 0 })
            && springs(&self.remembered_springs, self.remembered.len() / 2)
            && on_planes(&self.near_planes)
            && on_planes(&self.on_planes)
            && springs(&self.plane_springs, if remember { self.near_planes.len() / 2 } else { 0 })
            && springs(&self.on_planes_springs, self.on_planes.len() / 2)
            && ascends::<3>(&self.near_walls)
            && self.near_walls.chunks(3).all(|c| c[0] < rows && c[1] < surfaces && c[2] < images)
            && ascends::<2>(&self.on_walls)
            && self.on_walls.chunks(2).all(|c| c[0] < rows && c[1] < walls)
            && self.quiet.len() == ranges(self.rows as usize).count()
            && self.wall_springs.len() == self.on_walls.len() / 2 * (3 + width)
    }

    /// The lists of these grains; `list` has the rest of them. Nothing if the arrays do not fit.
    pub fn restore<const D: usize>(
        &self,
        scene: &Scene<D>,
        grains: &Grains,
        mut list: ContactList,
    ) -> Option<ContactList> {
        let planes = Planes::of(scene);
        if !self.fit(scene, &planes, grains.len()) {
            return None;
        }
        let spent = list.spent;
        list.fit(self.rows as usize);
        list.spent = spent;
        list.quiet = self.quiet.iter().map(|&time| Quiet::of_time(time)).collect::<Option<_>>()?;
        // Without an outer list nothing was found to be alike.
        list.alike = if list.counters.outer > 0 { Alike::of(scene, grains) } else { None };
        let periods = Periods::new(&scene.domain);
        let refresh =
            Refresh { scene, grains, periods: &periods, gap: list.skins.inner, alike: list.alike.is_some() };
        let (mut rest, width, memory) = (Rest::of(self), self.width as usize, Memory::of(scene));
        let (mut first_pair, mut inner_done) = (0, 0);
        for chunk in &mut list.chunks {
            let (first, end) = (chunk.rows.start as u32, chunk.rows.end as u32);
            for pair in rest.outer.take_below(end) {
                chunk.outer.i.push(pair[0]);
                chunk.outer.slot.push(pair[1]);
            }
            let last_pair = first_pair + chunk.outer.i.len() as u32;
            let inner = self.inner[inner_done..].partition_point(|&pair| pair < last_pair);
            chunk.inner.source.extend(self.inner[inner_done..][..inner].iter().map(|pair| pair - first_pair));
            assign_slots(chunk);
            refresh.complete(chunk);
            if memory.any() {
                let springs = self.springs[width * inner_done..].chunks(width).take(inner).map(history);
                chunk.inner.set_springs(springs);
            }
            (first_pair, inner_done) = (last_pair, inner_done + inner);
            for (pair, row) in rest.remembered.take_below(end).iter().zip(&mut rest.remembered_springs) {
                chunk.remembered.push(Remembered { i: pair[0], j: pair[1], spring: history(row) });
            }
            for contact in rest.near_planes.take_below(end) {
                let (grain, plane) = (contact[0], contact[1]);
                let surface = planes.surface[plane as usize];
                let radius = grains.place[grain as usize].radius;
                let found = candidate(scene, grains, grain, surface, Image::new([0; D]))?;
                let coefficients = found.coefficients;
                let extras = extras_near(scene, grains, &found);
                let near = NearPlane { grain, plane, radius, coefficients, extras };
                let spring = rest.plane_springs.next().map_or(History::none(), history);
                chunk.planes.push(&near, first, planes.surface.len() as u32, &spring, memory);
            }
            for (contact, row) in rest.on_planes.take_below(end).iter().zip(&mut rest.on_planes_springs) {
                let (grain, plane) = (contact[0], contact[1]);
                chunk.plane_springs.push(PlaneSpring { grain, plane, spring: history(row) });
            }
            for c in rest.near_walls.take_below(end) {
                chunk.candidates.extend(candidate(scene, grains, c[0], c[1], Image(c[2])));
            }
            for (contact, row) in rest.on_walls.take_below(end).iter().zip(&mut rest.wall_springs) {
                let (grain, wall, normal) = (contact[0], contact[1], Spin::new(row[0], row[1], row[2]));
                chunk.wall_contacts.push(WallContact { grain, wall, normal, spring: history(&row[3..]) });
            }
        }
        find_stretches(&mut list.chunks);
        Some(list)
    }
}

/// Rows of `N` that ascend in their first number.
struct Ascending<'a, const N: usize>(&'a [[u32; N]]);

impl<'a, const N: usize> Ascending<'a, N> {
    fn new(list: &'a [u32]) -> Self {
        Self(list.as_chunks().0)
    }

    /// The rows that begin below `end`.
    fn take_below(&mut self, end: u32) -> &'a [[u32; N]] {
        let (taken, left) = self.0.split_at(self.0.partition_point(|row| row[0] < end));
        self.0 = left;
        taken
    }
}

/// What is left to share out to chunks.
struct Rest<'a> {
    outer: Ascending<'a, 2>,
    remembered: Ascending<'a, 2>,
    remembered_springs: std::slice::Chunks<'a, f64>,
    near_planes: Ascending<'a, 2>,
    plane_springs: std::slice::Chunks<'a, f64>,
    on_planes: Ascending<'a, 2>,
    on_planes_springs: std::slice::Chunks<'a, f64>,
    near_walls: Ascending<'a, 3>,
    on_walls: Ascending<'a, 2>,
    wall_springs: std::slice::Chunks<'a, f64>,
}

impl<'a> Rest<'a> {
    fn of(arrays: &'a ContactArrays) -> Self {
        let width = arrays.width as usize;
        Self {
            outer: Ascending::new(&arrays.outer),
            remembered: Ascending::new(&arrays.remembered),
            remembered_springs: arrays.remembered_springs.chunks(width),
            near_planes: Ascending::new(&arrays.near_planes),
            plane_springs: arrays.plane_springs.chunks(width),
            on_planes: Ascending::new(&arrays.on_planes),
            on_planes_springs: arrays.on_planes_springs.chunks(width),
            near_walls: Ascending::new(&arrays.near_walls),
            on_walls: Ascending::new(&arrays.on_walls),
            wall_springs: arrays.wall_springs.chunks(3 + width),
        }
    }
}
