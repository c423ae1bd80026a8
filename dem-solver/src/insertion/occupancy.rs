//! Which places are taken.

use crate::domain::Domain;
use crate::grains::Place;
use crate::scene::Scene;
use crate::vector::Vector;
use crate::wall::Poses;
use crate::world::World;

/// No more cells than this.
const MOST_CELLS: f64 = 1e7;

const NONE: u32 = u32::MAX;

/// The place that a grain takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball<const D: usize> {
    /// Centre \[m\].
    pub centre: Vector<D>,
    /// Radius \[m\].
    pub radius: f64,
}

impl<const D: usize> Ball<D> {
    /// That of a grain.
    pub fn of(place: &Place) -> Self {
        Self { centre: place.at(), radius: place.radius }
    }
}

/// What is in the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// A grain.
    Grain,
    /// A wall.
    Wall,
}

/// Grains in and near a box, by cell.
#[derive(Clone, Debug)]
pub struct Occupancy<'a, const D: usize> {
    scene: &'a Scene<D>,
    walls: Poses<D>,
    lower: Vector<D>,
    width: f64,
    counts: [usize; D],
    first: Vec<u32>,
    next: Vec<u32>,
    places: Vec<Ball<D>>,
}

impl<'a, const D: usize> Occupancy<'a, D> {
    /// Walls and grains of the world that reach into the box, for newcomers of at most this radius \[m\].
    pub fn new(
        scene: &'a Scene<D>,
        lower: Vector<D>,
        upper: Vector<D>,
        world: &World<D>,
        radius: f64,
    ) -> Self {
        let present = &world.grains.place;
        let largest = present.iter().map(|place| place.radius).fold(radius, f64::max);
        let extent: Vector<D> = upper - lower;
        let number =
            |width: f64| -> f64 { extent.iter().map(|length| (length / width).ceil().max(1.0)).product() };
        let mut width = 2.0 * largest;
        while number(width) > MOST_CELLS {
            width *= 1.25;
        }
        let counts: [usize; D] = std::array::from_fn(|axis| ((extent[axis] / width).ceil() as usize).max(1));
        let first = vec![NONE; counts.iter().product()];
        let walls = world.wall_poses(scene);
        let mut occupancy = Self { scene, walls, lower, width, counts, first, next: vec![], places: vec![] };
        for place in present {
            occupancy.take(Ball::of(place));
        }
        occupancy
    }

    /// Takes the place if no grain and no wall overlaps it.
    ///
    /// # Errors
    /// What is in the way.
    pub fn take_if_free(&mut self, place: Ball<D>) -> Result<(), Obstacle> {
        if !self.is_free_of_grains(&place) {
            return Err(Obstacle::Grain);
        }
        if !self.is_free_of_walls(&place) {
            return Err(Obstacle::Wall);
        }
        self.take(place);
        Ok(())
    }

    fn is_free_of_grains(&self, place: &Ball<D>) -> bool {
        let Domain { periodic, .. } = self.scene.domain;
        let images = if periodic.contains(&true) { self.scene.shifts.as_slice() } else { &[Vector::zeros()] };
        images.iter().all(|shift| {
            let centre = place.centre + shift;
            let home = self.coordinates(&centre);
            (0..3_usize.pow(D as u32)).all(|code| {
                let at: [usize; D] =
                    std::array::from_fn(|axis| home[axis] + (code / 3_usize.pow(axis as u32)) % 3);
                if (0..D).any(|axis| at[axis] == 0 || at[axis] > self.counts[axis]) {
                    return true;
                }
                let mut entry = self.first[self.index(&at.map(|a| a - 1))];
                while entry != NONE {
                    let other = &self.places[entry as usize];
                    if (other.centre - centre).norm_squared() < (other.radius + place.radius).powi(2) {
                        return false;
                    }
                    entry = self.next[entry as usize];
                }
                true
            })
        })
    }

    fn is_free_of_walls(&self, place: &Ball<D>) -> bool {
        let mut near = Vec::new();
        let walls = &self.scene.walls;
        walls.planes_near(&place.centre, place.radius, &self.walls, &mut near);
        walls.facets_near(&place.centre, place.radius, &self.walls, &mut near);
        let distance = |&surface: &u32| walls.nearest(surface, &place.centre, &self.walls).distance;
        near.iter().all(|surface| distance(surface) >= place.radius)
    }

    fn take(&mut self, place: Ball<D>) {
        let cell = self.index(&self.coordinates(&place.centre));
        self.next.push(self.first[cell]);
        self.first[cell] = self.places.len() as u32;
        self.places.push(place);
    }

    /// Centres outside the box belong to the nearest cell: that brings none of them further apart.
    fn coordinates(&self, centre: &Vector<D>) -> [usize; D] {
        std::array::from_fn(|axis| {
            let cell = ((centre[axis] - self.lower[axis]) / self.width).max(0.0) as usize;
            cell.min(self.counts[axis] - 1)
        })
    }

    fn index(&self, at: &[usize; D]) -> usize {
        at.iter().zip(&self.counts).fold(0, |index, (a, n)| index * n + a)
    }
}
