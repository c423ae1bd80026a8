//! Meshes between particles: given afresh whenever the particles have moved too far, moved with them in between.

use super::topology::outward;
use super::{BoundaryFace, Mesh, Neighbour, Periodicity};
use crate::element::simplex::{Vector, volume_and_areas, volume_and_gradients};
use rayon::prelude::*;

/// Cells per unit of parallel work.
const CELLS: usize = 1024;
/// Volume of a flat cell (m³; m²).
const FLAT: f64 = 1e-200;

/// Cells between particles, as their triangulation knows them.
#[derive(Debug, Clone, Copy)]
pub struct Linked<'a, const N: usize> {
    /// Corners of the cells.
    pub cells: &'a [[u32; N]],
    /// Neighbour of a cell across the face opposite to each corner.
    pub neighbours: &'a [[u32; N]],
    /// Stands for no neighbour.
    pub outside: u32,
}

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// A mesh without nodes, to be given particles; its boundary has these groups.
    pub fn of_particles(groups: Vec<String>) -> Self {
        Self {
            points: Vec::new(),
            node_of: Vec::new(),
            node_count: 0,
            cells: Vec::new(),
            neighbours: Vec::new(),
            boundary: Vec::new(),
            groups,
            periodicity: Periodicity([None; D]),
            volumes: Vec::new(),
            gradients: Vec::new(),
            measure: Vec::new(),
            size: Vec::new(),
        }
    }

    /// Takes other particles and the cells between them. Several bodies are allowed, and particles of no cell: their measure
    /// is 0, their size infinite. `group` names the group of a boundary face by its corners.
    ///
    /// Unchecked: the cells must be positive, their links mutual.
    pub fn relink(&mut self, places: &[Vector<D>], linked: Linked<'_, N>, group: impl Fn(&[u32; D]) -> u32) {
        let Linked { cells, neighbours, outside } = linked;
        self.node_count = places.len();
        self.node_of.clear();
        self.node_of.extend(0..places.len() as u32);
        self.cells.clear();
        self.cells.extend_from_slice(cells);
        self.neighbours.clear();
        self.boundary.clear();
        for (number, (cell, neighbours)) in cells.iter().zip(neighbours).enumerate() {
            self.neighbours.push(std::array::from_fn(|opposite| {
                if neighbours[opposite] != outside {
                    return Neighbour::Cell(neighbours[opposite]);
                }
                let points = outward(cell, opposite);
                let face = BoundaryFace {
                    points,
                    cell: number as u32,
                    opposite: opposite as u8,
                    group: group(&points),
                };
                self.boundary.push(face);
                Neighbour::Boundary(self.boundary.len() as u32 - 1)
            }));
        }
        self.move_to(places);
    }

    /// Moves the particles; their cells stay. Volumes may become negative where they move too far. A flat cell has
    /// [`FLAT`] for its volume, so that V∇N is what it is.
    pub fn move_to(&mut self, places: &[Vector<D>]) {
        self.points.clear();
        self.points.extend_from_slice(places);
        let points = &self.points;
        self.volumes.resize(self.cells.len(), 0.0);
        self.gradients.resize(self.cells.len(), [[0.0; D]; N]);
        let geometry = self.volumes.par_chunks_mut(CELLS).zip(self.gradients.par_chunks_mut(CELLS));
        geometry.zip(self.cells.par_chunks(CELLS)).for_each(|((volumes, gradients), cells)| {
            for ((volume, gradients), cell) in volumes.iter_mut().zip(gradients).zip(cells) {
                let vertices = cell.map(|point| points[point as usize]);
                (*volume, *gradients) = volume_and_gradients(&vertices);
                if *volume == 0.0 {
                    *volume = FLAT;
                    *gradients = volume_and_areas(&vertices).1.map(|area| area.map(|a| a / FLAT));
                }
            }
        });
        self.measure.clear();
        self.measure.resize(self.node_count, 0.0);
        self.size.clear();
        self.size.resize(self.node_count, 0.0);
        self.lump();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::generate::BoxMesh;

    const OUTSIDE: u32 = u32::MAX;

    /// A box as particles see it, with one of them in flight.
    fn box_and_drop() -> (Mesh<3, 4>, Mesh<3, 4>) {
        let mesh = BoxMesh {
            lower: [0.0; 3],
            upper: [1.0, 2.0, 1.5],
            cells: [3, 4, 5],
            periodic: [false; 3],
            jitter: None,
        };
        let mesh: Mesh<3, 4> = mesh.generate().unwrap();
        let link = |neighbour: &Neighbour| match neighbour {
            Neighbour::Cell(cell) => *cell,
            _ => OUTSIDE,
        };
        let neighbours: Vec<[u32; 4]> =
            (0..mesh.cells().len()).map(|cell| mesh.neighbours(cell).each_ref().map(link)).collect();
        let mut places = mesh.nodes().to_vec();
        places.push([0.5, 0.5, 3.0]);
        let mut particles = Mesh::of_particles(vec!["surface".to_string()]);
        let linked = Linked { cells: mesh.cells(), neighbours: &neighbours, outside: OUTSIDE };
        particles.relink(&places, linked, |_| 0);
        (mesh, particles)
    }

    #[test]
    fn particles_of_a_box_have_its_measures_and_boundary_and_a_drop_has_none() {
        let (mesh, particles) = box_and_drop();
        let nodes = mesh.node_count();
        assert_eq!(&particles.measure()[..nodes], mesh.measure());
        assert_eq!(&particles.size()[..nodes], mesh.size());
        assert_eq!((particles.measure()[nodes], particles.size()[nodes]), (0.0, f64::INFINITY));
        assert_eq!(particles.boundary().len(), mesh.boundary().len());
        let closed = particles.boundary().iter().fold([0.0; 3], |sum: Vector<3>, face| {
            let area = particles.area_vector(face);
            std::array::from_fn(|k| sum[k] + area[k])
        });
        assert!(closed.iter().all(|area| area.abs() < 1e-14), "{closed:?}");
    }

    #[test]
    fn a_mesh_that_is_stretched_has_the_stretched_measures() {
        let (_, mut particles) = box_and_drop();
        let before = particles.clone();
        let stretched: Vec<Vector<3>> = particles.nodes().iter().map(|x| [2.0 * x[0], x[1], x[2]]).collect();
        particles.move_to(&stretched);
        for (new, old) in particles.measure().iter().zip(before.measure()) {
            assert!((new - 2.0 * old).abs() <= 1e-15);
        }
        let back = before.nodes().to_vec();
        particles.move_to(&back);
        assert!(particles == before);
    }
}
