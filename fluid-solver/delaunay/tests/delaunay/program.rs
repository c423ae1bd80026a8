//! Programs read from bytes: clouds as degenerate as can be, and edits of them. The cells are those of a mesh made anew
//! after every edit.

use delaunay::constrained::{Constrained, Obstacle, Recovery};
use delaunay::{Delaunay, Error, Faults, HULL, Triangulation, check};
use robust::{Coord, incircle, orient2d};
use std::collections::BTreeSet;

/// The bytes of a program; none are zeros.
struct Bytes<'a>(std::slice::Iter<'a, u8>);

impl Bytes<'_> {
    fn next(&mut self) -> u8 {
        self.0.next().copied().unwrap_or(0)
    }

    fn below(&mut self, end: usize) -> usize {
        usize::from(self.next()) % end
    }

    fn is_empty(&self) -> bool {
        self.0.as_slice().is_empty()
    }

    /// On a small lattice, next to it, or far out of it: small whole numbers make equal, collinear and cospherical points.
    fn coordinate(&mut self) -> f64 {
        let byte = self.next();
        let x = f64::from(byte & 7);
        match byte >> 3 {
            0..8 => x,
            8..16 => -x,
            16..20 => 0.1 * x,
            20..24 => x + (2.0f64).powi(-50),
            24..26 => x - (2.0f64).powi(-50),
            26..28 => 1e-12 * x,
            28..30 => 1e12 * x,
            _ => x + f64::from(self.next()) / 256.0,
        }
    }

    fn point<const D: usize>(&mut self, scale: f64) -> [f64; D] {
        std::array::from_fn(|_| scale * self.coordinate())
    }

    /// Any three points, or corners on a way from cell to cell, which are near each other.
    fn face(&mut self, points: usize, made: &Triangulation<4>) -> [u32; 3] {
        let is_any = self.below(4) == 0;
        let mut cell = self.below(made.cells.len());
        std::array::from_fn(|_| {
            if is_any {
                return self.below(points) as u32;
            }
            let [corner, at] = [0, 1].map(|_| self.below(4));
            let point = made.cells[cell][corner];
            let next = made.neighbours[cell][at];
            if next != HULL {
                cell = next as usize;
            }
            point
        })
    }

    /// From next to nothing to next to infinity.
    fn scale(&mut self) -> f64 {
        match self.next() {
            0..32 => (2.0f64).powi(-1000) * (2.0f64).powi(-70),
            32..64 => (2.0f64).powi(-1000),
            64..96 => (2.0f64).powi(900),
            _ => 1.0,
        }
    }
}

/// Edits a cloud and compares it after each edit; returns how often the mesh was kept.
pub fn edits<const D: usize, const N: usize>(bytes: &[u8]) -> usize {
    let mut bytes = Bytes(bytes.iter());
    let scale = bytes.scale();
    let count = bytes.below(64);
    let mut points: Vec<[f64; D]> = (0..count).map(|_| bytes.point(scale)).collect();
    let mut ranks: Vec<u32> = (0..count as u32).collect();
    let (mut born, mut kept) = (count as u32, 0);
    let mut edited = Delaunay::<D, N>::new();
    edited.triangulate(&points, &ranks).unwrap();
    while !bytes.is_empty() {
        let too_far = |error: &Error| matches!(error, Error::TooFar { .. });
        match bytes.below(4) {
            0 => {
                points.push(bytes.point(scale));
                ranks.push(born);
                born += 1;
                if edited
                    .insert(points[points.len() - 1], ranks[points.len() - 1])
                    .is_err_and(|e| too_far(&e))
                {
                    edited.triangulate(&points, &ranks).unwrap();
                }
            }
            1 if !points.is_empty() => {
                let gone = bytes.below(points.len());
                edited.remove(gone as u32);
                points.swap_remove(gone);
                ranks.swap_remove(gone);
            }
            2 if !points.is_empty() => {
                let moved = bytes.below(points.len());
                points[moved] = bytes.point(scale);
                if edited.relocate(moved as u32, points[moved]).is_err_and(|e| too_far(&e)) {
                    edited.triangulate(&points, &ranks).unwrap();
                }
            }
            _ => {
                let (step, mask) = (scale * [0.0, 1e-14, 1e-3, 0.1][bytes.below(4)], bytes.next());
                let mut cloud: Vec<_> = ranks.iter().copied().zip(points.iter().copied()).collect();
                cloud.sort_unstable_by_key(|(rank, _)| *rank);
                if !cloud.is_empty() && mask & 64 != 0 {
                    cloud.remove(bytes.below(cloud.len()));
                }
                if mask & 128 != 0 {
                    cloud.push((born, bytes.point(scale)));
                    born += 1;
                }
                (ranks, points) = cloud.into_iter().unzip();
                for (k, x) in points.iter_mut().flatten().enumerate() {
                    *x += step * f64::from((k as u8).wrapping_mul(mask | 1) % 5);
                }
                edited.triangulate(&points, &ranks).unwrap();
            }
        }
        kept += usize::from(edited.was_reused());
        let mut anew = Delaunay::<D, N>::new();
        let made = edited.triangulation();
        assert!(*made == *anew.triangulate(&points, &ranks).unwrap(), "{points:?} {ranks:?}");
        assert!(check(&points, &ranks, made).unwrap().none(), "{points:?} {ranks:?}");
    }
    kept
}

/// Forces edges into a triangulation of the plane; returns how many there was room for.
pub fn forced_edges(bytes: &[u8]) -> usize {
    let mut bytes = Bytes(bytes.iter());
    let count = bytes.below(64);
    let points: Vec<[f64; 2]> = (0..count).map(|_| bytes.point(1.0)).collect();
    let ranks: Vec<u32> = (0..count as u32).collect();
    let plain = Delaunay::<2, 3>::new().triangulate(&points, &ranks).unwrap().clone();
    if plain.cells.is_empty() {
        return 0;
    }
    let at = |point: u32| Coord { x: points[point as usize][0], y: points[point as usize][1] };
    let side = |a: u32, b: u32, c: u32| orient2d(at(a), at(b), at(c));
    let corners: Vec<u32> =
        ranks.iter().copied().filter(|k| plain.cells.iter().flatten().any(|c| c == k)).collect();
    let mut made = Constrained::default();
    made.start(&plain, points.len());
    let mut forced = vec![];
    while !bytes.is_empty() {
        let [a, b] = [0, 1].map(|_| corners[bytes.below(corners.len())]);
        if a == b {
            continue;
        }
        match made.force(&points, a, b) {
            Ok(()) => forced.push([a, b]),
            Err(Obstacle::Point(p)) => assert!(side(a, b, p) == 0.0 && ![a, b].contains(&p)),
            Err(Obstacle::Edge([p, q])) => {
                assert!(forced.contains(&[p, q]) || forced.contains(&[q, p]));
                assert!(side(a, b, p) * side(a, b, q) < 0.0 && side(p, q, a) * side(p, q, b) < 0.0);
            }
        }
        made.restore(&points);
        let is_forced = |a: u32, b: u32| forced.contains(&[a, b]) || forced.contains(&[b, a]);
        assert!(forced.iter().all(|&[a, b]| made.left_of(a, b).or(made.left_of(b, a)).is_some()));
        // As many cells, none turned over, between the same points: they cover the hull once.
        assert_eq!(made.triangulation.cells.len(), plain.cells.len());
        for (cell, around) in made.triangulation.cells.iter().zip(&made.triangulation.neighbours) {
            let [a, b, c] = *cell;
            assert!(side(a, b, c) > 0.0);
            for (k, &other) in around.iter().enumerate().filter(|(_, other)| **other != HULL) {
                let (p, q) = (cell[(k + 1) % 3], cell[(k + 2) % 3]);
                let (index, opposite) = made.left_of(q, p).expect("a neighbour");
                assert_eq!(index as u32, other);
                let apex = made.triangulation.cells[index][opposite];
                assert!(is_forced(p, q) || incircle(at(a), at(b), at(c), at(apex)) <= 0.0);
            }
        }
    }
    forced.len()
}

/// Puts faces into a triangulation in space, those that came before being kept; returns for how many there was room.
///
/// But for the empty spheres, what comes of it is a triangulation of the points as exactly as Delaunay's: cells are positive,
/// neighbours share faces, and the hull is the one there was. So the cells fill it once.
pub fn recovered_faces(bytes: &[u8]) -> usize {
    let mut bytes = Bytes(bytes.iter());
    let scale = bytes.scale();
    let count = bytes.below(64);
    let points: Vec<[f64; 3]> = (0..count).map(|_| bytes.point(scale)).collect();
    let ranks: Vec<u32> = (0..count as u32).collect();
    let mut made = Delaunay::<3, 4>::new().triangulate(&points, &ranks).unwrap().clone();
    if made.cells.is_empty() {
        return 0;
    }
    let mut recovery = Recovery::default();
    let (mut kept, mut put_in) = (BTreeSet::new(), 0);
    while !bytes.is_empty() {
        let [before, hull] = faces(&made);
        let is_new = |face: &[u32; 3]| face[0] < face[1] && face[1] < face[2] && !before.contains(face);
        let wanted: BTreeSet<_> = (0..=bytes.below(6)).map(|_| rising(bytes.face(count, &made))).collect();
        let missing: Vec<_> = wanted.into_iter().filter(is_new).collect();
        let last = made.clone();
        let stays = |face| kept.contains(&rising(face)) || missing.contains(&rising(face));
        let lots = recovery.recover(&points, &mut made, &missing, stays).unwrap();
        let faults = check(&points, &ranks, &made).unwrap();
        assert!(Faults { delaunay: 0, ..faults }.none(), "{faults:?}: {points:?} {missing:?}");
        let [after, hull_after] = faces(&made);
        assert!(hull_after == hull && kept.is_subset(&after), "{points:?} {missing:?}");
        let come = missing.iter().filter(|face| after.contains(*face));
        assert_eq!(lots == 0, come.clone().count() == 0);
        assert!(lots > 0 || made == last, "what cannot be put in changes nothing");
        put_in += come.clone().count();
        kept.extend(come);
    }
    put_in
}

/// All faces, and those of the hull.
fn faces(made: &Triangulation<4>) -> [BTreeSet<[u32; 3]>; 2] {
    let [mut all, mut hull] = [BTreeSet::new(), BTreeSet::new()];
    for ([a, b, c, d], around) in made.cells.iter().zip(&made.neighbours) {
        for (face, next) in [[b, c, d], [a, c, d], [a, b, d], [a, b, c]].into_iter().zip(around) {
            let face = rising(face.map(|corner| *corner));
            all.insert(face);
            if *next == HULL {
                hull.insert(face);
            }
        }
    }
    [all, hull]
}

fn rising(mut face: [u32; 3]) -> [u32; 3] {
    face.sort_unstable();
    face
}
