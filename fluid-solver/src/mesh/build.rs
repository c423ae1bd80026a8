//! From points, cells and named faces to a checked mesh.

use super::topology::{Face, Topology, outward};
use super::{BoundaryFace, Mesh, MeshError, Period, Periodicity};
use crate::element::simplex::{Vector, difference, longest_edge, volume_and_gradients};

/// A cell counts as degenerate below this share of its longest edge to the power `D`.
const SMALLEST_VOLUME: f64 = 1e-12;
/// Periodic pairs match to this share of the period.
const PERIODIC_TOLERANCE: f64 = 1e-9;

/// What a mesh is made of, unchecked; [`Mesh::new`] checks it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MeshParts<const D: usize, const N: usize> {
    /// Positions of the points (m).
    pub points: Vec<Vector<D>>,
    /// Corners of the cells.
    pub cells: Vec<[u32; N]>,
    /// Boundary faces, corners in any order, each with the index of its group. Faces on periodic sides may be listed.
    pub boundary: Vec<([u32; D], u32)>,
    /// Names of the groups.
    pub groups: Vec<String>,
    /// Pairs of points to be taken for one node, one entry per periodic axis.
    pub periodic: Vec<PeriodicPairs>,
}

/// The points of the two periodic sides of an axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PeriodicPairs {
    /// The axis.
    pub axis: usize,
    /// `(image, master)` points.
    pub pairs: Vec<(u32, u32)>,
}

impl<const D: usize, const N: usize> Mesh<D, N> {
    /// Checks the parts, links the cells, and computes volumes, gradients, measure and size.
    ///
    /// Where axes are periodic the points are renumbered: nodes first, images last, each in the order given.
    ///
    /// # Errors
    /// The first fault found, with the point, face or cell.
    pub fn new(parts: MeshParts<D, N>) -> Result<Self, MeshError> {
        check_references(&parts)?;
        let periodicity = periodicity(&parts)?;
        let (parts, node_of, node_count) = nodes_first(parts);
        let (volumes, gradients) = geometry(&parts)?;
        let topology = Topology::<D, N>::new(&parts.cells, &node_of)?;
        let boundary = name_faces(&parts, &topology)?;
        topology.check_connected(&parts.cells)?;
        let MeshParts { points, cells, groups, .. } = parts;
        let neighbours = topology.neighbours;
        let (measure, size) = (vec![0.0; node_count], vec![0.0; node_count]);
        let mut mesh = Self {
            points,
            node_of,
            node_count,
            cells,
            neighbours,
            boundary,
            groups,
            periodicity,
            volumes,
            gradients,
            measure,
            size,
        };
        mesh.lump();
        Ok(mesh)
    }

    /// Fills in `|N_a| = Σ_e V_e / N` and `h_a = Σ_e V_e h_e / Σ_e V_e`, `h_e = (D! V_e)^{1/D}`.
    pub(super) fn lump(&mut self) {
        let factorial = if D == 2 { 2.0 } else { 6.0 };
        for (cell, &volume) in self.volumes.iter().enumerate() {
            let share = volume / N as f64;
            // Cells of nodes that move may turn over.
            let size = (factorial * volume.max(0.0)).powf(1.0 / D as f64);
            for point in self.cells[cell] {
                let node = self.node_of[point as usize] as usize;
                self.measure[node] += share;
                self.size[node] += share * size;
            }
        }
        for (size, measure) in self.size.iter_mut().zip(&self.measure) {
            *size = if *measure == 0.0 { f64::INFINITY } else { *size / measure };
        }
    }
}

fn check_references<const D: usize, const N: usize>(parts: &MeshParts<D, N>) -> Result<(), MeshError> {
    if parts.cells.is_empty() {
        return Err(MeshError::Empty);
    }
    if let Some(point) = parts.points.iter().position(|x| !x.iter().all(|c| c.is_finite())) {
        return Err(MeshError::NotFinite { point, position: parts.points[point].to_vec() });
    }
    let count = parts.points.len();
    let known = |what, index, points: &[u32]| match points.iter().find(|&&point| point as usize >= count) {
        Some(&point) => Err(MeshError::NoSuchPoint { what, index, point, last: count.saturating_sub(1) }),
        None => Ok(()),
    };
    let mut referenced = vec![false; count];
    for (index, cell) in parts.cells.iter().enumerate() {
        known("cell", index, cell)?;
        cell.iter().for_each(|&point| referenced[point as usize] = true);
    }
    for (index, (face, _)) in parts.boundary.iter().enumerate() {
        known("face", index, face)?;
    }
    for (index, &(image, master)) in parts.periodic.iter().flat_map(|axis| &axis.pairs).enumerate() {
        known("periodic pair", index, &[image, master])?;
    }
    match referenced.iter().position(|&seen| !seen) {
        Some(point) => Err(MeshError::UnreferencedPoint { point, position: parts.points[point].to_vec() }),
        None => Ok(()),
    }
}

/// Reads the period of each axis off its pairs; checks that all agree and that the mesh fills one period.
fn periodicity<const D: usize, const N: usize>(parts: &MeshParts<D, N>) -> Result<Periodicity<D>, MeshError> {
    let mut periods = [None; D];
    for PeriodicPairs { axis, pairs } in &parts.periodic {
        let axis = *axis;
        let refuse = |found: String, allowed| Err(MeshError::PeriodicAxis { axis, found, allowed });
        if axis >= D {
            return refuse("this number".into(), "axes are numbered from 0 to the dimension less one");
        }
        if periods[axis].is_some() {
            return refuse("two lists of pairs".into(), "each axis may be listed once");
        }
        let Some(&(image, master)) = pairs.first() else {
            return refuse("no pairs".into(), "a periodic axis needs the pairs of its two sides");
        };
        let at = |point: u32| parts.points[point as usize];
        let shift = at(image)[axis] - at(master)[axis];
        let length = shift.abs();
        if length == 0.0 {
            return refuse("a period of zero".into(), "the two sides must lie apart");
        }
        let mut lower = f64::INFINITY;
        for &(image, master) in pairs {
            let displacement = difference(&at(image), &at(master));
            let expected: Vector<D> = std::array::from_fn(|k| if k == axis { shift } else { 0.0 });
            if difference(&displacement, &expected).iter().any(|e| e.abs() > PERIODIC_TOLERANCE * length) {
                return Err(MeshError::PeriodicPair {
                    axis,
                    image,
                    master,
                    displacement: displacement.to_vec(),
                    length,
                });
            }
            lower = lower.min(at(image)[axis]).min(at(master)[axis]);
        }
        let (upper, slack) = (lower + length, PERIODIC_TOLERANCE * length);
        let inside = |x: &Vector<D>| (lower - slack..=upper + slack).contains(&x[axis]);
        if let Some(point) = parts.points.iter().position(|x| !inside(x)) {
            let position = parts.points[point].to_vec();
            return Err(MeshError::OutsidePeriod { point, position, axis, lower, upper });
        }
        periods[axis] = Some(Period { lower, length });
    }
    Ok(Periodicity(periods))
}

/// Renumbers the points, nodes first and images last; returns the node of each point and the number of nodes.
fn nodes_first<const D: usize, const N: usize>(
    mut parts: MeshParts<D, N>,
) -> (MeshParts<D, N>, Vec<u32>, usize) {
    let count = parts.points.len();
    let mut master: Vec<u32> = (0..count as u32).collect();
    for (a, b) in parts.periodic.iter().flat_map(|axis| axis.pairs.iter().copied()) {
        // Join the two sets of images, lowest point first, so that corners shared by several axes close.
        let (a, b) = (root(&master, a), root(&master, b));
        master[a.max(b) as usize] = a.min(b);
    }
    let is_node = |point: &u32| master[*point as usize] == *point;
    let (nodes, images): (Vec<u32>, Vec<u32>) = (0..count as u32).partition(is_node);
    let node_count = nodes.len();
    let order = [nodes, images].concat();
    let mut new = vec![0; count];
    for (index, &point) in order.iter().enumerate() {
        new[point as usize] = index as u32;
    }
    let node_of = order.iter().map(|&point| new[root(&master, point) as usize]).collect();
    let points = order.iter().map(|&point| parts.points[point as usize]).collect();
    parts.points = points;
    parts.cells.iter_mut().flatten().for_each(|point| *point = new[*point as usize]);
    parts.boundary.iter_mut().flat_map(|(face, _)| face).for_each(|point| *point = new[*point as usize]);
    (parts, node_of, node_count)
}

/// The point that a chain of masters ends at.
pub(super) fn root(master: &[u32], mut point: u32) -> u32 {
    while master[point as usize] != point {
        point = master[point as usize];
    }
    point
}

type Geometry<const D: usize, const N: usize> = (Vec<f64>, Vec<[Vector<D>; N]>);

fn geometry<const D: usize, const N: usize>(parts: &MeshParts<D, N>) -> Result<Geometry<D, N>, MeshError> {
    let mut geometry = (Vec::with_capacity(parts.cells.len()), Vec::with_capacity(parts.cells.len()));
    for (cell, corners) in parts.cells.iter().enumerate() {
        let vertices = corners.map(|point| parts.points[point as usize]);
        let (volume, gradients) = volume_and_gradients(&vertices);
        let smallest = SMALLEST_VOLUME * longest_edge(&vertices).powi(D as i32);
        // Also refuses a volume that overflowed or vanished.
        if !(volume > smallest && volume.is_normal()) {
            return Err(MeshError::CellVolume { cell, points: corners.to_vec(), volume });
        }
        geometry.0.push(volume);
        geometry.1.push(gradients);
    }
    Ok(geometry)
}

/// Gives every boundary face its group and an outward order of its corners.
fn name_faces<const D: usize, const N: usize>(
    parts: &MeshParts<D, N>,
    topology: &Topology<D, N>,
) -> Result<Vec<BoundaryFace<D>>, MeshError> {
    let named = named_faces(parts)?;
    let key_of = |face: &Face<D>| face.key;
    for (key, group) in &named {
        let known = topology.boundary.binary_search_by_key(key, key_of).is_ok()
            || topology.periodic.binary_search_by_key(key, key_of).is_ok();
        if !known {
            let group = parts.groups[*group as usize].clone();
            return Err(MeshError::FaceNotOnBoundary { points: key.to_vec(), group });
        }
    }
    let with_group = |face: &Face<D>| {
        let (cell, opposite) = (face.cell, face.opposite);
        let points = outward(&parts.cells[cell as usize], usize::from(opposite));
        match named.binary_search_by_key(&face.key, |entry| entry.0) {
            Ok(index) => Ok(BoundaryFace { points, cell, opposite, group: named[index].1 }),
            Err(_) => {
                let corner = |point: u32, k: usize| parts.points[point as usize][k];
                let centre =
                    (0..D).map(|k| points.iter().map(|&p| corner(p, k)).sum::<f64>() / D as f64).collect();
                Err(MeshError::FaceWithoutGroup { points: points.to_vec(), cell, centre })
            }
        }
    };
    topology.boundary.iter().map(with_group).collect()
}

/// The listed faces, sorted by their sorted corners; checks that groups exist, are used, and do not overlap.
fn named_faces<const D: usize, const N: usize>(
    parts: &MeshParts<D, N>,
) -> Result<Vec<([u32; D], u32)>, MeshError> {
    let mut used = vec![false; parts.groups.len()];
    let mut named = Vec::with_capacity(parts.boundary.len());
    for (face, &(mut key, group)) in parts.boundary.iter().enumerate() {
        let Some(entry) = used.get_mut(group as usize) else {
            return Err(MeshError::NoSuchGroup { face, group, count: parts.groups.len() });
        };
        *entry = true;
        key.sort_unstable();
        named.push((key, group));
    }
    named.sort_unstable();
    if let Some(twice) = named.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        let name = |group: u32| parts.groups[group as usize].clone();
        let (first, second) = (name(twice[0].1), name(twice[1].1));
        return Err(MeshError::FaceListedTwice { points: twice[0].0.to_vec(), first, second });
    }
    match used.iter().position(|&seen| !seen) {
        Some(group) => Err(MeshError::EmptyGroup { group: parts.groups[group].clone() }),
        None => Ok(named),
    }
}
