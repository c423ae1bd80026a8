//! Edges forced into a triangulation of the plane by flips.
//!
//! Source: S. W. Sloan, *A fast algorithm for generating constrained Delaunay triangulations*, Comput. Struct. 47 (1993) 441.

use super::find_incident;
use crate::{HULL, Triangulation};
use robust::{Coord, incircle, orient2d};
use std::collections::VecDeque;

/// What keeps an edge out of the triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// It passes through this point.
    Point(u32),
    /// It crosses this edge, which was forced before.
    Edge([u32; 2]),
}

/// A triangulation of points in the plane that is Delaunay but for the edges forced into it.
#[derive(Clone, Debug, Default)]
pub struct Constrained {
    /// The triangles, counter-clockwise, and their neighbours.
    pub triangulation: Triangulation<3>,
    forced: Vec<[bool; 3]>,
    /// Some triangle of each point, or [`HULL`] if it has none.
    incident: Vec<u32>,
    crossed: VecDeque<[u32; 2]>,
    made: Vec<[u32; 2]>,
}

impl Constrained {
    /// Starts from a Delaunay triangulation of `points` points.
    pub fn start(&mut self, plain: &Triangulation<3>, points: usize) {
        self.triangulation.cells.clone_from(&plain.cells);
        self.triangulation.neighbours.clone_from(&plain.neighbours);
        self.forced.clear();
        self.forced.resize(plain.cells.len(), [false; 3]);
        find_incident(&plain.cells, points, &mut self.incident);
        self.made.clear();
    }

    /// The triangle to the left of the edge from `a` to `b`, and the corner opposite; none if there is no such edge
    /// or it has the hull on its left.
    pub fn left_of(&self, a: u32, b: u32) -> Option<(usize, usize)> {
        self.fan(a).find(|&(c, i)| self.triangulation.cells[c][next(i)] == b).map(|(c, i)| (c, next(next(i))))
    }

    /// Forces the edge between two points.
    ///
    /// # Panics
    /// If `a` is the corner of no triangle.
    ///
    /// # Errors
    /// A point on it, or an edge forced before that crosses it: nothing is changed then.
    pub fn force(&mut self, points: &[[f64; 2]], a: u32, b: u32) -> Result<(), Obstacle> {
        if !self.mark(a, b) {
            self.collect_crossed(points, a, b)?;
            self.flip_away(points, a, b);
            self.mark(a, b);
        }
        Ok(())
    }

    /// Makes all but the forced edges locally Delaunay again.
    pub fn restore(&mut self, points: &[[f64; 2]]) {
        while let Some([a, b]) = self.made.pop() {
            let Some((c, i)) = self.left_of(a, b) else { continue };
            let m = self.triangulation.neighbours[c][i];
            if m == HULL || self.forced[c][i] {
                continue;
            }
            let [p, q, r] = self.triangulation.cells[c].map(|point| at(points, point));
            let opposite = self.opposite(c, i);
            if incircle(p, q, r, at(points, opposite)) > 0.0 {
                let apex = self.triangulation.cells[c][i];
                self.flip(c, i);
                self.made.extend([[a, apex], [apex, b], [b, opposite], [opposite, a]]);
                self.made.extend([[apex, a], [b, apex], [opposite, b], [a, opposite]]);
            }
        }
    }

    /// Triangles around a point with its corner in each, counter-clockwise from the hull if it is on it.
    fn fan(&self, point: u32) -> impl Iterator<Item = (usize, usize)> + '_ {
        let start = self.incident[point as usize];
        let corner =
            move |c: usize| self.triangulation.cells[c].iter().position(|&p| p == point).unwrap_or(0);
        let mut first = start;
        if start != HULL {
            loop {
                let c = first as usize;
                let clockwise = self.triangulation.neighbours[c][next(next(corner(c)))];
                if clockwise == HULL || clockwise == start {
                    break;
                }
                first = clockwise;
            }
        }
        let mut current = first;
        std::iter::from_fn(move || {
            if current == HULL {
                return None;
            }
            let c = current as usize;
            let i = corner(c);
            current = self.triangulation.neighbours[c][next(i)];
            if current == first {
                current = HULL;
            }
            Some((c, i))
        })
    }

    /// Marks an edge as forced; false if there is no such edge.
    fn mark(&mut self, a: u32, b: u32) -> bool {
        let sides = [self.left_of(a, b), self.left_of(b, a)];
        for (c, i) in sides.into_iter().flatten() {
            self.forced[c][i] = true;
        }
        sides.iter().any(Option::is_some)
    }

    /// The edges that the segment from `a` to `b` crosses, from `a` on.
    fn collect_crossed(&mut self, points: &[[f64; 2]], a: u32, b: u32) -> Result<(), Obstacle> {
        let mut crossed = std::mem::take(&mut self.crossed);
        crossed.clear();
        let found = self.walk(points, a, b, &mut crossed);
        self.crossed = crossed;
        found
    }

    fn walk(
        &self,
        points: &[[f64; 2]],
        a: u32,
        b: u32,
        crossed: &mut VecDeque<[u32; 2]>,
    ) -> Result<(), Obstacle> {
        let side = |p: u32| orient2d(at(points, a), at(points, b), at(points, p));
        let ahead = |p: u32| {
            let (a, b, p) = (points[a as usize], points[b as usize], points[p as usize]);
            (b[0] - a[0]) * (p[0] - a[0]) + (b[1] - a[1]) * (p[1] - a[1]) > 0.0
        };
        let mut start = None;
        for (c, i) in self.fan(a) {
            let (right, left) =
                (self.triangulation.cells[c][next(i)], self.triangulation.cells[c][next(next(i))]);
            for p in [right, left] {
                if side(p) == 0.0 && ahead(p) {
                    return Err(Obstacle::Point(p));
                }
            }
            if side(right) < 0.0 && side(left) > 0.0 {
                start = Some((c, i));
            }
        }
        let (mut c, mut i) = start.expect("the segment leaves its first point into some triangle");
        loop {
            let cell = self.triangulation.cells[c];
            let (right, left) = (cell[next(i)], cell[next(next(i))]);
            if self.forced[c][i] {
                return Err(Obstacle::Edge([right, left]));
            }
            crossed.push_back([right, left]);
            let apex = self.opposite(c, i);
            if apex == b {
                return Ok(());
            }
            let turn = side(apex);
            if turn == 0.0 {
                return Err(Obstacle::Point(apex));
            }
            // The next edge has the apex as its end on the apex's side; it is opposite to the other end.
            let m = self.triangulation.neighbours[c][i] as usize;
            let behind = if turn > 0.0 { left } else { right };
            i = self.triangulation.cells[m].iter().position(|&p| p == behind).expect("a shared edge");
            c = m;
        }
    }

    /// Flips crossed edges until none crosses the segment from `a` to `b`.
    fn flip_away(&mut self, points: &[[f64; 2]], a: u32, b: u32) {
        let side = |p: u32, q: u32, r: u32| orient2d(at(points, p), at(points, q), at(points, r));
        while let Some([u, v]) = self.crossed.pop_front() {
            let (c, i) = self.left_of(u, v).expect("a crossed edge has two sides");
            let (apex, opposite) = (self.triangulation.cells[c][i], self.opposite(c, i));
            if side(apex, opposite, u) * side(apex, opposite, v) >= 0.0 {
                self.crossed.push_back([u, v]);
                continue;
            }
            self.flip(c, i);
            let shared = [a, b].contains(&apex) || [a, b].contains(&opposite);
            if !shared && side(a, b, apex) * side(a, b, opposite) < 0.0 {
                self.crossed.push_back([apex, opposite]);
            } else {
                self.made.push([apex, opposite]);
            }
        }
    }

    /// The corner of the neighbour across the face opposite to corner `i`.
    fn opposite(&self, c: usize, i: usize) -> u32 {
        let m = self.triangulation.neighbours[c][i] as usize;
        self.triangulation.cells[m][self.back(c, m)]
    }

    /// The corner of triangle `m` that is opposite to triangle `c`.
    fn back(&self, c: usize, m: usize) -> usize {
        self.triangulation.neighbours[m]
            .iter()
            .position(|&n| n as usize == c)
            .expect("neighbours know each other")
    }

    /// Turns the diagonal of the two triangles that share the face opposite to corner `i` of `c`.
    fn flip(&mut self, c: usize, i: usize) {
        let m = self.triangulation.neighbours[c][i] as usize;
        let j = self.back(c, m);
        let (cell, other) = (self.triangulation.cells[c], self.triangulation.cells[m]);
        let (apex, u, v, opposite) = (cell[i], cell[next(i)], cell[next(next(i))], other[j]);
        let outer = |s: &Self, t: usize, k: usize| (s.triangulation.neighbours[t][k], s.forced[t][k]);
        // Beyond (v, apex), (apex, u), (u, opposite) and (opposite, v).
        let (va, au) = (outer(self, c, next(i)), outer(self, c, next(next(i))));
        let (uo, ov) = (outer(self, m, next(j)), outer(self, m, next(next(j))));
        self.set(c, [apex, u, opposite], [uo, (m as u32, false), au]);
        self.set(m, [apex, opposite, v], [ov, va, (c as u32, false)]);
        for (outside, from, to) in [(uo.0, m, c), (va.0, c, m)] {
            if outside != HULL {
                let back = self.back(from, outside as usize);
                self.triangulation.neighbours[outside as usize][back] = to as u32;
            }
        }
        for (point, triangle) in [(apex, c), (u, c), (opposite, c), (v, m)] {
            self.incident[point as usize] = triangle as u32;
        }
    }

    fn set(&mut self, c: usize, cell: [u32; 3], around: [(u32, bool); 3]) {
        self.triangulation.cells[c] = cell;
        self.triangulation.neighbours[c] = around.map(|(neighbour, _)| neighbour);
        self.forced[c] = around.map(|(_, forced)| forced);
    }
}

fn next(i: usize) -> usize {
    (i + 1) % 3
}

fn at(points: &[[f64; 2]], point: u32) -> Coord<f64> {
    let [x, y] = points[point as usize];
    Coord { x, y }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Triangles between the points of a grid of 2 rows, all diagonals alike.
    fn strip(columns: u32) -> (Vec<[f64; 2]>, Triangulation<3>) {
        let points = (0..columns).flat_map(|k| [[f64::from(k), 0.0], [f64::from(k), 1.0]]).collect();
        let mut strip = Triangulation::default();
        for k in 0..columns - 1 {
            let (a, t) = (2 * k, 2 * k);
            strip.cells.extend([[a, a + 2, a + 1], [a + 1, a + 2, a + 3]]);
            let before = if k == 0 { HULL } else { t - 1 };
            let after = if k == columns - 2 { HULL } else { t + 2 };
            strip.neighbours.extend([[t + 1, before, HULL], [after, HULL, t]]);
        }
        (points, strip)
    }

    fn area(points: &[[f64; 2]], cell: &[u32; 3]) -> f64 {
        let [a, b, c] = cell.map(|point| points[point as usize]);
        0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    }

    fn check(points: &[[f64; 2]], made: &Constrained, total: f64) {
        let Triangulation { cells, neighbours, .. } = &made.triangulation;
        assert!(cells.iter().all(|cell| area(points, cell) > 0.0));
        assert!((cells.iter().map(|cell| area(points, cell)).sum::<f64>() - total).abs() < 1e-12);
        for (c, around) in neighbours.iter().enumerate() {
            for (i, &m) in around.iter().enumerate().filter(|(_, m)| **m != HULL) {
                let back = made.back(c, m as usize);
                assert_eq!(cells[c][next(i)], cells[m as usize][next(next(back))]);
            }
        }
    }

    #[test]
    fn a_long_edge_is_forced_through_a_strip_and_the_rest_stays_valid() {
        let (points, plain) = strip(7);
        let mut made = Constrained::default();
        made.start(&plain, points.len());
        assert_eq!(made.force(&points, 0, 13), Ok(()));
        made.restore(&points);
        assert!(made.left_of(0, 13).is_some() && made.left_of(13, 0).is_some());
        check(&points, &made, 6.0);
    }

    #[test]
    fn an_edge_through_a_point_or_across_a_forced_edge_names_what_is_in_its_way() {
        let (points, plain) = strip(7);
        let mut made = Constrained::default();
        made.start(&plain, points.len());
        assert_eq!(made.force(&points, 0, 4), Err(Obstacle::Point(2)));
        made.force(&points, 0, 13).expect("free");
        let Err(Obstacle::Edge(edge)) = made.force(&points, 1, 12) else { panic!("it crosses") };
        assert!(edge.contains(&0) && edge.contains(&13));
        check(&points, &made, 6.0);
    }
}
