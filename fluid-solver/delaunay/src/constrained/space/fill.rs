//! Tetrahedra between given faces, without new points.
//!
//! Source: C. Marot, K. Verhetsel, J.-F. Remacle, *Reviving the search for optimal tetrahedralizations*, 28th International
//! Meshing Roundtable (2019): a face of the front gets each of the other points in turn; what cannot be better than the best
//! found so far is not followed.

use super::signs::Signs;
use super::{edges_of, sorted};
use crate::predicate::space::{FACE, cross, from};

/// A face with the side on which it needs a tetrahedron: with a point there it makes a positive one. The smallest comes first.
type Side = [u8; 3];

/// So many tetrahedra are tried before there is a solution.
const TRIES: usize = 200;
/// And so many more for a better one.
const TRIES_FOR_BETTER: usize = 10;

/// The search; all but what was found is scratch.
#[derive(Clone, Debug, Default)]
pub struct Fill {
    /// The points, and their orientations.
    pub signs: Signs,
    /// The tetrahedra found.
    pub found: Vec<[u8; 4]>,
    faces: Vec<Side>,
    edges: Vec<[u8; 2]>,
    /// Tetrahedra that a side could have if there were only the given faces, the best first.
    candidates: Vec<Vec<Candidate>>,
    /// Where those of each side are, [`u16::MAX`] if they were not looked for.
    index: Vec<u16>,
    placed: Vec<[u8; 4]>,
    added_faces: Vec<Side>,
    added_edges: Vec<[u8; 2]>,
    best: f64,
    tries: usize,
    allowed: usize,
}

#[derive(Clone, Copy, Debug)]
struct Candidate {
    apex: u8,
    quality: f64,
}

impl Fill {
    /// Finds tetrahedra that have each of the given sides once and no others that are not matched by the other side of the same
    /// face. As they are positive, they fill what the sides enclose once: where the sides are the boundary of a chain of
    /// tetrahedra, that is its winding number. The worst tetrahedron is as good as some more tries could make it.
    ///
    /// Whether there are any; each point is a corner then.
    pub fn search(&mut self, sides: &[Side]) -> bool {
        let points = self.signs.len();
        self.faces.clear();
        self.faces.extend(sides.iter().map(|side| sorted(*side)));
        self.faces.sort_unstable();
        self.faces.dedup();
        self.edges.clear();
        self.edges.extend(self.faces.iter().flat_map(|face| edges_of(*face)));
        self.edges.sort_unstable();
        self.edges.dedup();
        self.candidates.clear();
        self.index.clear();
        self.index.resize(points * points * points, u16::MAX);
        self.added_faces.clear();
        self.added_edges.clear();
        self.placed.clear();
        self.found.clear();
        self.best = 0.0;
        (self.tries, self.allowed) = (0, TRIES);
        let front = sides.iter().map(|side| first_smallest(*side)).collect::<Vec<_>>();
        if self.crossed() {
            return false;
        }
        self.follow(&front, f64::INFINITY);
        !self.found.is_empty()
    }

    /// Whether a given edge pierces a given face.
    fn crossed(&mut self) -> bool {
        let Self { signs, faces, edges, .. } = self;
        edges.iter().any(|edge| faces.iter().any(|face| signs.pierces(*edge, *face)))
    }

    /// Follows what begins with the tetrahedra that are placed, the worst of which has a quality.
    fn follow(&mut self, front: &[Side], worst: f64) {
        if front.is_empty() {
            let corners = self.placed.iter().flatten().fold(0u32, |set, point| set | 1 << point);
            if corners.count_ones() as usize == self.signs.len() {
                if self.found.is_empty() {
                    self.allowed = self.tries + TRIES_FOR_BETTER;
                }
                self.found.clone_from(&self.placed);
                self.best = worst;
            }
            return;
        }
        let (mut at, mut fewest, mut free) = (0, vec![], vec![]);
        for (index, side) in front.iter().enumerate() {
            self.find_free(*side, front, &mut free);
            if free.is_empty() {
                return;
            }
            if index == 0 || free.len() < fewest.len() {
                at = index;
                std::mem::swap(&mut fewest, &mut free);
                if fewest.len() == 1 {
                    break;
                }
            }
        }
        for Candidate { apex, quality } in fewest {
            if quality <= self.best || self.tries == self.allowed {
                return;
            }
            self.tries += 1;
            let mut next = front.to_owned();
            let [a, b, c] = next.swap_remove(at);
            let (faces, edges) = (self.added_faces.len(), self.added_edges.len());
            self.place([a, b, c, apex], &mut next);
            self.follow(&next, worst.min(quality));
            self.placed.pop();
            self.added_faces.truncate(faces);
            self.added_edges.truncate(edges);
        }
    }

    /// Places a tetrahedron whose last face is off the front already.
    fn place(&mut self, cell: [u8; 4], front: &mut Vec<Side>) {
        self.placed.push(cell);
        for at in 0..3 {
            let side = first_smallest(FACE[at].map(|k| cell[k]));
            match front.iter().position(|other| *other == side) {
                Some(met) => {
                    front.swap_remove(met);
                }
                None => front.push(reversed(side)),
            }
            let face = sorted(side);
            if self.faces.binary_search(&face).is_err() && !self.added_faces.contains(&face) {
                self.added_faces.push(face);
            }
            let edge = sorted([cell[at], cell[3]]);
            if self.edges.binary_search(&edge).is_err() && !self.added_edges.contains(&edge) {
                self.added_edges.push(edge);
            }
        }
    }

    /// Writes the tetrahedra that a side can have beside those that are placed.
    fn find_free(&mut self, side: Side, front: &[Side], free: &mut Vec<Candidate>) {
        let index = self.candidates_of(side);
        let all = std::mem::take(&mut self.candidates[index]);
        let is_free = |one: &&Candidate| one.quality > self.best && self.is_free(side, one.apex, front);
        free.clear();
        free.extend(all.iter().filter(is_free));
        self.candidates[index] = all;
    }

    /// Whether the other faces and edges of a tetrahedron cross none that were placed, and none of the faces has one on this side.
    fn is_free(&mut self, [a, b, c]: Side, apex: u8, front: &[Side]) -> bool {
        let Self { signs, added_faces, added_edges, faces, .. } = self;
        let cell = [a, b, c, apex];
        for at in 0..3 {
            let edge = [cell[at], apex];
            if added_faces.iter().any(|face| signs.pierces(edge, *face)) {
                return false;
            }
            let side = first_smallest(FACE[at].map(|k| cell[k]));
            let face = sorted(side);
            if added_edges.iter().any(|edge| signs.pierces(*edge, face)) {
                return false;
            }
            let known = faces.binary_search(&face).is_ok() || added_faces.contains(&face);
            if known && !front.contains(&side) {
                return false;
            }
        }
        true
    }

    /// Where the tetrahedra are kept that a side could have.
    fn candidates_of(&mut self, side: Side) -> usize {
        let points = self.signs.len();
        let [a, b, c] = side.map(usize::from);
        let slot = (a * points + b) * points + c;
        if self.index[slot] == u16::MAX {
            self.index[slot] = self.candidates.len() as u16;
            let found = (0..points as u8).filter_map(|apex| self.candidate(side, apex));
            let mut found = found.collect::<Vec<_>>();
            found.sort_by(|a, b| b.quality.total_cmp(&a.quality));
            self.candidates.push(found);
        }
        usize::from(self.index[slot])
    }

    /// The tetrahedron of a side and a point, if it is positive and crosses no given face.
    fn candidate(&mut self, [a, b, c]: Side, apex: u8) -> Option<Candidate> {
        let Self { signs, faces, edges, .. } = self;
        let cell = [a, b, c, apex];
        if [a, b, c].contains(&apex) || signs.of(cell) <= 0 {
            return None;
        }
        for at in 0..3 {
            let edge = sorted([cell[at], apex]);
            if edges.binary_search(&edge).is_err() && faces.iter().any(|face| signs.pierces(edge, *face)) {
                return None;
            }
            let face = sorted(FACE[at].map(|k| cell[k]));
            if faces.binary_search(&face).is_err() && edges.iter().any(|edge| signs.pierces(*edge, face)) {
                return None;
            }
        }
        Some(Candidate { apex, quality: quality(cell.map(|point| signs.place(point))) })
    }
}

/// Six volumes of a tetrahedron over the cube of the root of its mean squared edge.
fn quality([a, b, c, d]: [&[f64; 3]; 4]) -> f64 {
    let (x, y, z) = (from(b, a), from(c, a), from(d, a));
    let area = cross(y, z);
    let volume = x[0] * area[0] + x[1] * area[1] + x[2] * area[2];
    let edges = [x, y, z, from(c, b), from(d, b), from(d, c)];
    let square = edges.iter().flatten().map(|x| x * x).sum::<f64>() / 6.0;
    // Positive even where rounding takes all of it.
    volume.max(f64::MIN_POSITIVE) / (square * square.sqrt())
}

fn first_smallest([a, b, c]: Side) -> Side {
    if a < b && a < c {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// The other side of the same face.
fn reversed([a, b, c]: Side) -> Side {
    [a, c, b]
}
