//! The mesh at t_{n+1}: which cells between the moved nodes are fluid.
//!
//! Nodes are managed on the moved surface, the surface is shifted a little to restore the volume, all nodes are
//! triangulated with the surface in it, what lies inside is fluid, and then surfaces merge and break.

mod books;
mod buried;
mod correction;
mod draft;
mod grading;
mod management;
mod recognition;
mod size;
mod space;
mod spent;
mod tessellation;
mod topology;
pub(super) mod transfer;

pub use books::{
    Account, Books, Energy, EnergyBooks, VolumeBooks, energy, volume, volumes, volumes_between_grains,
};
pub use grading::{Grading, Near, Source};
pub use recognition::Recognition;
pub use size::TargetSize;
pub use space::SpaceRemesher;
pub use spent::Spent;
pub use topology::Events;

use super::cloud::{Cloud, OUTSIDE};
use super::renewal::Renewal;
use super::wall::Wall;
use crate::element::simplex::Vector;
use draft::{Draft, area, height};
use interface::usage::ThreadClock;
use tessellation::Tessellation;

/// Cells lower than this share of h are managed once more.
const FLAT: f64 = 0.02;
/// Passes at most.
const PASSES: usize = 3;

/// Finds the mesh of moved nodes; all but the rules is scratch.
#[derive(Default)]
pub struct Remesher<const D: usize, const N: usize> {
    /// How the fluid is told from the void.
    pub recognition: Recognition,
    /// What volume is lifted against (m/s²): its potential energy may not come from nothing.
    acceleration: Vector<2>,
    spent: Spent,
    draft: Draft,
    triangles: Tessellation,
    gradient: Vec<Vector<D>>,
    node_volumes: Vec<f64>,
    cells: Vec<[u32; N]>,
    neighbours: Vec<[u32; N]>,
    number: Vec<u32>,
}

impl Renewal<2, 3> for Remesher<2, 3> {
    /// Events can leave nodes close together: then nodes are managed once more.
    fn remesh(
        &mut self,
        cloud: &mut Cloud<2, 3>,
        walls: &[Wall<2>],
        time: f64,
        size: &TargetSize,
        books: &mut Books<2>,
    ) -> Result<Events, delaunay::Error> {
        let mut events = self.pass(cloud, walls, time, size, books)?;
        for _ in 1..PASSES {
            if size.is_of_nodes() || !self.has_flat_cells(cloud) {
                break;
            }
            events = events.and(self.pass(cloud, walls, time, size, books)?);
        }
        cloud.relieve_drops();
        Ok(events)
    }

    fn spent(&self) -> Spent {
        Spent { mesh: self.triangles.seconds, ..self.spent }
    }
}

impl Remesher<2, 3> {
    /// A remesher with a rule.
    pub fn new(recognition: Recognition) -> Self {
        Self { recognition, ..Self::default() }
    }

    /// That of a fluid under an acceleration (m/s²).
    pub fn under(self, acceleration: Vector<2>) -> Self {
        Self { acceleration, ..self }
    }

    /// Whether a cell is so flat that no step could move it.
    fn has_flat_cells(&self, cloud: &Cloud<2, 3>) -> bool {
        cloud
            .cells
            .iter()
            .any(|cell| height(&cloud.vertices(cell)) < FLAT * self.draft.size[cell[0] as usize])
    }

    fn pass(
        &mut self,
        cloud: &mut Cloud<2, 3>,
        walls: &[Wall<2>],
        time: f64,
        size: &TargetSize,
        books: &mut Books<2>,
    ) -> Result<Events, delaunay::Error> {
        let mut clock = ThreadClock::start();
        self.draft.read(cloud, size);
        let energy_before = Energy::of(cloud, &self.draft.mass);
        let mut momentum = transfer::momentum(&self.draft.mass, &cloud.velocity);
        self.spent.transfer += clock.lap();
        let book = &mut books.volume;

        let moved = correction::enclosed(cloud, &self.draft);
        book.flow.add(moved - book.cells);
        management::manage(cloud, &mut self.draft, walls, time);
        let managed = correction::enclosed(cloud, &self.draft);
        book.management.add(managed - moved);
        let missing = book.target - managed - cloud.drop.iter().sum::<f64>();
        correction::restore(cloud, &self.draft, walls, time, missing, &mut self.gradient);
        let restored = correction::enclosed(cloud, &self.draft);
        book.correction.add(restored - managed);
        self.spent.management += clock.lap();

        let (draft, triangles) = (&mut self.draft, &mut self.triangles);
        let triangulating = triangles.seconds;
        let crossed = !self.recognition.recognise(cloud, draft, triangles)?;
        self.spent.recognition += clock.lap() - (triangles.seconds - triangulating);
        let mut events = Events { crossed, ..Events::default() };
        let recognised = self.fluid_volume();
        books.volume.overlap.add(recognised - restored);
        self.topology(cloud, walls, time, (&mut books.volume, &mut momentum), &mut events);
        let as_before =
            self.triangles.fluid_count() == cloud.cells.len() && !self.draft.edited && events.none();
        if !as_before || !self.still_delaunay(cloud) {
            self.take_cells(cloud);
        }
        self.spent.settling += clock.lap();
        books.volume.cells = volumes(cloud, &mut self.node_volumes);
        transfer::keep_momentum(cloud, &self.draft.mass, momentum, &self.node_volumes);
        let volumes = (&*self.draft.mass, &*self.node_volumes);
        transfer::keep_energy(cloud, volumes, &energy_before, &self.acceleration, &mut books.energy);
        books.volume.drops = cloud.drop.iter().sum();
        self.spent.transfer += clock.lap();
        Ok(events)
    }

    /// Merges and breaks.
    fn topology(
        &mut self,
        cloud: &mut Cloud<2, 3>,
        walls: &[Wall<2>],
        time: f64,
        (book, momentum): (&mut VolumeBooks, &mut Vector<2>),
        events: &mut Events,
    ) {
        let (draft, triangles) = (&mut self.draft, &mut self.triangles);
        let (closed, gained) = topology::close_gaps(cloud, draft, triangles);
        let (filled, void) = topology::fill_small_voids(cloud, draft, triangles);
        book.merging.add(gained + void);
        let (landed, pressed) = topology::land_on_walls(cloud, draft, triangles, walls, time, momentum);
        book.management.add(pressed);
        events.landed = landed;
        let (broken, lost) = topology::break_thin_cells(cloud, draft, triangles, walls, time);
        let (released, unborn) = topology::release_droplets(cloud, draft, triangles, walls);
        book.separation.add(-lost - unborn);
        let (absorbed, owed) = topology::absorb_drops(cloud, draft, triangles);
        book.absorption.add(-owed);
        (events.closed, events.filled, events.broken) = (closed, filled, broken);
        (events.released, events.absorbed) = (released, absorbed);
        let mut wet = std::mem::take(&mut triangles.scratch.marks);
        triangles.mark_wet(cloud.place.len(), &mut wet);
        for node in 0..cloud.place.len() {
            if !wet[node] && cloud.drop[node] == 0.0 && !draft.removed[node] {
                draft.remove(node as u32);
            }
        }
        triangles.scratch.marks = wet;
    }

    fn fluid_volume(&self) -> f64 {
        let fluid = (0..self.triangles.len()).filter(|&triangle| self.triangles.fluid[triangle]);
        fluid.map(|triangle| area(&self.triangles.vertices(triangle))).sum()
    }

    /// Whether the old cells still are as good as new ones: then they stay, lest a mesh at rest flickers.
    fn still_delaunay(&self, cloud: &Cloud<2, 3>) -> bool {
        cloud.cells.iter().zip(&cloud.neighbours).enumerate().all(|(c, (cell, around))| {
            let vertices = cloud.vertices(cell);
            area(&vertices) > 0.0
                && (0..3).filter(|&i| around[i] != OUTSIDE && (around[i] as usize) > c).all(|i| {
                    let other = &cloud.cells[around[i] as usize];
                    let apex = other.iter().find(|node| !cell.contains(node));
                    apex.is_some_and(|&apex| !inside_circle(&vertices, &cloud.place[apex as usize]))
                })
        })
    }

    /// Makes the fluid triangles the cells of the cloud, without the nodes that go.
    fn take_cells(&mut self, cloud: &mut Cloud<2, 3>) {
        self.number.clear();
        self.cells.clear();
        for (triangle, &fluid) in self.triangles.fluid.iter().enumerate() {
            self.number.push(if fluid { self.cells.len() as u32 } else { OUTSIDE });
            if fluid {
                self.cells.push(self.triangles.nodes(triangle));
            }
        }
        self.neighbours.clear();
        for triangle in (0..self.triangles.len()).filter(|&triangle| self.triangles.fluid[triangle]) {
            let number = |next: u32| self.number.get(next as usize).copied().unwrap_or(OUTSIDE);
            self.neighbours.push(self.triangles.neighbours(triangle).map(number));
        }
        std::mem::swap(&mut cloud.cells, &mut self.cells);
        std::mem::swap(&mut cloud.neighbours, &mut self.neighbours);
        self.draft.compact(cloud);
    }
}

/// Whether a point lies in the circle through the corners by more than round-off.
fn inside_circle(v: &[Vector<2>; 3], p: &Vector<2>) -> bool {
    let d = v.map(|x| [x[0] - p[0], x[1] - p[1]]);
    let square = d.map(|x| x[0] * x[0] + x[1] * x[1]);
    let cross = |i: usize, j: usize| d[i][0] * d[j][1] - d[i][1] * d[j][0];
    let determinant = square[0] * cross(1, 2) + square[1] * cross(2, 0) + square[2] * cross(0, 1);
    let scale = square.iter().copied().fold(0.0, f64::max);
    determinant > 1e-9 * scale * scale
}
