//! Faces put into a triangulation in space, without new points.

mod crossing;
mod fill;
mod signs;

use super::find_incident;
use crate::predicate::space::FACE;
use crate::{Error, HULL, Triangulation, points};
use crossing::Scene;
use fill::Fill;
use signs::Signs;

/// Puts faces into a triangulation where its cells can give way: those that a face passes through, and if that is not enough
/// those around them, are replaced by others between the same points. Not all faces can be there: some sets of faces, such
/// as the sides of Schönhardt's polyhedron, have no tetrahedra behind them without points of their own. All of it is scratch.
#[derive(Clone, Debug, Default)]
pub struct Recovery {
    scaled: Vec<[f64; 3]>,
    incident: Vec<u32>,
    /// The cells that each face passes through.
    crossed: Vec<Vec<u32>>,
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
    /// Puts in those of the faces `missing` that can be, whichever way round; each has three different corners. Faces of `made`
    /// of which `kept` is true stay; so does the hull. Cells are positive as before, but no more Delaunay, nor in order.
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
        find_incident(&made.cells, points.len(), &mut self.incident);
        self.changed.clear();
        self.changed.resize(made.cells.len(), false);
        self.dead.clear();
        self.crossed.resize(missing.len(), vec![]);
        for (face, cells) in missing.iter().zip(&mut self.crossed) {
            Scene { points: &self.scaled, made, incident: &self.incident }.crossed(*face, cells);
        }
        let mut done = 0;
        for lot in self.lots() {
            if self.put_in(made, missing, &lot, &kept) {
                done += 1;
            } else if lot.len() > 1 {
                done += lot.iter().filter(|face| self.put_in(made, missing, &[**face], &kept)).count();
            }
        }
        self.bury(made);
        Ok(done)
    }

    /// Faces that pass through the same cells are of one lot; those that pass through none are of none.
    fn lots(&self) -> Vec<Vec<usize>> {
        let crossed = self.crossed.iter().enumerate();
        let mut met: Vec<_> =
            crossed.flat_map(|(face, cells)| cells.iter().map(move |cell| (*cell, face))).collect();
        met.sort_unstable();
        let mut joined: Vec<usize> = (0..self.crossed.len()).collect();
        for pair in met.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            let (a, b) = (first(&joined, pair[0].1), first(&joined, pair[1].1));
            joined[a.max(b)] = a.min(b);
        }
        let mut lots = vec![vec![]; joined.len()];
        for face in (0..joined.len()).filter(|face| !self.crossed[*face].is_empty()) {
            lots[first(&joined, face)].push(face);
        }
        lots.retain(|lot| !lot.is_empty());
        lots
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
            if fill.search(&cavity.sides) {
                self.replace(made);
                return true;
            }
        }
        false
    }

    /// Replaces the cells of the cavity by those found.
    fn replace(&mut self, made: &mut Triangulation<4>) {
        let Self { cavity, fill, changed, dead, incident, .. } = self;
        let Cavity { cells, corners, rim: faces, .. } = cavity;
        let count = made.cells.len();
        let slot = |index: usize| match cells.get(index) {
            Some(cell) => *cell,
            None => (count + index - cells.len()) as u32,
        };
        for (index, cell) in fill.found.iter().enumerate() {
            faces.extend((0..4).map(|at| (sorted(FACE[at].map(|k| cell[k])), slot(index), at as u8)));
        }
        faces.sort_unstable();
        debug_assert!(
            faces.chunk_by(|a, b| a.0 == b.0).all(|same| same.len() == 2),
            "each face is that of two"
        );
        dead.extend(cells.iter().skip(fill.found.len()));
        let count = count + fill.found.len().saturating_sub(cells.len());
        made.cells.resize(count, [HULL; 4]);
        made.neighbours.resize(count, [HULL; 4]);
        changed.resize(count, true);
        cells.iter().for_each(|cell| changed[*cell as usize] = true);
        for (index, local) in fill.found.iter().enumerate() {
            let (cell, corners) = (slot(index), local.map(|point| corners[usize::from(point)]));
            made.cells[cell as usize] = corners;
            corners.iter().for_each(|corner| incident[*corner as usize] = cell);
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
                    let back = |next: u32| made.neighbours[next as usize].iter().position(|n| *n == cell);
                    let back = if next == HULL { 0 } else { back(next).expect("neighbours know each other") };
                    rim.push((sorted([a, b, c]), next, back as u8));
                }
            }
        }
        true
    }
}

/// The first of the faces that are joined to a face.
fn first(joined: &[usize], mut face: usize) -> usize {
    while joined[face] != face {
        face = joined[face];
    }
    face
}

/// Edges of a face: they rise if its corners do.
fn edges_of<P: Copy>([a, b, c]: [P; 3]) -> [[P; 2]; 3] {
    [[a, b], [a, c], [b, c]]
}

fn sorted<const N: usize>(mut points: [u8; N]) -> [u8; N] {
    points.sort_unstable();
    points
}
