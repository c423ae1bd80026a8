//! Cells while points are inserted: those of the triangulation and a ghost behind every face of its hull.

use crate::HULL;
#[cfg(doc)]
use crate::predicate::circumsphere;

/// The ghost: the corner at infinity of the cells behind the hull. It is point 0; its coordinates are not numbers.
pub const GHOST: u32 = 0;

/// A cell and how it hangs together.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct Cell<const N: usize> {
    /// Corners, as places in [`Mesh::points`].
    pub corners: [u32; N],
    /// The face of the neighbour that is the one opposite to each corner.
    pub neighbours: [Face; N],
    /// Its circumsphere, as [`circumsphere`] gives it.
    pub sphere: [f64; N],
}

/// The face of a cell opposite to one of its corners.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub struct Face(u32);

impl Face {
    #[inline(always)]
    pub fn new(cell: u32, opposite: usize) -> Self {
        Self(cell << 2 | opposite as u32)
    }

    #[inline(always)]
    pub fn cell(self) -> u32 {
        self.0 >> 2
    }

    #[inline(always)]
    pub fn opposite(self) -> usize {
        (self.0 & 3) as usize
    }
}

/// What the insertion under way knows of a cell.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// Nothing yet.
    Open,
    /// The point conflicts with it: it lies in the cavity.
    Inside,
    /// The point does not.
    Outside,
    /// The cell is none: its place is free.
    Free,
    /// The cell is turned over, or a corner of it is gone.
    Wrong,
}

/// Points in the order of insertion and the cells between them.
#[derive(Default)]
pub struct Mesh<const D: usize, const N: usize> {
    /// Scaled points; the first is the ghost.
    pub points: Vec<[f64; D]>,
    /// Ranks of the points.
    pub ranks: Vec<u32>,
    /// Their indices with the caller; [`HULL`] for the ghost and for points that are gone.
    pub names: Vec<u32>,
    /// Cells.
    pub cells: Vec<Cell<N>>,
    /// Marks of the cells.
    pub marks: Vec<Mark>,
    /// Places of cells that are free.
    pub free: Vec<u32>,
    /// Places of points that are free.
    pub spare: Vec<u32>,
}

impl<const D: usize, const N: usize> Mesh<D, N> {
    #[inline(always)]
    pub fn point(&self, point: u32) -> &[f64; D] {
        &self.points[point as usize]
    }

    #[inline(always)]
    pub fn cell(&self, cell: u32) -> &Cell<N> {
        &self.cells[cell as usize]
    }

    /// Coordinates of the corners of a cell.
    #[inline(always)]
    pub fn places(&self, cell: &Cell<N>) -> [&[f64; D]; N] {
        cell.corners.map(|corner| self.point(corner))
    }

    /// Makes two cells neighbours across a face.
    #[inline(always)]
    pub fn join(&mut self, a: Face, b: Face) {
        self.cells[a.cell() as usize].neighbours[a.opposite()] = b;
        self.cells[b.cell() as usize].neighbours[b.opposite()] = a;
    }

    /// Takes points in the order of insertion, behind the ghost; there are no cells yet.
    pub fn line_up(&mut self, order: &[u32], places: &[[f64; D]], ranks: &[u32]) {
        self.points.clear();
        self.points.push([f64::NAN; D]);
        self.points.extend(order.iter().map(|point| places[*point as usize]));
        self.ranks.clear();
        self.ranks.push(0);
        self.ranks.extend(order.iter().map(|point| ranks[*point as usize]));
        self.names.clear();
        self.names.push(HULL);
        self.names.extend(order);
        self.cells.clear();
        self.marks.clear();
        self.free.clear();
        self.spare.clear();
        // Cells per random point, and some more.
        let expected = order.len() * if D == 2 { 2 } else { 7 };
        self.cells.reserve(expected);
        self.marks.reserve(expected);
    }

    /// Whether a point is the mesh's no more.
    #[inline(always)]
    pub fn is_gone(&self, point: u32) -> bool {
        point != GHOST && self.names[point as usize] == HULL
    }

    /// Whether a cell stands behind the hull.
    pub fn is_ghost(&self, cell: u32) -> bool {
        self.cell(cell).corners.contains(&GHOST)
    }

    /// Some cell that is no ghost.
    pub fn any_cell(&self) -> Option<u32> {
        let open = |cell: &u32| self.marks[*cell as usize] != Mark::Free;
        (0..self.cells.len() as u32).filter(open).find(|cell| !self.is_ghost(*cell))
    }

    /// A place for a new cell.
    #[inline(always)]
    pub fn place(&mut self) -> u32 {
        if let Some(place) = self.free.pop() {
            return place;
        }
        self.cells.push(Cell {
            corners: [GHOST; N],
            neighbours: [Face::default(); N],
            sphere: [f64::NAN; N],
        });
        self.marks.push(Mark::Free);
        (self.cells.len() - 1) as u32
    }
}
