//! Remeshing in space: all nodes are triangulated, and cells that lie in the moved old mesh are fluid.
//!
//! Drops are nodes like others: one that the moved mesh has come to cover is thereby taken up. Surfaces merge where they
//! have passed each other: what lies twice is counted once.

mod correction;
mod management;
mod patches;
mod recognition;
mod stars;
mod surface;
mod tetrahedra;
mod unchanged;

use super::draft::Draft;
use super::recognition::Recognition;
use super::topology::Events;
use super::transfer;
use super::{Books, TargetSize, energy, volume};
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::Wall;
use crate::element::simplex::Vector;
use stars::Stars;
use tetrahedra::Tetrahedra;

/// A cover counted twice larger than this share of h³ is a blow of fluid on fluid.
const BLOW: f64 = 0.1;

/// Finds the mesh of moved nodes in space; all but the rule is scratch.
#[derive(Default)]
pub struct SpaceRemesher {
    /// How the fluid is told from the void.
    pub recognition: Recognition,
    draft: Draft<3>,
    stars: Stars,
    tetrahedra: Tetrahedra,
    gradient: Vec<Vector<3>>,
    volumes: Vec<f64>,
}

impl SpaceRemesher {
    /// A remesher with a rule.
    pub fn new(recognition: Recognition) -> Self {
        Self { recognition, ..Self::default() }
    }

    /// The mesh of a cloud whose nodes were moved: on entry its cells are those before the move.
    ///
    /// Σ m_i v_i over cells and drops (m_i a quarter of the cells around a node) is kept to round-off.
    ///
    /// # Errors
    /// A place that is not finite.
    pub fn remesh(
        &mut self,
        cloud: &mut Cloud<3, 4>,
        walls: &[Wall<3>],
        time: f64,
        size: &TargetSize,
        books: &mut Books<3>,
    ) -> Result<Events, delaunay::Error> {
        let Self { recognition, draft, stars, tetrahedra, gradient, volumes } = self;
        let energy_before = energy(cloud);
        draft.read_nodes(cloud, size);
        surface::read(cloud, draft);
        let momentum = transfer::momentum(&draft.mass, &cloud.velocity);
        let book = &mut books.volume;
        let moved = volume(cloud);
        book.flow.add(moved - book.cells);

        let missing = book.target - moved - cloud.drop.iter().sum::<f64>();
        correction::restore(cloud, draft, walls, time, missing, gradient);
        let restored = volume(cloud);
        book.correction.add(restored - moved);
        stars.read(cloud);
        management::manage(cloud, draft, walls, time);
        let managed = volume(cloud);
        book.management.add(managed - restored);

        let mut events = Events::default();
        if draft.edited || cloud.cells.is_empty() || !unchanged::still_delaunay(cloud) {
            tetrahedra.triangulate(cloud, draft)?;
            match *recognition {
                Recognition::MovedDomain => recognition::moved_domain(cloud, draft, stars, tetrahedra),
                Recognition::AlphaShape { alpha } => {
                    recognition::alpha_shape(cloud, draft, alpha, tetrahedra)
                }
            }
            let recognised = tetrahedra.fluid_volume(cloud);
            book.overlap.add(recognised - managed);
            let smallest = draft.size.iter().copied().fold(f64::INFINITY, f64::min);
            events.crossed = recognised < managed - BLOW * smallest.powi(3);
            patches::settle(cloud, draft, tetrahedra, book, &mut events);
            tetrahedra.take(cloud, draft);
        }
        transfer::keep_momentum(cloud, &draft.mass, momentum, volumes);
        if events.impact() {
            let surplus = energy(cloud).kinetic - energy_before.kinetic;
            transfer::take_surplus(cloud, &draft.mass, volumes, surplus);
        }
        book.cells = volume(cloud);
        book.drops = cloud.drop.iter().sum();
        books.energy.add(&energy_before, &energy(cloud));
        cloud.struck = events.impact();
        Ok(events)
    }
}
