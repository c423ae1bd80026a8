//! Grains in a fluid with a free surface: a grain is wet by the share of it that is in the fluid.

use super::Placing;
use super::spread::{Spread, Spreading};
use super::wetted::{ball_volume, cut_off};
use crate::element::simplex::{Vector, barycentric};
use crate::mesh::Mesh;
use crate::mesh::locate::Locator;
use crate::parallel::NODES;
use crate::void_fraction::{Grain, VoidFractionError, Weights};
use rayon::prelude::*;

/// The group of boundary faces that are the free surface; all others are walls.
pub const FREE_SURFACE: u32 = 0;

/// Search and spreading in a mesh that is replaced and moved.
pub struct FreeSurface<const D: usize> {
    locator: Locator<D>,
    spreading: Spreading,
    spread: Spread<D>,
    hosts: Vec<Option<u32>>,
    immersions: Vec<Option<Immersion>>,
}

/// How a wet grain is in the fluid.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Immersion {
    /// Share of its volume.
    wetted: f64,
    /// Mesh size at the nearest place of the fluid (m).
    size: f64,
}

/// A boundary face near a grain.
#[derive(Debug, Clone, Copy)]
struct Near<const D: usize> {
    distance: f64,
    face: u32,
    place: Vector<D>,
    is_surface: bool,
}

impl<const D: usize> FreeSurface<D> {
    /// For a mesh as it is now.
    pub fn new<const N: usize>(mesh: &Mesh<D, N>, spreading: Spreading) -> Self {
        Self {
            locator: Locator::new(mesh),
            spreading,
            spread: Spread::new(spreading, mesh),
            hosts: Vec::new(),
            immersions: Vec::new(),
        }
    }

    /// Follows a mesh that has moved or has other cells.
    pub fn follow<const N: usize>(&mut self, mesh: &Mesh<D, N>) {
        self.locator = Locator::new(mesh);
        self.spread = Spread::new(self.spreading, mesh);
    }

    /// Where points are.
    pub fn locator(&self) -> &Locator<D> {
        &self.locator
    }

    /// How a grain is in the fluid; none if it is dry.
    ///
    /// What the surface leaves of it. A centre outside all cells that is nearer to a wall than to the surface is behind a coarse
    /// wall, and in the fluid.
    fn immersion<const N: usize>(
        &self,
        mesh: &Mesh<D, N>,
        grain: &Grain<D>,
        host: &mut Option<u32>,
    ) -> Option<Immersion> {
        let (x, radius) = (&grain.position, 0.5 * grain.diameter);
        let (mut near, mut facets): (Option<Near<D>>, _) = (None, Vec::new());
        self.locator.for_each_face_within(mesh, x, radius, |face, distance, place| {
            let is_surface = mesh.boundary()[face as usize].group == FREE_SURFACE;
            if is_surface {
                facets.push(face);
            }
            let key = |near: &Near<D>| (near.distance, !near.is_surface, near.face);
            let found = Near { distance, face, place, is_surface };
            if near.is_none_or(|near| key(&found) < key(&near)) {
                near = Some(found);
            }
        });
        facets.sort_unstable();
        facets.dedup();
        let within = self.locator.host(mesh, x, *host);
        *host = within.map(|(cell, _)| cell);
        let size = match (within, near) {
            (Some((cell, coordinates)), _) => mesh.interpolate(mesh.size(), cell as usize, &coordinates),
            (None, Some(near)) => size_at(mesh, &near),
            (None, None) => return None,
        };
        let inside = within.is_some() || near.is_some_and(|near| !near.is_surface);
        let corners = |face: u32| mesh.face_vertices(&mesh.boundary()[face as usize]);
        let taken: f64 = facets.iter().map(|&face| cut_off(x, radius, &corners(face), inside)).sum();
        let wetted = (f64::from(u8::from(inside)) - taken / ball_volume::<D>(radius)).clamp(0.0, 1.0);
        (wetted > 0.0).then_some(Immersion { wetted, size })
    }
}

/// Mesh size at the place of a boundary face (m).
fn size_at<const D: usize, const N: usize>(mesh: &Mesh<D, N>, near: &Near<D>) -> f64 {
    let cell = mesh.boundary()[near.face as usize].cell as usize;
    let coordinates = barycentric(&mesh.gradients()[cell], &mesh.vertices(cell), &near.place);
    mesh.interpolate(mesh.size(), cell, &coordinates)
}

impl<const D: usize, const N: usize> Placing<D, N> for FreeSurface<D> {
    fn place(
        &mut self,
        mesh: &Mesh<D, N>,
        grains: &[Grain<D>],
        weights: &mut Weights,
        wetted: &mut Vec<f64>,
    ) -> Result<(), VoidFractionError> {
        let finite = |grain: &Grain<D>| grain.position.iter().all(|x| x.is_finite());
        if let Some(grain) = grains.iter().position(|grain| !finite(grain)) {
            let position = grains[grain].position.to_vec();
            return Err(VoidFractionError::Position { grain, position });
        }
        let mut hosts = std::mem::take(&mut self.hosts);
        hosts.resize(grains.len(), None);
        let mut immersions = std::mem::take(&mut self.immersions);
        immersions.resize(grains.len(), None);
        let work = immersions.par_iter_mut().zip(&mut hosts).zip(grains).with_min_len(NODES);
        work.for_each(|((immersion, host), grain)| *immersion = self.immersion(mesh, grain, host));
        let size = |grain: usize| immersions[grain].map(|immersion| immersion.size);
        self.spread.weigh(grains, size, weights);
        wetted.clear();
        wetted.extend(immersions.iter().map(|immersion| immersion.map_or(0.0, |i| i.wetted)));
        (self.hosts, self.immersions) = (hosts, immersions);
        Ok(())
    }
}
