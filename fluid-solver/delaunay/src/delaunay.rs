//! Triangulation of points, with the scratch that it needs.

use crate::build::{Cavity, Mesh, Order, Repair};
use crate::canonical::Canonical;
use crate::points::{self, Scale};
use crate::survivors::Survivors;
use crate::{Error, HULL, Triangulation};

/// Triangulates points in D dimensions, `N = D + 1`, again and again: its memory is reused from call to call, and so is the
/// last mesh where most points have stayed and moved a little.
#[derive(Default)]
pub struct Delaunay<const D: usize, const N: usize> {
    pub(crate) scale: Scale,
    /// Points, scaled.
    pub(crate) scaled: Vec<[f64; D]>,
    /// Their ranks.
    pub(crate) ranks: Vec<u32>,
    order: Order,
    pub(crate) mesh: Mesh<D, N>,
    pub(crate) cavity: Cavity<N>,
    pub(crate) repair: Repair<D, N>,
    survivors: Survivors,
    canonical: Canonical<N>,
    /// Whether the mesh is the triangulation of the points, none of which equals another.
    pub(crate) kept: bool,
    /// Whether the last call or edit kept most of the mesh.
    pub(crate) reused: bool,
    /// The cell where the last edit was.
    pub(crate) near: u32,
    triangulation: Triangulation<N>,
}

impl<const D: usize, const N: usize> Delaunay<D, N> {
    const DIMENSIONS: () = assert!((D == 2 || D == 3) && N == D + 1);

    /// No triangulation yet.
    pub fn new() -> Self {
        const { Self::DIMENSIONS };
        Self::default()
    }

    /// Delaunay triangulation of `points`; of those on a common sphere, `rank`, one per point, decides which cells they
    /// make. Points on one plane (in 2D: line), or fewer than N, have no cells.
    ///
    /// The result depends on `points` and `rank` alone, the order of the cells included. Coordinates below 10⁻³⁰ of the
    /// largest are read as zero. If ranks rise strictly from point to point, a point with a rank of the last call is taken
    /// for the one that had it, and the last mesh is repaired where that takes less time than a new one.
    ///
    /// # Errors
    /// Coordinates that are not finite, ranks that do not match the points, more than 10⁸ points.
    pub fn triangulate(&mut self, points: &[[f64; D]], rank: &[u32]) -> Result<&Triangulation<N>, Error> {
        if rank.len() != points.len() {
            return Err(Error::Ranks { points: points.len(), ranks: rank.len() });
        }
        self.scale = points::scale(points, &mut self.scaled)?;
        self.reused = std::mem::take(&mut self.kept) && self.reuse(rank);
        self.ranks.clear();
        self.ranks.extend(rank);
        self.kept = self.reused;
        if !self.reused {
            self.build();
        }
        Ok(self.hand_over())
    }

    /// Whether the last call or edit kept what it could of the mesh before it, in place of a new one.
    pub fn was_reused(&self) -> bool {
        self.reused
    }

    /// Takes the triangulation made last, and gives memory for the next one.
    pub fn swap(&mut self, triangulation: &mut Triangulation<N>) {
        std::mem::swap(&mut self.triangulation, triangulation);
    }

    /// Moves the points of the last mesh, which had `self.ranks`, and repairs it; whether that was worth the while.
    fn reuse(&mut self, rank: &[u32]) -> bool {
        let Self { mesh, repair, cavity, survivors, scaled, ranks, .. } = self;
        // Places of points that are gone stay empty in the mesh; and the order of insertion is that of memory.
        let outgrown = 4 * mesh.points.len() > 5 * rank.len();
        if outgrown || !survivors.find(ranks, rank) {
            return false;
        }
        for point in 1..mesh.points.len() {
            let name = &mut mesh.names[point];
            if *name != HULL {
                *name = survivors.now[*name as usize];
                // Whatever has a point that is gone is in doubt, as what has one that is not a number.
                mesh.points[point] = scaled.get(*name as usize).copied().unwrap_or([f64::NAN; D]);
            }
        }
        if !repair.repair(mesh) {
            return false;
        }
        cavity.make_room(mesh.points.len() + survivors.new.len());
        let Some(mut near) = mesh.any_cell() else { return false };
        for &name in &survivors.new {
            let place = scaled[name as usize];
            match mesh.add(cavity, near, (place, rank[name as usize], name)) {
                Some(cell) => near = cell,
                None => return false,
            }
        }
        true
    }

    /// Triangulates `self.scaled` anew.
    pub(crate) fn build(&mut self) {
        let Self { mesh, order, scaled, ranks, cavity, kept, reused, .. } = self;
        (*kept, *reused) = (false, false);
        order.sort(scaled, ranks);
        mesh.line_up(&order.points, scaled, ranks);
        if !mesh.plant() {
            return;
        }
        cavity.make_room(mesh.points.len());
        let mut last = 0;
        for point in N as u32 + 1..mesh.points.len() as u32 {
            let seed = mesh.find(last, point);
            last = cavity.insert(mesh, point, seed);
        }
        *kept = order.twins.is_empty();
    }

    /// Copies the cells that are no ghosts to the triangulation.
    pub(crate) fn hand_over(&mut self) -> &Triangulation<N> {
        let Self { mesh, order, scaled, canonical, triangulation, kept, .. } = self;
        canonical.copy(mesh, scaled.len(), triangulation);
        triangulation.twins.clear();
        if !*kept {
            triangulation.twins.extend(&order.twins);
        }
        triangulation
    }
}
