//! What lay inside of the moved surface is fluid.
//!
//! Most faces of the surface are faces of the new cells too: these are fluid on one side of it and void on the other. A
//! cell at no such face is fluid if it has an inner corner, else what the cells around it are. Only cells at what is missing
//! of the surface, long ones behind it, which may reach through a film to another surface, and those of which that is not
//! enough to tell, are sampled; those about half of which is covered make up the volume.

use super::super::super::draft::Draft;
use super::super::surface::{OUTWARD, enclosed};
use super::super::tetrahedra::Tetrahedra;
use super::faces::Faces;
use super::samples::{covered, is_long};
use super::stars::Stars;
use crate::backend::pfem::cloud::Cloud;
use delaunay::HULL;

/// Samples cannot tell cells with a share between these from those of which one half is covered.
const ABOUT_HALF: [f64; 2] = [0.36, 0.64];

/// What is known of a cell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Verdict {
    Fluid,
    Void,
    /// It is at no face of the surface, and no corner is missed by the surface: fluid, unless the surface is missing there.
    Inside,
    /// It is at no face of the surface, and all its corners are on it.
    Open,
    /// To be sampled.
    Doubtful,
}

/// Where a node is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Inner,
    Exposed,
    Drop,
}

/// The rule, with its scratch.
#[derive(Default)]
pub struct MovedDomain {
    faces: Faces,
    kinds: Vec<Kind>,
    verdicts: Vec<Verdict>,
    /// Nodes of faces of the surface that are missing.
    loose: Vec<bool>,
    piece: Vec<usize>,
    stars: Stars,
    halves: Vec<Half>,
}

/// A cell about half of which lies in the moved old mesh.
struct Half {
    cell: usize,
    share: f64,
    volume: f64,
}

impl MovedDomain {
    /// Marks the cells that are fluid.
    pub fn recognise(&mut self, cloud: &Cloud<3, 4>, draft: &Draft<3>, tetrahedra: &mut Tetrahedra) {
        self.kinds.clear();
        self.kinds.extend(draft.exposed.iter().zip(&cloud.drop).map(|(exposed, drop)| match exposed {
            true => Kind::Exposed,
            false if *drop > 0.0 => Kind::Drop,
            false => Kind::Inner,
        }));
        self.faces.read(&draft.edges);
        self.verdicts.clear();
        for corners in &tetrahedra.made.cells {
            let verdict = self.first_verdict(corners);
            let reaches_over = verdict == Verdict::Fluid && is_long(cloud, draft, corners);
            self.verdicts.push(if reaches_over { Verdict::Doubtful } else { verdict });
        }
        self.doubt_where_the_surface_is_missing(cloud, tetrahedra);
        self.ask_neighbours(cloud, tetrahedra);
        self.sample(cloud, draft, tetrahedra);
        tetrahedra.fluid.clear();
        let fluid = |verdict: &Verdict| matches!(verdict, Verdict::Fluid | Verdict::Inside);
        tetrahedra.fluid.extend(self.verdicts.iter().map(fluid));
    }

    /// What the surface says of a cell.
    #[inline]
    fn first_verdict(&mut self, corners: &[u32; 4]) -> Verdict {
        let kinds = corners.map(|node| self.kinds[node as usize]);
        let inner = kinds.contains(&Kind::Inner);
        let (mut behind, mut before) = (false, false);
        if kinds.iter().filter(|kind| **kind == Kind::Exposed).count() >= 3 {
            for face in OUTWARD.iter().filter(|face| face.iter().all(|&k| kinds[k] == Kind::Exposed)) {
                match self.faces.meet(face.map(|k| corners[k])) {
                    Some(true) => behind = true,
                    Some(false) => before = true,
                    None => {}
                }
            }
        }
        match (behind, before) {
            (true, false) => Verdict::Fluid,
            (false, true) if !inner => Verdict::Void,
            (_, true) => Verdict::Doubtful,
            (false, false) if inner => Verdict::Inside,
            (false, false) => Verdict::Open,
        }
    }

    /// Cells with two corners where faces of the surface are missing can be on both sides, whatever other faces of it tell. A wall
    /// is where it was, whichever faces it has.
    fn doubt_where_the_surface_is_missing(&mut self, cloud: &Cloud<3, 4>, tetrahedra: &Tetrahedra) {
        self.loose.clear();
        self.loose.resize(cloud.place.len(), false);
        let mut whole = true;
        for corners in self.faces.missing().filter(|corners| !on_one_wall(cloud, corners)) {
            whole = false;
            corners.iter().for_each(|&node| self.loose[node as usize] = true);
        }
        if whole {
            return;
        }
        for (verdict, corners) in self.verdicts.iter_mut().zip(&tetrahedra.made.cells) {
            if corners.iter().filter(|node| self.loose[**node as usize]).count() >= 2 {
                *verdict = Verdict::Doubtful;
            }
        }
    }

    /// Open cells that hang together, but not through walls, are what the cells around them are, if these agree.
    fn ask_neighbours(&mut self, cloud: &Cloud<3, 4>, tetrahedra: &Tetrahedra) {
        let Self { verdicts, piece, .. } = self;
        for seed in 0..verdicts.len() {
            if verdicts[seed] != Verdict::Open {
                continue;
            }
            // Doubtful until all is known.
            verdicts[seed] = Verdict::Doubtful;
            piece.clear();
            piece.push(seed);
            let (mut fluid, mut void, mut visited) = (false, false, 0);
            while let Some(&cell) = piece.get(visited) {
                visited += 1;
                let corners = &tetrahedra.made.cells[cell];
                for (opposite, &next) in tetrahedra.made.neighbours[cell].iter().enumerate() {
                    if next == HULL || on_one_wall(cloud, &OUTWARD[opposite].map(|k| corners[k])) {
                        continue;
                    }
                    match verdicts[next as usize] {
                        Verdict::Fluid | Verdict::Inside => fluid = true,
                        Verdict::Void => void = true,
                        Verdict::Open => {
                            verdicts[next as usize] = Verdict::Doubtful;
                            piece.push(next as usize);
                        }
                        Verdict::Doubtful => {}
                    }
                }
            }
            let verdict = match (fluid, void) {
                (true, false) => Verdict::Fluid,
                (false, true) => Verdict::Void,
                _ => continue,
            };
            piece.iter().for_each(|&cell| verdicts[cell] = verdict);
        }
    }

    /// Decides by samples what is left: fluid is what is covered for the most part. Of what is covered by about one half, which
    /// is as far as samples tell, so much is fluid, the best covered first, that the cells hold what the surface encloses.
    fn sample(&mut self, cloud: &Cloud<3, 4>, draft: &Draft<3>, tetrahedra: &Tetrahedra) {
        let Self { verdicts, stars, piece, halves, .. } = self;
        piece.clear();
        piece.extend((0..verdicts.len()).filter(|&cell| verdicts[cell] == Verdict::Doubtful));
        if piece.is_empty() {
            return;
        }
        let cells = &tetrahedra.made.cells;
        stars.read(cloud, piece.iter().flat_map(|&cell| cells[cell]));
        halves.clear();
        for &cell in &*piece {
            let share = covered(cloud, draft, stars, &cells[cell]);
            verdicts[cell] = if share > ABOUT_HALF[1] { Verdict::Fluid } else { Verdict::Void };
            if (ABOUT_HALF[0]..=ABOUT_HALF[1]).contains(&share) {
                halves.push(Half { cell, share, volume: tetrahedra.volume(cloud, cell) });
            }
        }
        if halves.is_empty() {
            return;
        }
        halves.sort_by(|a, b| b.share.total_cmp(&a.share));
        let fluid =
            (0..verdicts.len()).filter(|&cell| matches!(verdicts[cell], Verdict::Fluid | Verdict::Inside));
        let mut missing =
            enclosed(cloud, draft) - fluid.map(|cell| tetrahedra.volume(cloud, cell)).sum::<f64>();
        for Half { cell, volume, .. } in &*halves {
            if missing < 0.5 * volume {
                break;
            }
            verdicts[*cell] = Verdict::Fluid;
            missing -= volume;
        }
    }
}

/// Whether all corners of a face touch the same wall.
fn on_one_wall(cloud: &Cloud<3, 4>, face: &[u32; 3]) -> bool {
    let [a, b, c] = face.map(|node| cloud.contacts[node as usize]);
    !a.common(b).common(c).is_empty()
}
