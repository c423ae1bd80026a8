//! The cloud while it is edited: its surface, and what is known of its nodes beside their state.

use super::books::volumes;
use super::size::TargetSize;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE, retain};
use crate::backend::pfem::wall::Contacts;
use crate::element::simplex::{Vector, distance};

/// No node, or more than one.
pub const NONE: u32 = u32::MAX;

/// Scratch of one remeshing.
#[derive(Clone, Debug, Default)]
pub struct Draft<const D: usize = 2> {
    /// Edges (in space: faces) of the surface, walls included, with the fluid on their left (behind them).
    pub edges: Vec<[u32; D]>,
    /// Node after each on the surface, where there is exactly one.
    pub next: Vec<u32>,
    /// Node before.
    pub previous: Vec<u32>,
    /// Whether a node is on the surface.
    pub exposed: Vec<bool>,
    /// Whether a node is to go.
    pub removed: Vec<bool>,
    /// Target size h at each node (m).
    pub size: Vec<f64>,
    /// Volume of each node before: a third of its cells, or its drop.
    pub mass: Vec<f64>,
    /// Whether nodes came, went or were moved by an edit.
    pub edited: bool,
    /// Edges that wait to be forced into the triangulation.
    pub waiting: Vec<[u32; 2]>,
    youngest: u32,
    place_of: Vec<u32>,
}

impl Draft {
    /// Reads the moved cloud.
    pub fn read(&mut self, cloud: &Cloud<2, 3>, size: &TargetSize) {
        self.read_sizes(cloud, size);
        volumes(cloud, &mut self.mass);
        self.edges.clear();
        for (cell, around) in cloud.cells.iter().zip(&cloud.neighbours) {
            for i in (0..3).filter(|&i| around[i] == OUTSIDE) {
                self.edges.push([cell[(i + 1) % 3], cell[(i + 2) % 3]]);
            }
        }
        self.link(cloud.place.len());
    }

    /// Links the edges from node to node.
    pub fn link(&mut self, nodes: usize) {
        for links in [&mut self.next, &mut self.previous] {
            links.clear();
            links.resize(nodes, NONE);
        }
        self.exposed.clear();
        self.exposed.resize(nodes, false);
        let mut pinched = Vec::new();
        for &[a, b] in &self.edges {
            if self.next[a as usize] != NONE || self.previous[b as usize] != NONE {
                pinched.push(if self.next[a as usize] != NONE { a } else { b });
            }
            self.next[a as usize] = b;
            self.previous[b as usize] = a;
            self.exposed[a as usize] = true;
        }
        for node in pinched {
            self.next[node as usize] = NONE;
            self.previous[node as usize] = NONE;
        }
    }
}

impl<const D: usize> Draft<D> {
    /// Reads the sizes at the nodes of the moved cloud, none of which goes yet.
    pub fn read_sizes<const N: usize>(&mut self, cloud: &Cloud<D, N>, size: &TargetSize) {
        let nodes = cloud.place.len();
        size.at_nodes(cloud, &mut self.size);
        self.removed.clear();
        self.removed.resize(nodes, false);
        self.youngest = cloud.birth.iter().copied().max().unwrap_or(0);
        self.edited = false;
    }

    /// Target size between two nodes (m).
    pub fn size_between(&self, a: u32, b: u32) -> f64 {
        0.5 * (self.size[a as usize] + self.size[b as usize])
    }

    /// Adds a node halfway between two.
    pub fn add_between<const N: usize>(
        &mut self,
        cloud: &mut Cloud<D, N>,
        a: u32,
        b: u32,
        contacts: Contacts,
    ) -> u32 {
        let (a, b) = (a as usize, b as usize);
        let mean = |values: &[Vector<D>]| std::array::from_fn(|k| 0.5 * (values[a][k] + values[b][k]));
        let (place, velocity) = (mean(&cloud.place), mean(&cloud.velocity));
        let pressure = 0.5 * (cloud.pressure[a] + cloud.pressure[b]);
        self.add(cloud, place, velocity, pressure, contacts, 0.5 * (self.size[a] + self.size[b]))
    }

    /// Adds a node.
    pub fn add<const N: usize>(
        &mut self,
        cloud: &mut Cloud<D, N>,
        place: Vector<D>,
        velocity: Vector<D>,
        pressure: f64,
        contacts: Contacts,
        size: f64,
    ) -> u32 {
        self.edited = true;
        self.youngest += 1;
        cloud.place.push(place);
        cloud.velocity.push(velocity);
        cloud.pressure.push(pressure);
        cloud.contacts.push(contacts);
        cloud.drop.push(0.0);
        cloud.birth.push(self.youngest);
        self.removed.push(false);
        self.size.push(size);
        self.mass.push(0.0);
        cloud.place.len() as u32 - 1
    }

    /// Marks a node to go.
    pub fn remove(&mut self, node: u32) {
        self.edited = true;
        self.removed[node as usize] = true;
    }

    /// Makes one node of two at the same place, as in the corner of two walls.
    pub fn unite<const N: usize>(&mut self, cloud: &mut Cloud<D, N>, gone: u32, kept: u32) {
        for wall in cloud.contacts[gone as usize].iter() {
            cloud.contacts[kept as usize].insert(wall);
        }
        self.mass[kept as usize] += self.mass[gone as usize];
        self.remove(gone);
        for node in self.edges.iter_mut().flatten().filter(|node| **node == gone) {
            *node = kept;
        }
        self.edges.retain(|edge| edge.iter().filter(|node| **node == kept).count() < 2);
    }

    /// Takes the nodes out that are to go; edges of the surface have none of them.
    pub fn compact<const N: usize>(&mut self, cloud: &mut Cloud<D, N>) {
        if !self.removed.contains(&true) {
            return;
        }
        let removed = std::mem::take(&mut self.removed);
        cloud.remove(&removed, &mut self.place_of);
        retain(&removed, &mut self.size);
        retain(&removed, &mut self.mass);
        self.removed = removed;
        self.removed.clear();
        self.removed.resize(cloud.place.len(), false);
        for node in self.edges.iter_mut().flatten() {
            *node = self.place_of[*node as usize];
        }
    }
}

/// Height of a triangle over its longest edge, signed as its area (m).
pub fn height(vertices: &[Vector<2>; 3]) -> f64 {
    let longest = crate::element::simplex::longest_edge(vertices);
    2.0 * area(vertices) / longest
}

/// Signed area of a triangle.
pub fn area(v: &[Vector<2>; 3]) -> f64 {
    0.5 * ((v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0]))
}

/// Radius of the circle through the corners of a triangle (m).
pub fn circumradius(v: &[Vector<2>; 3]) -> f64 {
    distance(&v[0], &v[1]) * distance(&v[1], &v[2]) * distance(&v[2], &v[0]) / (4.0 * area(v).abs())
}
