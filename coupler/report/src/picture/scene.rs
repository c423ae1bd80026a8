//! What is shown: grains and, if there is a fluid, its mesh with a value at every node.

use super::Bounds;

/// A piece of the mesh with less than this share of the cells is spray, as are nodes without cells: it is shown, but
/// neither frames the picture nor scales its colours.
const SPRAY: f64 = 0.01;

/// A grain: a sphere, or a disc in a plane scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grain {
    /// Centre \[m\].
    pub centre: [f64; 3],
    /// Radius \[m\].
    pub radius: f64,
    /// What its colour shows, e.g. its speed; NaN is drawn grey.
    pub value: f64,
}

/// A fluid mesh of triangles (plane scenes, surfaces) or tetrahedra.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FluidMesh {
    /// Node positions \[m\].
    pub points: Vec<[f64; 3]>,
    /// Node numbers of the triangles.
    pub triangles: Vec<[u32; 3]>,
    /// Node numbers of the tetrahedra.
    pub tetrahedra: Vec<[u32; 4]>,
    /// What the colour shows, one value per node; NaN is drawn grey.
    pub values: Vec<f64>,
}

/// How a fluid in space is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FluidView {
    /// A cut through the middle, upright and facing the viewer.
    #[default]
    Slice,
    /// The surface of the mesh: for a mesh that moves with the fluid.
    Surface,
}

/// A moment of the run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Scene {
    /// The grains.
    pub grains: Vec<Grain>,
    /// The fluid.
    pub mesh: Option<FluidMesh>,
}

impl Scene {
    /// Whether all of it lies in the plane z = 0.
    pub fn is_plane(&self) -> bool {
        let flat_mesh =
            |mesh: &FluidMesh| mesh.tetrahedra.is_empty() && mesh.points.iter().all(|p| p[2] == 0.0);
        self.grains.iter().all(|grain| grain.centre[2] == 0.0) && self.mesh.as_ref().is_none_or(flat_mesh)
    }

    /// The smallest box around the finite grains and nodes but those of spray; none if there are none.
    pub fn bounds(&self) -> Option<Bounds> {
        let plane = self.is_plane();
        let grains = self.grains.iter().filter(|grain| grain.is_finite()).map(|grain| {
            let reach = [grain.radius, grain.radius, if plane { 0.0 } else { grain.radius }];
            Bounds {
                low: std::array::from_fn(|k| grain.centre[k] - reach[k]),
                high: std::array::from_fn(|k| grain.centre[k] + reach[k]),
            }
        });
        grains.chain(self.mesh.iter().filter_map(FluidMesh::bounds)).reduce(Bounds::union)
    }

    /// Smallest and largest finite value of the grains, and of the fluid's nodes but those of spray.
    pub fn value_ranges(&self) -> [Option<(f64, f64)>; 2] {
        let nodes = self
            .mesh
            .iter()
            .flat_map(|mesh| mesh.bulk().into_iter().filter_map(|node| mesh.values.get(node).copied()));
        [range(self.grains.iter().map(|grain| grain.value)), range(nodes)]
    }
}

impl FluidMesh {
    /// The smallest box around the finite nodes but those of spray; none if there are none.
    pub(super) fn bounds(&self) -> Option<Bounds> {
        let points = self.bulk().into_iter().map(|node| self.points[node]);
        let finite = points.filter(|point| point.iter().all(|x| x.is_finite()));
        finite.map(|point| Bounds { low: point, high: point }).reduce(Bounds::union)
    }

    /// The nodes of all pieces but spray; all nodes if there are no cells.
    fn bulk(&self) -> Vec<usize> {
        let cells = || self.triangles.iter().map(|c| &c[..]).chain(self.tetrahedra.iter().map(|c| &c[..]));
        // For each node one nearer to the first of its piece, or itself.
        let mut towards: Vec<u32> = (0..self.points.len() as u32).collect();
        let mut first = |mut node: u32, join: Option<u32>| {
            while towards[node as usize] != node {
                towards[node as usize] = towards[towards[node as usize] as usize];
                node = towards[node as usize];
            }
            towards[node as usize] = join.unwrap_or(node);
            node
        };
        for cell in cells() {
            let home = first(cell[0], None);
            cell[1..].iter().for_each(|&node| _ = first(node, Some(home)));
        }
        let mut count = vec![0; self.points.len()];
        let mut total = 0;
        for cell in cells() {
            count[first(cell[0], None) as usize] += 1;
            total += 1;
        }
        let least = SPRAY * f64::from(total);
        let is_bulk = |node: &usize| {
            let count = count[first(*node as u32, None) as usize];
            total == 0 || count > 0 && f64::from(count) >= least
        };
        (0..self.points.len()).filter(is_bulk).collect()
    }
}

impl Grain {
    pub(super) fn is_finite(&self) -> bool {
        self.radius.is_finite() && self.radius > 0.0 && self.centre.iter().all(|x| x.is_finite())
    }
}

fn range(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values
        .filter(|value| value.is_finite())
        .map(|value| (value, value))
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_ignore_what_is_not_finite() {
        let grain = |x: f64, radius: f64| Grain { centre: [x, 0.0, 1.0], radius, value: x };
        let grains = vec![grain(1.0, 0.5), grain(f64::NAN, 0.5), grain(9.0, f64::INFINITY), grain(2.0, 0.25)];
        let scene = Scene { grains, mesh: None };
        let bounds = scene.bounds().unwrap();
        assert_eq!((bounds.low, bounds.high), ([0.5, -0.5, 0.5], [2.25, 0.5, 1.5]));
        assert_eq!(scene.value_ranges(), [Some((1.0, 9.0)), None]);
        assert_eq!(Scene::default().bounds(), None);
    }

    #[test]
    fn spray_neither_frames_the_picture_nor_scales_its_colours() {
        let strip = |k: u32| [k, k + 1, k + 2];
        let mut points: Vec<[f64; 3]> = (0..202).map(|k| [f64::from(k / 2), f64::from(k % 2), 0.0]).collect();
        let mut triangles: Vec<[u32; 3]> = (0..200).map(strip).collect();
        // A piece of one cell, and a drop.
        points.extend([[0.0, 50.0, 0.0], [1.0, 50.0, 0.0], [0.0, 51.0, 0.0], [-70.0, 0.0, 0.0]]);
        triangles.push(strip(202));
        let values = points.iter().map(|x| x[1]).collect();
        let mesh = FluidMesh { points, triangles, values, ..FluidMesh::default() };
        let scene = Scene { mesh: Some(mesh), ..Scene::default() };
        let bounds = scene.bounds().unwrap();
        assert_eq!((bounds.low, bounds.high), ([0.0; 3], [100.0, 1.0, 0.0]));
        assert_eq!(scene.value_ranges()[1], Some((0.0, 1.0)));
    }

    #[test]
    fn a_scene_is_plane_when_nothing_leaves_the_plane() {
        let mut scene =
            Scene { grains: vec![Grain { centre: [1.0, 2.0, 0.0], radius: 1.0, value: 0.0 }], mesh: None };
        assert!(scene.is_plane());
        scene.mesh = Some(FluidMesh { points: vec![[0.0, 0.0, 0.1]], ..FluidMesh::default() });
        assert!(!scene.is_plane());
    }
}
