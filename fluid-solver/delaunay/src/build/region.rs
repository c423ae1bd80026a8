//! A few cells of a mesh, triangulated anew between the faces around them.

use super::cavity::Cavity;
use super::mesh::{Cell, Face, GHOST, Mark, Mesh};
use super::rim::{Rim, Side};

/// A region of more cells is given up.
const MOST: usize = 400;

/// Cells of a mesh that are replaced by those of the Delaunay triangulation of their corners.
///
/// That has a part with the same boundary if the faces around the cells are among its own. Where one is not, the cell
/// behind it is taken in too. What replaces the cells is Delaunay inside; the faces around them remain to be looked at.
/// Each such step lowers the surface of the lifted points, so that no region comes back.
#[derive(Default)]
pub struct Region<const D: usize, const N: usize> {
    cells: Vec<u32>,
    /// Where the points that are corners of the region have been noted, by the number of the attempt.
    seen: Vec<u32>,
    attempt: u32,
    has_ghost: bool,
    rim: Rim<N>,
    local: Mesh<D, N>,
    cavity: Cavity<N>,
    /// For each local cell and face the side of the rim that it is.
    sides: Vec<[Side; N]>,
    taken: Vec<u32>,
    /// Where each local cell goes in the mesh.
    slot: Vec<u32>,
    /// Faces of the new cells on the rim.
    pub changed: Vec<Face>,
}

/// What an attempt came to.
enum Fit {
    /// The cells are replaced.
    Fits,
    /// More cells were taken in.
    Grown,
    /// Equal points, or points on one plane.
    Hopeless,
}

impl<const D: usize, const N: usize> Region<D, N> {
    /// Makes room for a mesh of so many points.
    pub fn make_room(&mut self, points: usize) {
        if self.seen.len() < points {
            self.seen.resize(points, 0);
        }
    }

    /// Triangulates the cells `from` anew, together with what must go with them; points that are gone are left out.
    ///
    /// Returns whether that could be done; if not, the mesh is spoilt.
    pub fn renew<const C: usize>(&mut self, mesh: &mut Mesh<D, N>, from: [u32; C]) -> bool {
        self.cells.clear();
        self.changed.clear();
        from.into_iter().for_each(|cell| self.take_in(mesh, cell));
        loop {
            self.spread(mesh);
            if self.cells.len() > MOST {
                return false;
            }
            match self.fit(mesh) {
                Fit::Fits => return true,
                Fit::Grown => {}
                Fit::Hopeless => return false,
            }
        }
    }

    fn take_in(&mut self, mesh: &mut Mesh<D, N>, cell: u32) {
        if mesh.marks[cell as usize] != Mark::Inside {
            mesh.marks[cell as usize] = Mark::Inside;
            self.cells.push(cell);
        }
    }

    /// Takes in neighbours that are wrong, and those across faces with a corner that is gone; collects the rim.
    fn spread(&mut self, mesh: &mut Mesh<D, N>) {
        let mut next = 0;
        while let Some(&cell) = self.cells.get(next) {
            next += 1;
            let Cell { corners, neighbours, .. } = *mesh.cell(cell);
            for at in 0..N {
                let other = neighbours[at].cell();
                let gone = (0..N).any(|k| k != at && mesh.is_gone(corners[k]));
                if gone || mesh.marks[other as usize] == Mark::Wrong {
                    self.take_in(mesh, other);
                }
            }
        }
        self.rim.clear();
        for &cell in &self.cells {
            let Cell { corners, neighbours, .. } = mesh.cell(cell);
            for at in 0..N {
                let outside = neighbours[at];
                if mesh.marks[outside.cell() as usize] != Mark::Inside {
                    let apex = mesh.cell(outside.cell()).corners[outside.opposite()];
                    self.rim.push(corners, at, (outside, apex));
                }
            }
        }
        self.rim.index();
    }

    /// Triangulates the corners and puts the part inside of the rim in the place of the cells, or takes more cells in.
    fn fit(&mut self, mesh: &mut Mesh<D, N>) -> Fit {
        if !self.collect_points(mesh) {
            return Fit::Hopeless;
        }
        if !self.local.plant() {
            // Points on one plane: with more of them they may span a cell.
            self.take_in_behind(mesh, |_| true);
            return if self.rim.is_empty() { Fit::Hopeless } else { Fit::Grown };
        }
        self.cavity.make_room(self.local.points.len());
        let mut last = 0;
        for point in N as u32 + 1..self.local.points.len() as u32 {
            let seed = self.local.find(last, point);
            last = self.cavity.insert(&mut self.local, point, seed);
        }
        self.find_sides();
        if !self.rim.is_complete() {
            self.take_in_behind(mesh, |found| !found);
            return Fit::Grown;
        }
        if !self.fill() {
            if self.rim.is_empty() {
                return Fit::Hopeless;
            }
            self.take_in_behind(mesh, |_| true);
            return Fit::Grown;
        }
        self.replace(mesh);
        Fit::Fits
    }

    /// Copies the corners of the cells to the local mesh; whether no two of them are equal.
    fn collect_points(&mut self, mesh: &Mesh<D, N>) -> bool {
        let Self { local, seen, .. } = self;
        if self.attempt == u32::MAX {
            seen.fill(0);
            self.attempt = 0;
        }
        self.attempt += 1;
        self.has_ghost = false;
        for list in [&mut local.ranks, &mut local.names, &mut local.free] {
            list.clear();
        }
        local.points.clear();
        local.points.push([f64::NAN; D]);
        local.ranks.push(0);
        local.names.push(GHOST);
        for &corner in self.cells.iter().flat_map(|cell| &mesh.cell(*cell).corners) {
            self.has_ghost |= corner == GHOST;
            let new = std::mem::replace(&mut seen[corner as usize], self.attempt) != self.attempt;
            if new && corner != GHOST && !mesh.is_gone(corner) {
                local.points.push(*mesh.point(corner));
                local.ranks.push(mesh.ranks[corner as usize]);
                local.names.push(corner);
            }
        }
        let points = &local.points;
        (1..points.len()).all(|a| (1..a).all(|b| points[a] != points[b]))
    }

    /// Finds the faces of the local cells that are those of the rim, seen from the same side.
    fn find_sides(&mut self) {
        let Self { local, rim, sides, has_ghost, .. } = self;
        sides.clear();
        for (index, cell) in local.cells.iter().enumerate() {
            let free = local.marks[index] == Mark::Free;
            // A region inside of the hull is filled by cells inside of the hull.
            let out = !*has_ghost && cell.corners.contains(&GHOST);
            sides.push(if free || out {
                [Side::None; N]
            } else {
                let corners = cell.corners.map(|corner| local.names[corner as usize]);
                std::array::from_fn(|at| rim.find(&corners, at))
            });
        }
    }

    /// Collects the local cells inside of the rim; whether nothing else can be reached and all points are among their corners.
    fn fill(&mut self) -> bool {
        let Self { local, sides, taken, has_ghost, .. } = self;
        taken.clear();
        for (index, sides) in sides.iter().enumerate() {
            if sides.iter().any(|side| *side != Side::None) {
                local.marks[index] = Mark::Inside;
                taken.push(index as u32);
            }
        }
        let mut next = 0;
        let mut corners = 0;
        while let Some(&cell) = taken.get(next) {
            next += 1;
            let this = local.cells[cell as usize];
            if !*has_ghost && this.corners.contains(&GHOST) {
                return false;
            }
            for corner in this.corners.into_iter().filter(|corner| *corner != GHOST) {
                // Ranks have served: a corner that was met has none.
                let rank = &mut local.ranks[corner as usize];
                corners += usize::from(std::mem::replace(rank, u32::MAX) != u32::MAX);
            }
            for at in 0..N {
                let other = this.neighbours[at];
                if sides[cell as usize][at] != Side::None {
                    continue;
                }
                if sides[other.cell() as usize][other.opposite()] != Side::None {
                    return false;
                }
                if local.marks[other.cell() as usize] != Mark::Inside {
                    local.marks[other.cell() as usize] = Mark::Inside;
                    taken.push(other.cell());
                }
            }
        }
        corners + 1 == local.points.len()
    }

    /// Puts the local cells into the mesh.
    fn replace(&mut self, mesh: &mut Mesh<D, N>) {
        let Self { local, sides, taken, slot, rim, cells, changed, .. } = self;
        slot.clear();
        slot.resize(local.cells.len(), 0);
        for (k, cell) in taken.iter().enumerate() {
            slot[*cell as usize] = if k < cells.len() { cells[k] } else { mesh.place() };
        }
        for &cell in &*taken {
            let Cell { corners, neighbours, sphere } = local.cells[cell as usize];
            let here = slot[cell as usize];
            let neighbours = std::array::from_fn(|at| match sides[cell as usize][at] {
                Side::None => Face::new(slot[neighbours[at].cell() as usize], neighbours[at].opposite()),
                Side::Of(face) => {
                    let outside = rim.outside(face);
                    let inside = Face::new(here, at);
                    mesh.cells[outside.cell() as usize].neighbours[outside.opposite()] = inside;
                    changed.push(inside);
                    outside
                }
            });
            let corners = corners.map(|corner| local.names[corner as usize]);
            mesh.cells[here as usize] = Cell { corners, neighbours, sphere };
            mesh.marks[here as usize] = Mark::Open;
        }
        for &cell in cells.iter().skip(taken.len()) {
            mesh.marks[cell as usize] = Mark::Free;
            mesh.free.push(cell);
        }
    }

    /// Takes in the cells behind faces of the rim, chosen by whether the face was found.
    fn take_in_behind(&mut self, mesh: &mut Mesh<D, N>, chosen: impl Fn(bool) -> bool) {
        for face in 0..self.rim.len() {
            if chosen(self.rim.is_found(face)) {
                let cell = self.rim.outside(face as u32).cell();
                self.take_in(mesh, cell);
            }
        }
    }
}
