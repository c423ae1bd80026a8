//! Which nodes walls hold, and how.

use super::constraint::Constraint;
use crate::backend::Step;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::backend::pfem::wall::{Contacts, Grip, Shape, Touch, Wall, inlet_of, inlet_velocity};
use crate::element::simplex::{Vector, dot};
use std::collections::BTreeMap;

/// A node has come past an edge of a wall where the normal has turned by more than the angle of this cosine.
const EDGE: f64 = 0.7;

/// A node that has come over edges within a wall this often in a step is held in the last one: what either side of it lets
/// it do takes it to the other.
const CROSSINGS: usize = 3;

/// A normal has turned where it is off by more than this.
const TURNED: f64 = 1e-6;

/// So often a node in a corner is put where the walls of it leave it, and these are looked at from there.
const SWEEPS: usize = 3;

/// A drop flies away from a wall with more than this share of its speed.
const AWAY: f64 = 1e-9;

/// A gap above minus this share of the way of a node is none.
const TOUCHING: f64 = 1e-12;

impl<const D: usize, const N: usize> Cloud<D, N> {
    /// Calls `visit` with a cell and the corner opposite to each of its faces on the free surface: those without
    /// neighbour whose nodes are not all on one wall.
    pub fn for_each_free_face(&self, mut visit: impl FnMut(usize, usize)) {
        for (cell, (nodes, neighbours)) in self.cells.iter().zip(&self.neighbours).enumerate() {
            for opposite in (0..N).filter(|&corner| neighbours[corner] == OUTSIDE) {
                let face = (0..N).filter(|&corner| corner != opposite);
                let contacts = face.map(|corner| self.contacts[nodes[corner] as usize]);
                if contacts.reduce(Contacts::common).is_none_or(Contacts::is_empty) {
                    visit(cell, opposite);
                }
            }
        }
    }
}

/// The walls that act on the nodes in a step: those touched at its start, and those that would be crossed.
#[derive(Debug, Default)]
pub struct Contact<const D: usize> {
    /// Walls that each node will touch at the end.
    pub touched: Vec<Contacts>,
    /// What they prescribe of v_m.
    pub constraints: Vec<Constraint<D>>,
    /// Whether each node sticks to the walls that it touched at the start where they grip: drops and nodes of the free
    /// surface slide.
    sticks: Vec<bool>,
    /// How nodes stand to the surfaces of facets that hold them, by node and wall.
    facets: BTreeMap<(usize, usize), Held<D>>,
    /// The first node of a cell that came round the end of a wall with the velocities looked at last, and that wall.
    pub round_end: Option<(usize, usize)>,
}

/// n·v_m = c of the facet that holds a node, after that of the one before it.
#[derive(Debug)]
struct Held<const D: usize> {
    facets: [(Vector<D>, f64); 2],
    crossings: usize,
}

impl<const D: usize> Held<D> {
    /// The node is held by this facet now.
    fn by(&mut self, facet: (Vector<D>, f64)) {
        if self.in_edge().is_some() {
            return;
        }
        if dot(&self.facets[1].0, &facet.0) < 1.0 - TURNED {
            self.facets[0] = self.facets[1];
            self.crossings += 1;
        }
        self.facets[1] = facet;
    }

    /// Both facets, if the node is held in the edge between them.
    fn in_edge(&self) -> Option<&[(Vector<D>, f64); 2]> {
        (self.crossings == CROSSINGS).then_some(&self.facets)
    }
}

impl<const D: usize> Contact<D> {
    /// Starts a step with the walls touched: a node of a free face slides, others stick to walls that grip.
    pub fn begin<const N: usize>(&mut self, cloud: &Cloud<D, N>) {
        self.touched.clone_from(&cloud.contacts);
        self.facets.clear();
        self.round_end = None;
        self.sticks.clear();
        self.sticks.resize(cloud.place.len(), false);
        for &node in cloud.cells.as_flattened() {
            self.sticks[node as usize] = true;
        }
        cloud.for_each_free_face(|cell, opposite| {
            for corner in (0..N).filter(|&corner| corner != opposite) {
                self.sticks[cloud.cells[cell][corner] as usize] = false;
            }
        });
        self.constraints.clear();
        self.constraints.resize(cloud.place.len(), Constraint::FREE);
    }

    /// Lets a drop go that flies away from the walls it touches: nothing sucks it back.
    pub fn let_fly(&mut self, walls: &[Wall<D>], step: Step, node: usize, place: &Vector<D>, v: &Vector<D>) {
        let speed = dot(v, v).sqrt();
        for wall in self.touched[node].iter() {
            let touch = walls[wall].touch(place, step.time);
            if dot(&touch.normal, v) - dot(&touch.normal, &touch.velocity) > AWAY * speed {
                self.touched[node].remove(wall);
            }
        }
    }

    /// Prescribes v_m such that the gaps at the end vanish: n·v_m = n·v − gap(x_n + Δt v)/Δt, linear about the iterate v, or
    /// in a corner about the place that the walls of it leave; a node that goes to and fro over an edge within a wall is held
    /// by both sides of it. A node that sticks has the velocity of the wall in the middle of the step, one in an inlet that of
    /// what comes in.
    pub fn constrain<const N: usize>(
        &mut self,
        cloud: &Cloud<D, N>,
        walls: &[Wall<D>],
        step: Step,
        v: &[Vector<D>],
    ) {
        let middle = step.time + 0.5 * step.length;
        for (node, touched) in self.touched.iter().enumerate() {
            if touched.is_empty() {
                self.constraints[node] = Constraint::FREE;
                continue;
            }
            let (place, mut v) = (&cloud.place[node], v[node]);
            if let Some(given) = inlet_velocity(walls, *touched, place, middle) {
                self.constraints[node] = Constraint::whole(&given);
                continue;
            }
            let held = cloud.contacts[node].iter();
            let gripping = held.filter(|_| self.sticks[node]).find(|&wall| walls[wall].grip == Grip::NoSlip);
            if let Some(wall) = gripping {
                v = walls[wall].touch(&moved(place, 0.5 * step.length, &v), middle).velocity;
            }
            let on_facet = |wall: usize, v: &Vector<D>| {
                let touch = reached(&walls[wall], step, place, v);
                (touch.normal, dot(&touch.normal, v) - touch.gap / step.length)
            };
            for wall in touched.iter().filter(|&wall| matches!(walls[wall].shape, Shape::Patch(_))) {
                let facet = on_facet(wall, &v);
                let first = || Held { facets: [facet; 2], crossings: 0 };
                self.facets.entry((node, wall)).or_insert_with(first).by(facet);
            }
            let facets = &self.facets;
            let hold = |v: &Vector<D>| {
                let mut constraint = Constraint::FREE;
                for wall in touched.iter() {
                    match facets.get(&(node, wall)).and_then(Held::in_edge) {
                        Some(sides) => {
                            sides.iter().for_each(|(normal, value)| constraint.add(normal, *value))
                        }
                        None => {
                            let (normal, value) = on_facet(wall, v);
                            constraint.add(&normal, value);
                        }
                    }
                }
                constraint
            };
            let mut constraint = hold(&v);
            // From beyond the edge of a corner a wall is not seen as from within it.
            for _ in 0..if touched.iter().nth(1).is_some() { SWEEPS } else { 0 } {
                v = constraint.impose(&v);
                constraint = hold(&v);
            }
            if gripping.is_some() {
                constraint.complete(&v);
            }
            self.constraints[node] = constraint;
        }
    }

    /// Adds the walls that nodes would cross with these velocities; how many. Nodes in inlets cross none, and none come to be in
    /// one. What came round the end of a surface did not cross it: drops pass behind it.
    pub fn find<const N: usize>(
        &mut self,
        cloud: &Cloud<D, N>,
        walls: &[Wall<D>],
        step: Step,
        v: &[Vector<D>],
    ) -> usize {
        let mut found = 0;
        self.round_end = None;
        for (node, touched) in self.touched.iter_mut().enumerate() {
            if inlet_of(walls, *touched).is_some() {
                continue;
            }
            let end = moved(&cloud.place[node], step.length, &v[node]);
            let way = step.length * v[node].iter().map(|v| v.abs()).sum::<f64>();
            for (index, wall) in walls.iter().enumerate() {
                if touched.contains(index) || wall.gap(&end, step.end()) >= -TOUCHING * way {
                    continue;
                }
                let place = &cloud.place[node];
                if wall.is_out_of_reach(place, step.time, way, step.length) {
                    let passes = wall.is_open() && cloud.drop[node] > 0.0;
                    if passes || wall.is_nearest_at_corner(place, step.time) {
                        continue;
                    }
                    if wall.is_open() && wall.gap(place, step.time) > 0.0 {
                        self.round_end.get_or_insert((node, index));
                        continue;
                    }
                }
                touched.insert(index);
                found += 1;
            }
        }
        found
    }

    /// v_{n+1} of a node that moved with v_m = `middle`: the walls' own velocity in the directions they hold, `v` else; all of
    /// it is given in an inlet.
    pub fn at_end<const N: usize>(
        &self,
        cloud: &Cloud<D, N>,
        walls: &[Wall<D>],
        step: Step,
        node: usize,
        middle: &Vector<D>,
        v: &Vector<D>,
    ) -> Vector<D> {
        let (touched, held) = (self.touched[node], cloud.contacts[node]);
        if let Some(given) = inlet_velocity(walls, touched, &cloud.place[node], step.end()) {
            return given;
        }
        let mut constraint = Constraint::FREE;
        let mut gripped = None;
        for wall in touched.iter() {
            let touch = reached(&walls[wall], step, &cloud.place[node], middle);
            let in_edge = self.facets.get(&(node, wall)).and_then(Held::in_edge);
            for (normal, _) in in_edge.into_iter().flatten() {
                constraint.add(normal, dot(normal, &touch.velocity));
            }
            constraint.add(&touch.normal, dot(&touch.normal, &touch.velocity));
            if walls[wall].grip == Grip::NoSlip && self.sticks[node] && held.contains(wall) {
                gripped = Some(touch.velocity);
            }
        }
        if let Some(velocity) = gripped {
            constraint.complete(&velocity);
        }
        constraint.impose(v)
    }

    /// The walls that nodes touch at the end: they let go of those past whose edges they slid.
    pub fn left<const N: usize>(
        &self,
        cloud: &Cloud<D, N>,
        walls: &[Wall<D>],
        step: Step,
        v: &[Vector<D>],
    ) -> Vec<Contacts> {
        let mut contacts = self.touched.clone();
        for (node, contacts) in contacts.iter_mut().enumerate() {
            let end = moved(&cloud.place[node], step.length, &v[node]);
            for wall in contacts.iter() {
                let [before, after] = turn(&walls[wall], step, &cloud.place[node], &end);
                if after.gap > 0.0 && dot(&before.normal, &after.normal) < EDGE {
                    contacts.remove(wall);
                }
            }
        }
        contacts
    }
}

/// How a wall stands to the start of a node's way, and to its end.
fn turn<const D: usize>(wall: &Wall<D>, step: Step, start: &Vector<D>, end: &Vector<D>) -> [Touch<D>; 2] {
    [wall.touch(start, step.time), wall.touch(end, step.end())]
}

/// How a wall stands to where v takes a node from x. Past an edge what the node slid on goes on as a plane: held by this side
/// of an edge in one pass and by that in the next, no step would settle.
fn reached<const D: usize>(wall: &Wall<D>, step: Step, x: &Vector<D>, v: &Vector<D>) -> Touch<D> {
    let [before, after] = turn(wall, step, x, &moved(x, step.length, v));
    if dot(&before.normal, &after.normal) >= EDGE {
        return after;
    }
    let apart = dot(&before.normal, v) - dot(&before.normal, &before.velocity);
    Touch { gap: before.gap + step.length * apart, ..before }
}

/// x + t v.
pub fn moved<const D: usize>(x: &Vector<D>, t: f64, v: &Vector<D>) -> Vector<D> {
    std::array::from_fn(|k| x[k] + t * v[k])
}
