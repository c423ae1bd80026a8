//! The mesh of moved nodes, in stated velocity fields and with the flow.

mod dam_break;
mod drop;
mod energy;
mod exact;
mod graded;
mod momentum;
mod sloshing;
mod stated_motion;
mod topology;

use crate::support;
use fluid_solver::backend::pfem::Renewal;
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::remesh::{Books, Events, Recognition, Remesher, TargetSize, energy, volume};
use fluid_solver::backend::pfem::wall::{Contacts, Wall};

pub type Cloud2 = Cloud<2, 3>;

/// Nodes without cells.
pub struct Seeds {
    pub cloud: Cloud2,
    walls: Vec<Wall<2>>,
}

impl Seeds {
    pub fn new(walls: &[Wall<2>]) -> Self {
        Self { cloud: Cloud2::default(), walls: walls.to_vec() }
    }

    /// A node; it touches the walls that it lies on.
    pub fn add(&mut self, place: [f64; 2], velocity: [f64; 2]) {
        let mut contacts = Contacts::default();
        for (index, wall) in self.walls.iter().enumerate() {
            if wall.touch(&place, 0.0).gap.abs() < 1e-9 {
                contacts.insert(index);
            }
        }
        let cloud = &mut self.cloud;
        cloud.birth.push(cloud.place.len() as u32);
        cloud.place.push(place);
        cloud.velocity.push(velocity);
        cloud.pressure.push(0.0);
        cloud.contacts.push(contacts);
        cloud.drop.push(0.0);
    }

    /// The box from the origin to `size`, inner nodes displaced at random by up to 0.1 h, then all moved by `map`.
    pub fn add_box(&mut self, size: [f64; 2], h: f64, seed: u64, map: impl Fn([f64; 2]) -> [f64; 2]) {
        let mut state = seed.wrapping_mul(7919).wrapping_add(1);
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 33) as f64 / (1u64 << 31) as f64 - 0.5
        };
        let cells = size.map(|length| (length / h).round() as usize);
        for i in 0..=cells[0] {
            for j in 0..=cells[1] {
                let mut place = [size[0] * i as f64 / cells[0] as f64, size[1] * j as f64 / cells[1] as f64];
                if i > 0 && i < cells[0] && j > 0 && j < cells[1] {
                    place = place.map(|x| x + 0.2 * h * random());
                }
                self.add(map(place), [0.0; 2]);
            }
        }
    }

    /// A disc of rings.
    pub fn add_disc(&mut self, centre: [f64; 2], radius: f64, h: f64, velocity: [f64; 2]) {
        let mut ring = radius;
        while ring > 0.3 * h {
            let nodes = ((std::f64::consts::TAU * ring / h).round() as usize).max(3);
            for k in 0..nodes {
                let angle = std::f64::consts::TAU * k as f64 / nodes as f64 + 17.0 * ring / h;
                self.add([centre[0] + ring * angle.cos(), centre[1] + ring * angle.sin()], velocity);
            }
            ring -= h;
        }
    }

    /// The fluid: cells whose circle is at most α h.
    pub fn mesh(mut self, h: f64, alpha: f64) -> Fluid {
        let size = TargetSize::Constant(h);
        Remesher::<2, 3>::new(Recognition::AlphaShape { alpha })
            .remesh(&mut self.cloud, &self.walls, 0.0, &size, &mut Books::default())
            .unwrap();
        let books = Books::start(&self.cloud);
        let remesher = Remesher::default();
        Fluid { cloud: self.cloud, walls: self.walls, size, books, remesher, time: 0.0 }
    }
}

/// A fluid with its books.
pub struct Fluid {
    pub cloud: Cloud2,
    pub walls: Vec<Wall<2>>,
    pub size: TargetSize,
    pub books: Books<2>,
    pub remesher: Remesher<2, 3>,
    pub time: f64,
}

impl Fluid {
    pub fn remesh(&mut self) -> Events {
        let Self { cloud, walls, size, books, remesher, time } = self;
        remesher.remesh(cloud, walls, *time, size, books).unwrap()
    }

    /// Moves the nodes by a stated field (fourth order), which also becomes their velocity, and remeshes.
    pub fn carry(&mut self, dt: f64, field: impl Fn([f64; 2], f64) -> [f64; 2]) -> Events {
        let t = self.time;
        let ahead = |x: [f64; 2], s: f64, v: [f64; 2]| [x[0] + s * v[0], x[1] + s * v[1]];
        for (x, v) in self.cloud.place.iter_mut().zip(&mut self.cloud.velocity) {
            let k1 = field(*x, t);
            let k2 = field(ahead(*x, 0.5 * dt, k1), t + 0.5 * dt);
            let k3 = field(ahead(*x, 0.5 * dt, k2), t + 0.5 * dt);
            let k4 = field(ahead(*x, dt, k3), t + dt);
            for k in 0..2 {
                x[k] += dt / 6.0 * (k1[k] + 2.0 * k2[k] + 2.0 * k3[k] + k4[k]);
            }
            *v = field(*x, t + dt);
        }
        self.time += dt;
        self.remesh()
    }

    /// Moves the nodes from number `first` on, which must not touch the others.
    pub fn shift(&mut self, first: usize, way: [f64; 2]) {
        self.cloud.place[first..].iter_mut().for_each(|x| (0..2).for_each(|k| x[k] += way[k]));
    }

    /// Moves the nodes by a multiple of their own velocity and remeshes.
    pub fn drift(&mut self, dt: f64) -> Events {
        for (x, v) in self.cloud.place.iter_mut().zip(&self.cloud.velocity) {
            (0..2).for_each(|k| x[k] += dt * v[k]);
        }
        self.time += dt;
        self.remesh()
    }

    /// (Cells + drops)/V0 − 1.
    pub fn volume_error(&self) -> f64 {
        -self.books.volume.missing() / self.books.volume.target
    }

    /// Kinetic and potential energy per density.
    pub fn energy(&self) -> f64 {
        let energy = energy(&self.cloud);
        energy.kinetic + support::G * energy.moment[1]
    }

    /// What every cloud must be: positive cells, neighbours that know each other, books that add up.
    pub fn check(&self) {
        let Self { cloud, books, .. } = self;
        for (c, (cell, around)) in cloud.cells.iter().zip(&cloud.neighbours).enumerate() {
            assert!(volume_of(&cloud.vertices(cell)) > 0.0, "cell {c} at t = {}", self.time);
            for (i, &other) in around.iter().enumerate().filter(|(_, other)| **other != u32::MAX) {
                let face = [cell[(i + 1) % 3], cell[(i + 2) % 3]];
                assert!(cloud.neighbours[other as usize].contains(&(c as u32)));
                assert!(face.iter().all(|node| cloud.cells[other as usize].contains(node)));
            }
        }
        let wet = cloud.wet();
        assert!((0..wet.len()).all(|node| wet[node] == (cloud.drop[node] == 0.0)), "a node is wet or a drop");
        let book = &books.volume;
        let stages = [book.flow, book.management, book.overlap, book.merging, book.correction];
        let change: f64 = stages.iter().map(|stage| stage.sum).sum();
        let others = book.separation.sum + book.absorption.sum;
        let sum = volume(cloud) + cloud.drop.iter().sum::<f64>() - book.target;
        assert!((change + others - sum).abs() < 1e-11 * book.target, "{} against {sum}", change + others);
    }
}

pub fn volume_of(v: &[[f64; 2]; 3]) -> f64 {
    0.5 * ((v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0]))
}
