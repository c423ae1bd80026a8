//! Remeshing in space: all nodes are triangulated, and cells that lie in the moved surface are fluid.
//!
//! Drops are nodes like others: one that the moved mesh has come to cover is thereby taken up. Surfaces merge where they
//! have passed each other: what lies twice is counted once.

mod correction;
mod fans;
mod freedom;
mod management;
mod patches;
mod recognition;
mod surface;
mod tetrahedra;
mod unchanged;

use super::books::volumes;
use super::draft::Draft;
use super::recognition::Recognition;
use super::spent::Spent;
use super::topology::Events;
use super::transfer;
use super::{Books, Energy, TargetSize};
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::renewal::Renewal;
use crate::backend::pfem::wall::Wall;
use crate::element::simplex::Vector;
use interface::usage::ThreadClock;
use management::Management;
use patches::Patches;
use recognition::Recogniser;
use tetrahedra::Tetrahedra;

/// A gap that closed is told of where it is larger than this share of h³.
const BLOW: f64 = 0.1;

/// Finds the mesh of moved nodes in space; all but the rule and what was spent is scratch.
#[derive(Default)]
pub struct SpaceRemesher {
    /// How the fluid is told from the void.
    pub recognition: Recognition,
    /// What volume is lifted against (m/s²): its potential energy may not come from nothing.
    acceleration: Vector<3>,
    spent: Spent,
    draft: Draft<3>,
    management: Management,
    tetrahedra: Tetrahedra,
    recogniser: Recogniser,
    patches: Patches,
    gradient: Vec<Vector<3>>,
    node_volumes: Vec<f64>,
}

impl SpaceRemesher {
    /// A remesher with a rule.
    pub fn new(recognition: Recognition) -> Self {
        Self { recognition, ..Self::default() }
    }

    /// That of a fluid under an acceleration (m/s²).
    pub fn under(self, acceleration: Vector<3>) -> Self {
        Self { acceleration, ..self }
    }
}

impl Renewal<3, 4> for SpaceRemesher {
    fn remesh(
        &mut self,
        cloud: &mut Cloud<3, 4>,
        walls: &[Wall<3>],
        time: f64,
        size: &TargetSize,
        books: &mut Books<3>,
    ) -> Result<Events, delaunay::Error> {
        let Self { spent, draft, tetrahedra, node_volumes, .. } = self;
        let mut clock = ThreadClock::start();
        draft.read_sizes(cloud, size);
        volumes(cloud, &mut draft.mass);
        let energy_before = Energy::of(cloud, &draft.mass);
        let momentum = transfer::momentum(&draft.mass, &cloud.velocity);
        spent.transfer += clock.lap();

        surface::read(cloud, draft);
        let book = &mut books.volume;
        let moved = surface::enclosed(cloud, draft);
        book.flow.add(moved - book.cells);
        let missing = book.target - moved - cloud.drop.iter().sum::<f64>();
        correction::restore(cloud, draft, walls, time, missing, &mut self.gradient);
        let restored = surface::enclosed(cloud, draft);
        book.correction.add(restored - moved);
        self.management.manage(cloud, draft, walls, time);
        let managed = surface::enclosed(cloud, draft);
        book.management.add(managed - restored);
        let stays = unchanged::stays(cloud, draft);
        spent.management += clock.lap();

        let (mut events, mut settled) = (Events::default(), 0.0);
        if !stays {
            tetrahedra.triangulate(cloud, draft)?;
            spent.mesh += clock.lap();
            self.recogniser.recognise(self.recognition, cloud, draft, tetrahedra);
            spent.recognition += clock.lap();
            settled = self.patches.settle(cloud, draft, tetrahedra, (walls, time), book, &mut events);
            tetrahedra.take(cloud, draft);
            spent.settling += clock.lap();
        }
        book.cells = volumes(cloud, node_volumes);
        book.drops = cloud.drop.iter().sum();
        if !stays {
            let overlap = managed + settled - book.cells;
            book.overlap.add(-overlap);
            let smallest = draft.size.iter().copied().fold(f64::INFINITY, f64::min);
            events.closed = u32::from(overlap < -BLOW * smallest.powi(3));
        }
        transfer::keep_momentum(cloud, &draft.mass, momentum, node_volumes);
        let volumes = (&*draft.mass, &**node_volumes);
        transfer::keep_energy(cloud, volumes, &energy_before, &self.acceleration, &mut books.energy);
        cloud.relieve_drops();
        spent.transfer += clock.lap();
        Ok(events)
    }

    fn spent(&self) -> Spent {
        self.spent
    }
}
