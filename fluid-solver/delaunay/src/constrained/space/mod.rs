//! Faces put into a triangulation in space, without new points.

mod crossing;
mod fill;
mod signs;

use crate::predicate::FACE;
use crate::{Error, HULL, Triangulation, points};
use crossing::Scene;
use fill::Fill;
use signs::Signs;

/// Puts faces into a triangulation where its cells can give way: those that a face passes through, and if that is not enough
/// those around them, are replaced by others between the same points. Not all faces can be there: some sets of faces, such
/// as the sides of Schönhardt's polyhedron, have no tetrahedra behind them without points of their own. All but what it did
/// is scratch.
#[derive(Clone, Debug, Default)]
pub struct Recovery {
    scaled: Vec<[f64; 3]>,
    incident: Vec<u32>,
    /// The cells that each face passes through.
    crossed: Vec<Vec<u32>>,
    /// The lot that each face belongs to.
    lot: Vec<usize>,
    /// Cells that were replaced, or are new.
    changed: Vec<bool>,
    /// Cells that are none any more.
    dead: Vec<u32>,
    cavity: Cavity,
    fill: Fill,
}

/// Cells to be replaced, and what is around them.
#[derive(Clone, Debug, Default)]
struct Cavity {
    /// Rising.
    cells: Vec<u32>,
    /// Their corners, rising.
    corners: Vec<u32>,
    /// Sides that need a cell.
    sides: Vec<[u8; 3]>,
    /// Faces behind which other cells are, by their rising corners: the cell or [`HULL`], and its corner opposite.
    rim: Vec<([u8; 3], u32, u8)>,
}

impl Recovery {
    /// Puts in those of the faces `missing` that can be, whichever way round. Faces of `made` of which `kept` is true stay;
    /// so does the hull. Cells are positive as before, but no more Delaunay, nor in order.
    ///
    /// Returns how many lots of faces were put in: those that pass through the same cells come together or one by one.
    ///
    /// # Errors
    /// Coordinates that are not finite, more than 10⁸ points.
    pub fn recover(
        &mut self,
        points: &[[f64; 3]],
        made: &mut Triangulation<4>,
        missing: &[[u32; 3]],
        kept: impl Fn([u32; 3]) -> bool,
    ) -> Result<usize, Error> {
        if missing.is_empty() {
            return Ok(0);
        }
        points::scale(points, &mut self.scaled)?;
        self.find_incident(made, points.len());
        self.changed.clear();
        self.changed.resize(made.cells.len(), false);
        self.dead.clear();
        self.crossed.resize(missing.len(), vec![]);
        for (face, cells) in missing.iter().zip(&mut self.crossed) {
            Scene { points: &self.scaled, made, incident: &self.incident }.crossed(*face, cells);
        }
        self.sort_into_lots(missing.len(), made.cells.len());
        let mut done = 0;
        for first in 0..missing.len() {
            if self.lot[first] != first || self.crossed[first].is_empty() {
                continue;
            }
            let lot = (first..missing.len()).filter(|face| self.lot[*face] == first).collect::<Vec<_>>();
            if self.put_in(made, missing, &lot, &kept) {
                done += 1;
            } else if lot.len() > 1 {
                done += lot.iter().filter(|face| self.put_in(made, missing, &[**face], &kept)).count();
            }
        }
        self.bury(made);
        Ok(done)
    }

    fn find_incident(&mut self, made: &Triangulation<4>, points: usize) {
        self.incident.clear();
        self.incident.resize(points, HULL);
        for (index, cell) in made.cells.iter().enumerate() {
            cell.iter().for_each(|corner| self.incident[*corner as usize] = index as u32);
        }
    }

    /// Faces that pass through the same cells are of one lot, that of the first of them.
    fn sort_into_lots(&mut self, faces: usize, cells: usize) {
        self.lot.clear();
        self.lot.extend(0..faces);
        let mut first = vec![usize::MAX; cells];
        for face in 0..faces {
            for &cell in &self.crossed[face] {
                let other = std::mem::replace(&mut first[cell as usize], face);
                if other != usize::MAX {
                    let (a, b) = (root(&self.lot, other), root(&self.lot, face));
                    self.lot[a.max(b)] = a.min(b);
                }
            }
        }
        for face in 0..faces {
            self.lot[face] = root(&self.lot, face);
        }
    }

    /// Puts a lot of faces in; whether that was possible.
    fn put_in(
        &mut self,
        made: &mut Triangulation<4>,
        missing: &[[u32; 3]],
        lot: &[usize],
        kept: &impl Fn([u32; 3]) -> bool,
    ) -> bool {
        self.cavity.cells.clear();
        for &face in lot {
            if self.crossed[face].iter().any(|cell| self.changed[*cell as usize]) {
                let scene = Scene { points: &self.scaled, made, incident: &self.incident };
                scene.crossed(missing[face], &mut self.crossed[face]);
            }
            self.cavity.cells.extend(&self.crossed[face]);
        }
        for widened in [false, true] {
            if widened {
                self.cavity.widen(made);
            }
            self.cavity.cells.sort_unstable();
            self.cavity.cells.dedup();
            if !self.cavity.read(made, lot.iter().map(|face| missing[*face]), kept) {
                return false;
            }
            let Self { cavity, scaled, fill, .. } = self;
            fill.signs.read(cavity.corners.iter().map(|corner| scaled[*corner as usize]));
            if fill.search(&cavity.sides) && self.replace(made) {
                return true;
            }
        }
        false
    }

    /// Replaces the cells of the cavity by those found; whether their faces match.
    fn replace(&mut self, made: &mut Triangulation<4>) -> bool {
        let Self { cavity, fill, changed, dead, incident, .. } = self;
        let mut faces = std::mem::take(&mut cavity.rim);
        let slot = |index: usize| match cavity.cells.get(index) {
            Some(cell) => *cell,
            None => (made.cells.len() + index - cavity.cells.len()) as u32,
        };
        for (index, cell) in fill.found.iter().enumerate() {
            for at in 0..4 {
                let mut face = FACE[at].map(|k| cell[k]);
                face.sort_unstable();
                faces.push((face, slot(index), at as u8));
            }
        }
        faces.sort_unstable();
        let matched = faces.chunk_by(|a, b| a.0 == b.0).all(|same| same.len() == 2);
        if matched {
            let slots = (0..fill.found.len()).map(slot).collect::<Vec<_>>();
            dead.extend(cavity.cells.iter().skip(slots.len()));
            let cells = made.cells.len().max(slots.iter().max().map_or(0, |last| *last as usize + 1));
            made.cells.resize(cells, [HULL; 4]);
            made.neighbours.resize(cells, [HULL; 4]);
            changed.resize(cells, true);
            cavity.cells.iter().for_each(|cell| changed[*cell as usize] = true);
            for (local, cell) in fill.found.iter().zip(slots) {
                made.cells[cell as usize] = local.map(|point| cavity.corners[usize::from(point)]);
                made.cells[cell as usize].iter().for_each(|corner| incident[*corner as usize] = cell);
            }
            for pair in faces.chunks_exact(2) {
                let [(_, one, at), (_, other, opposite)] = [pair[0], pair[1]];
                for (cell, at, next) in [(one, at, other), (other, opposite, one)] {
                    if cell != HULL {
                        made.neighbours[cell as usize][usize::from(at)] = next;
                    }
                }
            }
        }
        cavity.rim = faces;
        matched
    }

    /// Takes the cells out that are none any more: the last ones take their places.
    fn bury(&mut self, made: &mut Triangulation<4>) {
        self.dead.sort_unstable();
        while let Some(gone) = self.dead.pop() {
            let last = made.cells.len() as u32 - 1;
            made.cells.swap_remove(gone as usize);
            made.neighbours.swap_remove(gone as usize);
            if gone != last {
                for next in made.neighbours[gone as usize] {
                    if next != HULL {
                        let back = made.neighbours[next as usize].iter_mut().find(|other| **other == last);
                        *back.expect("neighbours know each other") = gone;
                    }
                }
            }
        }
    }
}

impl Cavity {
    /// Takes the cells around in.
    fn widen(&mut self, made: &Triangulation<4>) {
        for index in 0..self.cells.len() {
            let around = made.neighbours[self.cells[index] as usize];
            self.cells.extend(around.iter().filter(|next| **next != HULL));
        }
    }

    /// Reads what is around the cells, and the faces that shall be between them; false if they have too many corners.
    fn read(
        &mut self,
        made: &Triangulation<4>,
        missing: impl Iterator<Item = [u32; 3]>,
        kept: &impl Fn([u32; 3]) -> bool,
    ) -> bool {
        let Self { cells, corners, sides, rim } = self;
        corners.clear();
        corners.extend(cells.iter().flat_map(|cell| made.cells[*cell as usize]));
        corners.sort_unstable();
        corners.dedup();
        if corners.is_empty() || corners.len() > Signs::MOST {
            return false;
        }
        let local = |corner: u32| corners.binary_search(&corner).ok().map(|at| at as u8);
        sides.clear();
        rim.clear();
        for face in missing {
            let [Some(a), Some(b), Some(c)] = face.map(local) else { return false };
            sides.extend([[a, b, c], [a, c, b]]);
        }
        for &cell in &*cells {
            for (at, &next) in made.neighbours[cell as usize].iter().enumerate() {
                let face = FACE[at].map(|k| made.cells[cell as usize][k]);
                let inner = next != HULL && cells.binary_search(&next).is_ok();
                if inner && !kept(face) {
                    continue;
                }
                // A face that is kept between two of the cells is met from either.
                let [Some(a), Some(b), Some(c)] = face.map(local) else { return false };
                sides.push([a, b, c]);
                if !inner {
                    let mut known = [a, b, c];
                    known.sort_unstable();
                    let back = |next: u32| made.neighbours[next as usize].iter().position(|n| *n == cell);
                    let back = if next == HULL { 0 } else { back(next).expect("neighbours know each other") };
                    rim.push((known, next, back as u8));
                }
            }
        }
        true
    }
}

/// The first face of a lot.
fn root(lot: &[usize], mut face: usize) -> usize {
    while lot[face] != face {
        face = lot[face];
    }
    face
}
