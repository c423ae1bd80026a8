//! Where a pair kernel finds radii and constants.

use super::block::ConstantsBlock;
use crate::contact::{Coefficients, ExtraConstants};
use crate::grains::{Grains, inertia};
use crate::lanes::Lanes;
use crate::scene::Scene;

/// Radii and constants of the pairs of a block.
pub trait PairConstants: Copy {
    /// Whether all grains have one radius.
    const ALIKE: bool;
    /// Radii of the pairs from this lane of this block on.
    fn radii<L: Lanes>(&self, block: usize, lane: usize) -> (L, L);
    /// Constants of the same.
    fn coefficients<L: Lanes>(&self, block: usize, lane: usize) -> Coefficients<L>;
}

/// All pairs alike: one radius, one material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alike {
    /// Radius of every grain \[m\].
    pub radius: f64,
    /// Constants of every pair.
    pub coefficients: Coefficients,
}

impl Alike {
    /// What all pairs share, if they do and there is nothing but normal and tangential force.
    pub fn of<const D: usize>(scene: &Scene<D>, grains: &Grains) -> Option<Self> {
        if scene.extras.any() {
            return None;
        }
        let (&material, &mass) = (grains.material.first()?, grains.mass.first()?);
        let radius = grains.place[0].radius;
        let same = (0..grains.len()).all(|row| {
            grains.place[row].radius == radius
                && grains.mass[row] == mass
                && grains.material[row] == material
                && grains.motion[row].is_loose()
        });
        let coefficients = scene.coefficients((material, material), 0.5 * radius, 0.5 * mass)?;
        same.then_some(Self { radius, coefficients })
    }
}

impl PairConstants for Alike {
    const ALIKE: bool = true;

    #[inline(always)]
    fn radii<L: Lanes>(&self, _: usize, _: usize) -> (L, L) {
        (L::splat(self.radius), L::splat(self.radius))
    }

    #[inline(always)]
    fn coefficients<L: Lanes>(&self, _: usize, _: usize) -> Coefficients<L> {
        self.coefficients.splat()
    }
}

impl PairConstants for &[ConstantsBlock] {
    const ALIKE: bool = false;

    #[inline(always)]
    fn radii<L: Lanes>(&self, block: usize, lane: usize) -> (L, L) {
        self[block].radii(lane)
    }

    #[inline(always)]
    fn coefficients<L: Lanes>(&self, block: usize, lane: usize) -> Coefficients<L> {
        self[block].coefficients(lane)
    }
}

/// Radii and constants of one pair of grains; nothing where nothing touches.
pub fn of_pair<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains,
    i: usize,
    j: usize,
) -> Option<((f64, f64), Coefficients)> {
    let (a, b) = (grains.place[i].radius, grains.place[j].radius);
    let mass = 1.0 / (grains.motion[i].inverse_mass + grains.motion[j].inverse_mass);
    let coefficients = scene.coefficients((grains.material[i], grains.material[j]), a * b / (a + b), mass)?;
    Some(((a, b), coefficients))
}

/// Constants of a pair's laws besides normal and tangential force; frozen grains count with their masses.
pub fn extras_of_pair<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains,
    (i, j): (usize, usize),
    coefficients: &Coefficients,
) -> ExtraConstants {
    let (a, b) = (grains.place[i].radius, grains.place[j].radius);
    let (one, other) =
        (inertia_about_contact::<D>(grains.mass[i], a), inertia_about_contact::<D>(grains.mass[j], b));
    let materials = (grains.material[i], grains.material[j]);
    scene.extra_constants(materials, coefficients, (a * b / (a + b), a.min(b)), one * other / (one + other))
}

/// The same of a grain and a wall of this material.
pub fn extras_on_wall<const D: usize>(
    scene: &Scene<D>,
    grains: &Grains,
    row: usize,
    wall: u32,
    coefficients: &Coefficients,
) -> ExtraConstants {
    let radius = grains.place[row].radius;
    let inertia = inertia_about_contact::<D>(grains.mass[row], radius);
    scene.extra_constants((grains.material[row], wall), coefficients, (radius, radius), inertia)
}

/// I + m r² \[kg m²\].
fn inertia_about_contact<const D: usize>(mass: f64, radius: f64) -> f64 {
    inertia::<D>(mass, radius) + mass * radius * radius
}
