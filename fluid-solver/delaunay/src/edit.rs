//! Single points: put in, taken out, moved.

use crate::build::Mark;
use crate::error::MOST_POINTS;
use crate::{Delaunay, Error, HULL, Triangulation};

/// The cells are those that all points would have if they were triangulated together, whatever the order in which points
/// came and went: ties fall by rank alone, and the triangulation is unique. Coordinates read as zero are those below 10⁻³⁰
/// of the largest of the last [`Delaunay::triangulate`], or of 1 if there was none.
///
/// An edit costs what the cells around the point cost and the way to it from the last one, so that it pays to edit
/// neighbours in turn. While points are equal, lie on one plane or are fewer than N, each edit is a new triangulation.
impl<const D: usize, const N: usize> Delaunay<D, N> {
    /// The triangulation of the points as they are now.
    pub fn triangulation(&mut self) -> &Triangulation<N> {
        self.hand_over()
    }

    /// Puts one more point in, which becomes the last one.
    ///
    /// # Errors
    /// A coordinate that is not finite or 2⁶⁰ times as large as any of the last call, more than 10⁸ points: nothing is
    /// changed then.
    pub fn insert(&mut self, place: [f64; D], rank: u32) -> Result<(), Error> {
        let name = self.scaled.len();
        if name >= MOST_POINTS {
            return Err(Error::TooMany { points: name + 1 });
        }
        let place = self.scale.read_one(place, name)?;
        self.scaled.push(place);
        self.ranks.push(rank);
        if !self.put(name as u32) {
            self.build();
        }
        Ok(())
    }

    /// Takes a point out; the last point takes its number.
    ///
    /// # Panics
    /// If there is no such point.
    pub fn remove(&mut self, point: u32) {
        let last = self.scaled.len() as u32 - 1;
        let renamed = if point == last { None } else { self.find_corner(last) };
        let taken = self.take(point);
        self.scaled.swap_remove(point as usize);
        self.ranks.swap_remove(point as usize);
        if !taken {
            self.build();
        } else if let Some((_, corner)) = renamed {
            self.mesh.names[corner as usize] = point;
        }
    }

    /// Moves a point: takes it out and puts it in where it goes.
    ///
    /// # Errors
    /// As for [`Delaunay::insert`].
    ///
    /// # Panics
    /// If there is no such point.
    pub fn relocate(&mut self, point: u32, place: [f64; D]) -> Result<(), Error> {
        let place = self.scale.read_one(place, point as usize)?;
        let taken = self.take(point);
        self.scaled[point as usize] = place;
        if !taken || !self.put(point) {
            self.build();
        }
        Ok(())
    }

    /// Some cell, no ghost, to begin a search at.
    fn near(&self) -> Option<u32> {
        let open = |cell: &u32| self.mesh.marks.get(*cell as usize) == Some(&Mark::Open);
        Some(self.near)
            .filter(open)
            .filter(|cell| !self.mesh.is_ghost(*cell))
            .or_else(|| self.mesh.any_cell())
    }

    /// A cell that a point is a corner of, and the corner; none if there is no mesh.
    fn find_corner(&mut self, point: u32) -> Option<(u32, u32)> {
        if !self.kept {
            return None;
        }
        let cell = self.mesh.find_around(self.near()?, &self.scaled[point as usize]);
        let corner =
            self.mesh.cell(cell).corners.into_iter().find(|k| self.mesh.names[*k as usize] == point)?;
        self.near = cell;
        Some((cell, corner))
    }

    /// Takes a point out of the mesh; whether the mesh is one still.
    fn take(&mut self, point: u32) -> bool {
        let Some((cell, corner)) = self.find_corner(point) else { return false };
        self.mesh.names[corner as usize] = HULL;
        self.kept = self.repair.remove(&mut self.mesh, cell);
        self.reused = self.kept;
        self.mesh.spare.push(corner);
        self.kept
    }

    /// Puts a point into the mesh; whether the mesh is one still.
    fn put(&mut self, name: u32) -> bool {
        let point = (self.scaled[name as usize], self.ranks[name as usize], name);
        let near = self.near().filter(|_| self.kept);
        let made = near.and_then(|near| self.mesh.add(&mut self.cavity, near, point));
        self.kept = made.is_some();
        self.reused = self.kept;
        self.near = made.unwrap_or_default();
        self.kept
    }
}
