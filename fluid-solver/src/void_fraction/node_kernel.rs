//! The node kernel: a bell around the grain, evaluated at the nodes.

use super::VoidFractionError;
use super::balance::balance;
use super::node_search::NodeSearch;
use super::weights::{Chunk, Weights};
use crate::element::simplex::Vector;
use crate::mesh::Mesh;
use crate::mesh::locate::{Location, Locator};
use rayon::prelude::*;
use std::ops::RangeInclusive;

/// Ratio of successive diameters for which the gains are balanced.
const LADDER: f64 = 1.25;

/// A grain as the kernel sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grain<const D: usize> {
    /// Centre (m); on periodic axes in any period.
    pub position: Vector<D>,
    /// Diameter (m).
    pub diameter: f64,
}

/// Weights `w_pa ∝ g_a |N_a| (1 - r_a²/R²)³₊`, scaled to `Σ_a w_pa = 1`.
///
/// `r_a` is the distance of node a, `R = √(D + 8) σ` makes σ the standard deviation per direction, and
/// `σ = max(d, h(x_p))` with the diameter d and the mesh size h interpolated to the grain. The weights are non-negative
/// and a Lipschitz-continuous function of the position.
///
/// The gains `g_a` (one inside a regular mesh) see to it that a uniform bed has a uniform solid fraction up to walls,
/// edges and corners, round or flat, where plain scaling would leave 0.69 of it. They depend on σ, so
/// they are made for a ladder of diameters, and a grain takes the nearest.
#[derive(Debug, Clone)]
pub struct NodeKernel<const D: usize> {
    search: NodeSearch<D>,
    diameters: RangeInclusive<f64>,
    levels: Vec<Level>,
}

/// The kernel of the grains around a diameter.
#[derive(Debug, Clone)]
struct Level {
    diameter: f64,
    /// `g_a |N_a|` in the order of the search.
    gains: Vec<f64>,
}

impl<const D: usize> NodeKernel<D> {
    /// Prepares the kernel for a mesh and the diameters of all grains to come.
    ///
    /// # Errors
    /// A range of diameters that is empty, not positive or not finite.
    pub fn new<const N: usize>(
        mesh: &Mesh<D, N>,
        diameters: RangeInclusive<f64>,
    ) -> Result<Self, VoidFractionError> {
        let (smallest, largest) = (*diameters.start(), *diameters.end());
        if !(smallest > 0.0 && smallest <= largest && largest.is_finite()) {
            return Err(VoidFractionError::Range { smallest, largest });
        }
        let search = NodeSearch::new(mesh);
        // Below the finest mesh size the diameter does not matter.
        let finest = mesh.size().iter().copied().fold(f64::INFINITY, f64::min);
        let (first, last) = (smallest.max(finest), largest.max(finest));
        let steps = ((last / first).ln() / LADDER.ln()).ceil().max(0.0);
        let ratio = if steps > 0.0 { (last / first).powf(1.0 / steps) } else { 1.0 };
        let diameters_of_levels = (0..=steps as i32).map(|step| first * ratio.powi(step));
        let levels =
            diameters_of_levels.map(|diameter| Level { diameter, gains: balance(mesh, &search, diameter) });
        let levels = levels.collect();
        Ok(Self { search, diameters, levels })
    }

    /// Finds the host cell of every grain and rebuilds its weights in place.
    ///
    /// `mesh` is the one the kernel and the locator were made for. `hosts` remembers the host cells from call to call; it
    /// speeds the search up and never changes the result. A grain outside the mesh has no host and an empty row.
    ///
    /// # Errors
    /// The first grain whose position is not finite or whose diameter is out of range.
    pub fn weigh<const N: usize>(
        &self,
        mesh: &Mesh<D, N>,
        locator: &Locator<D>,
        grains: &[Grain<D>],
        hosts: &mut Vec<Option<u32>>,
        weights: &mut Weights,
    ) -> Result<(), VoidFractionError> {
        hosts.resize(grains.len(), None);
        let chunks = weights.clear(grains.len()).par_iter_mut();
        let work = chunks
            .zip(grains.par_chunks(Weights::GRAINS_PER_CHUNK))
            .zip(hosts.par_chunks_mut(Weights::GRAINS_PER_CHUNK));
        let fault = work.enumerate().find_map_first(|(index, ((chunk, grains), hosts))| {
            let first = index * Weights::GRAINS_PER_CHUNK;
            let mut numbered = (first..).zip(grains.iter().zip(hosts));
            numbered
                .try_for_each(|(number, (grain, host))| {
                    self.fill_row(mesh, locator, number, grain, host, chunk)
                })
                .err()
        });
        fault.map_or(Ok(()), Err)
    }

    fn fill_row<const N: usize>(
        &self,
        mesh: &Mesh<D, N>,
        locator: &Locator<D>,
        number: usize,
        grain: &Grain<D>,
        host: &mut Option<u32>,
        chunk: &mut Chunk,
    ) -> Result<(), VoidFractionError> {
        let &Grain { position, diameter } = grain;
        if !self.diameters.contains(&diameter) {
            let (smallest, largest) = (*self.diameters.start(), *self.diameters.end());
            return Err(VoidFractionError::Diameter { grain: number, diameter, smallest, largest });
        }
        match locator.locate(mesh, &position, *host) {
            Location::Inside { cell, coordinates } => {
                *host = Some(cell);
                let width = diameter.max(mesh.interpolate(mesh.size(), cell as usize, &coordinates));
                fill(
                    &self.search,
                    &self.level(diameter).gains,
                    &mesh.periodicity().wrap(&position),
                    width,
                    chunk,
                );
            }
            Location::Outside { .. } => {
                *host = None;
                chunk.close_row(0.0);
            }
            Location::NotFinite => {
                return Err(VoidFractionError::Position { grain: number, position: position.to_vec() });
            }
        }
        Ok(())
    }

    /// The level nearest to a diameter, in ratio.
    fn level(&self, diameter: f64) -> &Level {
        let above = self.levels.partition_point(|level| level.diameter < diameter).min(self.levels.len() - 1);
        let below = above.saturating_sub(1);
        let (a, b) = (&self.levels[below], &self.levels[above]);
        if diameter * diameter < a.diameter * b.diameter { a } else { b }
    }
}

/// Radius R of the kernel of width σ: `(1 - r²/R²)³` has the variance `R²/(D + 8)` per direction.
pub(super) fn radius<const D: usize>(width: f64) -> f64 {
    (D as f64 + 8.0).sqrt() * width
}

/// Appends the row of a kernel of the given width around `x`.
pub(super) fn fill<const D: usize>(
    search: &NodeSearch<D>,
    gains: &[f64],
    x: &Vector<D>,
    width: f64,
    chunk: &mut Chunk,
) {
    let radius = radius::<D>(width);
    let per_square = 1.0 / (radius * radius);
    search.for_each_run(x, radius, |run, x| {
        let (order, positions, gains) =
            (&search.order()[run.clone()], &search.positions()[run.clone()], &gains[run]);
        chunk.extend_row(order, |candidate| {
            let node = &positions[candidate];
            let squared: f64 = (0..D).map(|k| (node[k] - x[k]) * (node[k] - x[k])).sum();
            let height = (1.0 - squared * per_square).max(0.0);
            gains[candidate] * (height * height * height)
        });
    });
    if search.sees_images_of_one_node(radius) {
        chunk.merge_row();
    }
    chunk.close_row(width);
}
