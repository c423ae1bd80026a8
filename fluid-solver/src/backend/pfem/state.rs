//! What the fluid is between two steps, and all that the next one depends on.

use super::cloud::Cloud;
use super::gate::Passed;
use super::remesh::{Books, Energy, Events, volumes_between_grains};
use crate::element::simplex::Vector;

/// The cloud, its books, and what was counted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State<const D: usize, const N: usize> {
    /// Nodes and cells.
    pub cloud: Cloud<D, N>,
    /// What remeshing did to volume and energy.
    pub books: Books<D>,
    /// Energy (J per m of depth in 2D): what it was at the start, and what walls, the body force and the gates have given
    /// since.
    pub given: f64,
    /// Volume of the fluid without the grains in it (m³; m² in 2D): what the cells and drops hold less what grains take.
    pub fluid_volume: f64,
    /// What passed inlets and outlets since the start.
    pub passed: Passed<D>,
    /// What happened to the surface.
    pub counts: Counts,
}

/// How often what happened to the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Cells of void between approaching surfaces that became fluid.
    pub closed: u64,
    /// Voids that were filled.
    pub filled: u64,
    /// Thin cells broken off.
    pub broken: u64,
    /// Drops that left.
    pub released: u64,
    /// Drops taken up.
    pub absorbed: u64,
}

impl Counts {
    /// Counts what a remeshing did.
    pub fn add(&mut self, events: &Events) {
        self.closed += u64::from(events.closed);
        self.filled += u64::from(events.filled);
        self.broken += u64::from(events.broken);
        self.released += u64::from(events.released);
        self.absorbed += u64::from(events.absorbed);
    }

    /// By name.
    pub fn named(&self) -> [(&'static str, u64); 5] {
        [
            ("surface-gaps-closed", self.closed),
            ("voids-filled", self.filled),
            ("thin-cells-broken-off", self.broken),
            ("drops-released", self.released),
            ("drops-absorbed", self.absorbed),
        ]
    }
}

impl<const D: usize, const N: usize> State<D, N> {
    /// A fluid at its start.
    pub fn start(cloud: Cloud<D, N>, density: f64, acceleration: &Vector<D>) -> Self {
        let books = Books::start(&cloud);
        let fluid_volume = books.volume.target;
        let mut state = Self { cloud, books, fluid_volume, ..Self::default() };
        let (kinetic, potential) = state.energies(density, acceleration, &vec![1.0; state.cloud.place.len()]);
        state.given = kinetic + potential;
        state
    }

    /// Books what passed the gates in a step.
    pub fn pass(&mut self, passed: &Passed<D>, density: f64) {
        let gained = passed.entered.less(&passed.left);
        self.passed = self.passed.and(passed);
        self.given += density * gained.energy;
        self.fluid_volume += gained.volume;
        self.books.volume.target += gained.volume;
        self.books.volume.cells += gained.volume;
    }

    /// ∫½ρε|v|² dV and −∫ρεg·x dV, drops included (J; per m of depth in 2D).
    pub fn energies(&self, density: f64, acceleration: &Vector<D>, void_fraction: &[f64]) -> (f64, f64) {
        let energy = Energy::of(&self.cloud, &volumes_between_grains(&self.cloud, void_fraction));
        let potential: f64 = (0..D).map(|k| -acceleration[k] * energy.moment[k]).sum();
        (density * energy.kinetic, density * potential)
    }
}
