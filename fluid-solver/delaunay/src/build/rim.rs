//! The faces around a region, looked up by their corners as they are seen from inside.

use super::mesh::{Face, GHOST};
use crate::predicate::face;

/// Which face of a rim a face of a cell is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// No face of it.
    None,
    /// This one.
    Of(u32),
}

/// A face of the rim.
struct Piece<const N: usize> {
    /// Its corners as the cell inside sees them; the last entry is not used.
    corners: [u32; N],
    outside: Face,
    /// Whether the corner behind it is the ghost: then that in front of it must not be.
    hull: bool,
    found: bool,
}

/// Faces between a region and the cells around it.
#[derive(Default)]
pub struct Rim<const N: usize> {
    pieces: Vec<Piece<N>>,
    /// Faces by the hash of their corners: open addressing, [`EMPTY`] where there is none.
    table: Vec<u32>,
    found: usize,
}

const EMPTY: u32 = u32::MAX;

impl<const N: usize> Rim<N> {
    /// Begins a new rim.
    pub fn clear(&mut self) {
        self.pieces.clear();
        self.found = 0;
    }

    /// Number of faces.
    pub fn len(&self) -> usize {
        self.pieces.len()
    }

    /// Whether there is no face.
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Adds the face opposite to corner `at` of a cell inside; `apex` is the corner behind it.
    pub fn push(&mut self, corners: &[u32; N], at: usize, (outside, apex): (Face, u32)) {
        self.pieces.push(Piece { corners: seen(corners, at), outside, hull: apex == GHOST, found: false });
    }

    /// Makes ready for [`Rim::find`].
    pub fn index(&mut self) {
        let size = (2 * self.pieces.len()).next_power_of_two();
        self.table.clear();
        self.table.resize(size, EMPTY);
        for (index, piece) in self.pieces.iter().enumerate() {
            let mut place = hash(&piece.corners) & (size - 1);
            while self.table[place] != EMPTY {
                place = (place + 1) & (size - 1);
            }
            self.table[place] = index as u32;
        }
    }

    /// The face of the rim that the one opposite to corner `at` of a cell is, seen from the same side.
    pub fn find(&mut self, corners: &[u32; N], at: usize) -> Side {
        let hull = corners[at] == GHOST;
        let corners = seen(corners, at);
        let last = self.table.len() - 1;
        let mut place = hash(&corners) & last;
        while self.table[place] != EMPTY {
            let index = self.table[place];
            let piece = &mut self.pieces[index as usize];
            if piece.corners == corners {
                if hull && piece.hull {
                    return Side::None;
                }
                self.found += usize::from(!std::mem::replace(&mut piece.found, true));
                return Side::Of(index);
            }
            place = (place + 1) & last;
        }
        Side::None
    }

    /// Whether all faces have been found.
    pub fn is_complete(&self) -> bool {
        self.found == self.pieces.len()
    }

    /// Whether a face has been found.
    pub fn is_found(&self, face: usize) -> bool {
        self.pieces[face].found
    }

    /// The face of the cell outside.
    pub fn outside(&self, face: u32) -> Face {
        self.pieces[face as usize].outside
    }
}

/// Corners of the face opposite to corner `at`, in the sense of the cell; in space, where turning a face round keeps its
/// sense, the least first.
fn seen<const N: usize>(corners: &[u32; N], at: usize) -> [u32; N] {
    let mut seen = face(corners, at, 0);
    if N == 4 {
        let least = (0..3).min_by_key(|k| seen[*k]).unwrap_or(0);
        seen[..3].rotate_left(least);
    }
    seen
}

fn hash<const N: usize>(corners: &[u32; N]) -> usize {
    let mixed = corners.iter().fold(0u64, |sum, corner| {
        (sum.rotate_left(21) ^ u64::from(*corner)).wrapping_mul(0x9e37_79b9_7f4a_7c15)
    });
    (mixed >> 32) as usize
}
