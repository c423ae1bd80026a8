//! Triangulation of points, with the scratch that it needs.

use crate::build::{Cavity, GHOST, Mark, Mesh, Order};
use crate::{Error, HULL, Triangulation, points};

/// Triangulates points in D dimensions, `N = D + 1`, again and again: its memory is reused from call to call.
#[derive(Default)]
pub struct Delaunay<const D: usize, const N: usize> {
    scaled: Vec<[f64; D]>,
    order: Order,
    mesh: Mesh<D, N>,
    cavity: Cavity<N>,
    number: Vec<u32>,
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
    /// The result depends on `points` and `rank` alone. Coordinates below 10⁻³⁰ of the largest are read as zero.
    ///
    /// # Errors
    /// Coordinates that are not finite, ranks that do not match the points, more than 10⁸ points.
    pub fn triangulate(&mut self, points: &[[f64; D]], rank: &[u32]) -> Result<&Triangulation<N>, Error> {
        if rank.len() != points.len() {
            return Err(Error::Ranks { points: points.len(), ranks: rank.len() });
        }
        points::scale(points, &mut self.scaled)?;
        self.order.sort(&self.scaled, rank);
        self.line_up(rank);
        self.build();
        self.hand_over();
        Ok(&self.triangulation)
    }

    /// Takes the triangulation made last, and gives memory for the next one.
    pub fn swap(&mut self, triangulation: &mut Triangulation<N>) {
        std::mem::swap(&mut self.triangulation, triangulation);
    }

    /// Copies the points to the mesh in the order of insertion, behind the ghost.
    fn line_up(&mut self, rank: &[u32]) {
        let Self { mesh, order, scaled, .. } = self;
        mesh.points.clear();
        mesh.points.push([f64::NAN; D]);
        mesh.points.extend(order.points.iter().map(|point| scaled[*point as usize]));
        mesh.ranks.clear();
        mesh.ranks.push(0);
        mesh.ranks.extend(order.points.iter().map(|point| rank[*point as usize]));
        mesh.names.clear();
        mesh.names.push(HULL);
        mesh.names.extend(&order.points);
        mesh.cells.clear();
        mesh.marks.clear();
        mesh.free.clear();
        // Cells per random point, and some more.
        let expected = order.points.len() * if D == 2 { 2 } else { 7 };
        mesh.cells.reserve(expected);
        mesh.marks.reserve(expected);
    }

    fn build(&mut self) {
        let Self { mesh, cavity, .. } = self;
        if !mesh.plant() {
            return;
        }
        cavity.reset(mesh.points.len());
        let mut last = 0;
        for point in N as u32 + 1..mesh.points.len() as u32 {
            let seed = mesh.find(last, point);
            last = cavity.insert(mesh, point, seed);
        }
    }

    /// Copies the cells that are no ghosts to the triangulation.
    fn hand_over(&mut self) {
        let Self { mesh, order, number, triangulation, .. } = self;
        let real = |cell: usize| mesh.marks[cell] != Mark::Free && !mesh.cells[cell].corners.contains(&GHOST);
        number.clear();
        let mut count = 0;
        number.extend((0..mesh.cells.len()).map(|cell| {
            let here = real(cell);
            count += u32::from(here);
            if here { count - 1 } else { HULL }
        }));
        triangulation.cells.clear();
        triangulation.cells.reserve(count as usize);
        triangulation.neighbours.clear();
        triangulation.neighbours.reserve(count as usize);
        for cell in (0..mesh.cells.len()).filter(|cell| number[*cell] != HULL) {
            let cell = &mesh.cells[cell];
            triangulation.cells.push(cell.corners.map(|corner| mesh.names[corner as usize]));
            triangulation.neighbours.push(cell.neighbours.map(|face| number[face.cell() as usize]));
        }
        triangulation.twins.clear();
        triangulation.twins.extend(&order.twins);
    }
}
