//! Nodes come and go so that neighbours stand about h apart.

use super::super::draft::Draft;
use super::super::management::{CLOSEST, CLOSEST_TO_SURFACE, SHORTEST};
use super::fans::Fans;
use super::freedom::{along_walls, behind, onto_walls};
use super::surface::Edits;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::backend::pfem::wall::{Contacts, Wall, inlet_of};
use crate::element::simplex::{Vector, cross, difference, distance, dot, volume_and_areas};

/// Management of nodes; all of it is scratch.
#[derive(Default)]
pub struct Management {
    close: Vec<Close>,
    far: Vec<Far>,
    settled: Vec<bool>,
    edits: Edits,
    fans: Fans,
}

/// A node too close to another.
struct Close {
    distance: f64,
    goes: u32,
    stays: u32,
    /// Whether both are on the surface.
    surface: bool,
}

/// An edge too long.
struct Far {
    length: f64,
    edge: [u32; 2],
    surface: bool,
}

/// Edges longer than this share of h on the surface are split: the diagonals of squares are not.
const LONGEST: f64 = 1.6;
/// Inner edges longer than this share of h get a node: the diagonals of cubes do not.
const FARTHEST: f64 = 1.9;
/// A node that sees less than this many h² of surface is not shifted to keep the volume.
const FACING: f64 = 0.1;
/// Nor is one by more than this many h.
const SHIFT: f64 = 0.25;
/// A node that would take volume with it into a node of more walls does so only if it is this near, in h: else films on walls
/// vanish.
const ABSORBED: f64 = 0.25;

/// Pairs of corners of a cell.
const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

impl Management {
    /// Manages the nodes of the moved cloud, and its surface. The old cells keep the nodes that go until the new ones
    /// replace them.
    pub fn manage(&mut self, cloud: &mut Cloud<3, 4>, draft: &mut Draft<3>, walls: &[Wall<3>], time: f64) {
        self.close.clear();
        self.far.clear();
        self.measure_cells(cloud, draft);
        self.measure_surface(cloud, draft);
        self.settled.clear();
        self.settled.resize(cloud.place.len(), false);
        self.edits.begin(cloud.place.len());
        self.fans.read(&draft.edges, cloud.place.len());
        self.remove_close(cloud, draft, walls, time);
        self.insert_between_far(cloud, draft, walls, time);
        self.edits.apply(&mut draft.edges);
    }

    /// Finds edges of cells, each of them often, that are too short or too long, and inner nodes close to the surface.
    fn measure_cells(&mut self, cloud: &Cloud<3, 4>, draft: &Draft<3>) {
        let exposed = |node: u32| draft.exposed[node as usize];
        for (cell, around) in cloud.cells.iter().zip(&cloud.neighbours) {
            let vertices = cloud.vertices(cell);
            let sizes = cell.map(|node| draft.size[node as usize]);
            for [i, j] in EDGES {
                let edge = difference(&vertices[i], &vertices[j]);
                let (square, h) = (dot(&edge, &edge), 0.5 * (sizes[i] + sizes[j]));
                if square < (CLOSEST * h).powi(2) {
                    let (a, b) = (cell[i].min(cell[j]), cell[i].max(cell[j]));
                    let (distance, surface) = (square.sqrt(), false);
                    let younger = cloud.birth[a as usize] > cloud.birth[b as usize];
                    let near = distance < CLOSEST_TO_SURFACE * h;
                    let (goes, stays) = match (exposed(a), exposed(b)) {
                        (false, false) if younger => (a, b),
                        (false, false) => (b, a),
                        (true, false) if near => (b, a),
                        (false, true) if near => (a, b),
                        _ => continue,
                    };
                    self.close.push(Close { distance, goes, stays, surface });
                } else if square > (FARTHEST * h).powi(2) {
                    let edge = [cell[i].min(cell[j]), cell[i].max(cell[j])];
                    self.far.push(Far { length: square.sqrt(), edge, surface: false });
                }
            }
            for i in (0..4).filter(|&i| around[i] == OUTSIDE && !exposed(cell[i])) {
                let (volume, areas) = volume_and_areas(&vertices);
                let distance = volume / dot(&areas[i], &areas[i]).sqrt();
                if distance < CLOSEST_TO_SURFACE * sizes[i] {
                    let (goes, stays) = (cell[i], cell[(i + 1) % 4]);
                    self.close.push(Close { distance, goes, stays, surface: false });
                }
            }
        }
    }

    /// Finds edges of the surface that are too short or too long.
    fn measure_surface(&mut self, cloud: &Cloud<3, 4>, draft: &Draft<3>) {
        let around = |face: &[u32; 3]| [0, 1, 2].map(|k| [face[k], face[(k + 1) % 3]]);
        for [a, b] in draft.edges.iter().flat_map(around).filter(|[a, b]| a < b) {
            let length = distance(&cloud.place[a as usize], &cloud.place[b as usize]);
            let h = draft.size_between(a, b);
            if length > LONGEST * h {
                self.far.push(Far { length, edge: [a, b], surface: true });
            } else if length < SHORTEST * h {
                let (ka, kb) = (cloud.contacts[a as usize], cloud.contacts[b as usize]);
                let younger = cloud.birth[a as usize] > cloud.birth[b as usize];
                // Whoever touches all that the other touches, and more, stays.
                if ka.common(kb) == ka && (ka != kb || younger) {
                    self.close.push(Close { distance: length, goes: a, stays: b, surface: true });
                } else if ka.common(kb) == kb {
                    self.close.push(Close { distance: length, goes: b, stays: a, surface: true });
                }
            }
        }
    }

    /// Takes nodes away that are too close, closest first.
    fn remove_close(&mut self, cloud: &mut Cloud<3, 4>, draft: &mut Draft<3>, walls: &[Wall<3>], time: f64) {
        let Self { close, settled, edits, fans, .. } = self;
        let order = |p: &Close, q: &Close| {
            p.distance.total_cmp(&q.distance).then((p.goes, p.stays).cmp(&(q.goes, q.stays)))
        };
        close.sort_unstable_by(order);
        for &Close { distance, goes, stays, surface } in &*close {
            let [gone, left] = [goes as usize, stays as usize];
            let inner = !draft.exposed[gone];
            if settled[gone]
                || draft.removed[gone]
                || draft.removed[left]
                || (settled[left] && !(inner && draft.exposed[left]))
            {
                continue;
            }
            if surface {
                let contacts = cloud.contacts[left];
                if cloud.contacts[gone] == contacts && inlet_of(walls, contacts).is_none() {
                    let middle = |values: &[Vector<3>]| {
                        std::array::from_fn(|k| 0.5 * (values[gone][k] + values[left][k]))
                    };
                    cloud.velocity[left] = middle(&cloud.velocity);
                    // The faces still have the old places.
                    let middle = onto_walls(contacts, middle(&cloud.place), walls, time);
                    cloud.place[left] =
                        neutral(cloud, draft, (fans, edits), [goes, stays], middle, walls, time)
                            .unwrap_or(middle);
                } else {
                    let place = cloud.place[left];
                    match neutral(cloud, draft, (fans, edits), [goes, stays], place, walls, time) {
                        Some(place) => cloud.place[left] = place,
                        None if distance > ABSORBED * draft.size_between(goes, stays) => continue,
                        None => {}
                    }
                }
                edits.collapse(goes, stays);
            }
            draft.remove(goes);
            (settled[gone], settled[left]) = (true, true);
        }
    }

    /// Adds nodes in the middle of edges that are too long, those of the surface before all others, longest first.
    fn insert_between_far(
        &mut self,
        cloud: &mut Cloud<3, 4>,
        draft: &mut Draft<3>,
        walls: &[Wall<3>],
        time: f64,
    ) {
        let Self { far, settled, edits, .. } = self;
        let order = |p: &Far, q: &Far| {
            q.surface.cmp(&p.surface).then(q.length.total_cmp(&p.length)).then(p.edge.cmp(&q.edge))
        };
        far.sort_unstable_by(order);
        for &Far { edge: [a, b], surface, .. } in &*far {
            if settled[a as usize] || settled[b as usize] {
                continue;
            }
            (settled[a as usize], settled[b as usize]) = (true, true);
            let common = cloud.contacts[a as usize].common(cloud.contacts[b as usize]);
            let mut contacts = if surface { common } else { Contacts::default() };
            let node = draft.add_between(cloud, a, b, contacts);
            let place = &mut cloud.place[node as usize];
            let met: Vec<usize> = behind(contacts, place, walls, time).collect();
            met.iter().for_each(|&wall| contacts.insert(wall));
            *place = onto_walls(contacts, *place, walls, time);
            cloud.contacts[node as usize] = contacts;
            draft.exposed.push(surface);
            if surface {
                edits.split([a, b], node);
            }
        }
    }
}

/// Where near x a node keeps the volume if the two ends of an edge of the surface become that node: x + s A, where A is half
/// the area of what it sees, along the walls that the end that stays touches; nowhere, where that is too far away or behind
/// a wall.
fn neutral(
    cloud: &Cloud<3, 4>,
    draft: &Draft<3>,
    (fans, edits): (&Fans, &Edits),
    [goes, stays]: [u32; 2],
    x: Vector<3>,
    walls: &[Wall<3>],
    time: f64,
) -> Option<Vector<3>> {
    let contacts = cloud.contacts[stays as usize];
    let (mut lost, mut area) = (0.0, [0.0; 3]);
    for (end, other) in [(goes, stays), (stays, goes)] {
        for &face in fans.around(end) {
            let face = draft.edges[face as usize].map(|node| edits.heir(node));
            let Some(k) = face.iter().position(|&node| node == end) else { continue };
            let [near, a, b] = [0, 1, 2].map(|i| difference(&cloud.place[face[(k + i) % 3] as usize], &x));
            let normal = cross(&a, &b);
            let shared = face.contains(&other);
            // A face of both is met twice and vanishes.
            lost += dot(&near, &normal) * if shared { 0.5 } else { 1.0 };
            if !shared {
                area = std::array::from_fn(|k| area[k] + normal[k]);
            }
        }
    }
    let along = along_walls(&area, contacts, &x, walls, time);
    let h = draft.size_between(goes, stays);
    let square = dot(&along, &along);
    let share = lost / square;
    if square.sqrt() < FACING * h * h || share.abs() * square.sqrt() > SHIFT * h {
        return None;
    }
    let place = std::array::from_fn(|k| x[k] + share * along[k]);
    let place = onto_walls(contacts, place, walls, time);
    behind(contacts, &place, walls, time).next().is_none().then_some(place)
}

#[cfg(test)]
mod tests {
    use super::super::super::size::TargetSize;
    use super::super::surface;
    use super::*;
    use crate::backend::pfem::body::Body;
    use crate::backend::pfem::wall::{Inflow, Plane};
    use std::sync::Arc;

    #[test]
    fn an_edge_of_a_ball_that_becomes_a_node_takes_no_volume() {
        let mut cloud = Body::<3, 4>::of_sphere([0.0; 3], 1.0, 0.25).unwrap().cloud();
        let mut draft = Draft::<3>::default();
        let mut management = Management::default();
        draft.read_sizes(&cloud, &TargetSize::Constant(0.25));
        surface::read(&cloud, &mut draft);
        let (faces, before) = (draft.edges.len(), surface::enclosed(&cloud, &draft));
        // A short edge.
        let [a, b, _] = draft.edges[0].map(|node| node as usize);
        let drawn = std::array::from_fn(|k| 0.7 * cloud.place[b][k] + 0.3 * cloud.place[a][k]);
        let radius = dot(&drawn, &drawn).sqrt();
        cloud.place[a] = drawn.map(|x: f64| x / radius);
        let moved = surface::enclosed(&cloud, &draft);
        assert!((moved - before).abs() > 1e-5);
        management.manage(&mut cloud, &mut draft, &[], 0.0);
        assert_eq!(draft.edges.len(), faces - 2);
        assert!((surface::enclosed(&cloud, &draft) - moved).abs() < 1e-14);
    }

    #[test]
    fn nodes_in_an_inlet_stay_where_they_are_when_others_come_near() {
        let mut cloud = Body::<3, 4>::of_box([0.0; 3], [1.0; 3], 0.25).unwrap().cloud();
        let plane = Plane { point: [0.0; 3], normal: [0.0, 0.0, 1.0] };
        let inflow =
            Inflow::new::<4>(plane.normal, 1.0, std::iter::empty(), Arc::new(|_, _| [0.0, 0.0, 1.0]));
        let walls = [Wall::inlet("inlet", plane, inflow)];
        let inlet: Vec<usize> = (0..cloud.place.len()).filter(|&node| cloud.place[node][2] == 0.0).collect();
        inlet.iter().for_each(|&node| cloud.contacts[node].insert(0));
        // The youngest comes near a node of the edge.
        let youngest = inlet.iter().copied().find(|&node| cloud.place[node][..2] == [0.25, 0.25]).unwrap();
        cloud.birth[youngest] = u32::MAX - 1;
        cloud.place[youngest] = [0.05, 0.25, 0.0];
        let before = cloud.place.clone();
        let (mut draft, mut management) = (Draft::<3>::default(), Management::default());
        draft.read_sizes(&cloud, &TargetSize::Constant(0.25));
        surface::read(&cloud, &mut draft);
        management.manage(&mut cloud, &mut draft, &walls, 0.0);
        assert!(draft.removed[youngest]);
        for &node in inlet.iter().filter(|&&node| node != youngest) {
            assert!(!draft.removed[node] && cloud.place[node] == before[node], "{:?}", before[node]);
        }
    }
}
