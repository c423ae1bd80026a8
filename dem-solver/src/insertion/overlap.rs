//! Overlaps at the start.

use crate::engine::{Grid, Periods};
use crate::scene::Scene;
use crate::world::World;

/// A grain that overlaps another one or a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// Row of the grain.
    pub grain: usize,
    /// What it overlaps.
    pub with: Partner,
    /// Overlap as a fraction of the diameter, of the smaller one if there are two.
    pub fraction: f64,
}

/// What a grain overlaps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Partner {
    /// The grain in this row.
    Grain(usize),
    /// The wall of this index.
    Wall(u32),
}

/// The overlaps that are deeper than this fraction of a diameter, of grains of which one can move, and with walls; members
/// of one clump may overlap.
pub fn overlaps<const D: usize>(scene: &Scene<D>, world: &World<D>, fraction: f64) -> Vec<Overlap> {
    let mut found = Vec::new();
    between_grains(scene, world, fraction, &mut found);
    with_walls(scene, world, fraction, &mut found);
    found
}

fn between_grains<const D: usize>(
    scene: &Scene<D>,
    world: &World<D>,
    fraction: f64,
    found: &mut Vec<Overlap>,
) {
    let grains = &world.grains;
    let periods = Periods::new(&scene.domain);
    let largest = grains.largest_radius();
    let grid = Grid::of_all(grains, &periods, 2.0 * largest);
    for (i, a) in grains.place.iter().enumerate() {
        let fixed = grains.motion[i].is_frozen();
        grid.visit_around(a, a.radius + largest, |j| {
            let b = &grains.place[j];
            let overlap = periods.overlap(a, b) / (2.0 * a.radius.min(b.radius));
            let of_one_clump = || {
                let clump = |row: usize| world.bodies.of(grains.id[row]).map(|(clump, _)| clump);
                clump(i).is_some_and(|one| clump(j) == Some(one))
            };
            if j > i && overlap > fraction && !of_one_clump() && !(fixed && grains.motion[j].is_frozen()) {
                found.push(Overlap { grain: i, with: Partner::Grain(j), fraction: overlap });
            }
        });
    }
}

fn with_walls<const D: usize>(scene: &Scene<D>, world: &World<D>, fraction: f64, found: &mut Vec<Overlap>) {
    let (walls, grains) = (&scene.walls, &world.grains);
    let poses = world.wall_poses(scene);
    let mut near = Vec::new();
    for (row, place) in grains.place.iter().enumerate().filter(|(row, _)| !grains.motion[*row].is_frozen()) {
        near.clear();
        let centre = place.at();
        walls.planes_near(&centre, place.radius, &poses, &mut near);
        walls.facets_near(&centre, place.radius, &poses, &mut near);
        let distance = |surface: &u32| walls.nearest(*surface, &centre, &poses).distance;
        let Some(&nearest) = near.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))) else { continue };
        let overlap = (place.radius - distance(&nearest)) / (2.0 * place.radius);
        if overlap > fraction {
            let with = Partner::Wall(walls.surfaces[nearest as usize].wall);
            found.push(Overlap { grain: row, with, fraction: overlap });
        }
    }
}
