//! Attraction of bodies that touch or have touched.

mod capillary;
mod dmt;
mod jkr;
mod sjkr;
mod sjkr2;

use crate::lanes::Lanes;
use crate::material::PairMaterial;

pub use capillary::Capillary;
pub use dmt::Dmt;
pub use jkr::Jkr;
pub use sjkr::Sjkr;
pub use sjkr2::Sjkr2;

/// Two bodies that touch or nearly do.
#[derive(Clone, Copy, Debug)]
pub struct Proximity<L> {
    /// What they are.
    pub bodies: Bodies<L>,
    /// Distance of the centres, or of the centre from the wall \[m\].
    pub distance: L,
    /// Overlap δ \[m\] in the middle of the step; below 0 the gap is -δ.
    pub overlap: L,
    /// How much nearer they come in the step \[m\].
    pub travel: L,
}

/// Two bodies and their radii \[m\].
#[derive(Clone, Copy, Debug)]
pub enum Bodies<L> {
    /// Two spheres.
    Spheres(L, L),
    /// A sphere and a wall.
    SphereAndWall(L),
}

/// What stays constant in the attraction of two bodies as long as they do; each law says what it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CohesionConstants<L = f64> {
    /// What the attraction is proportional to.
    pub strength: L,
    /// The length that overlap and gap are measured by \[m\].
    pub length: L,
    /// Largest gap over which bodies that have touched attract each other \[m\].
    pub reach: L,
}

/// A law of attraction.
pub trait Cohesion {
    /// Whether bodies that have touched attract each other beyond touch, and so must remember it.
    const REMEMBERS: bool;

    /// The constants of two bodies of this effective radius R* and this smaller radius \[m\].
    fn constants(pair: &PairMaterial, effective_radius: f64, smaller_radius: f64) -> CohesionConstants;

    /// The overlap at which the normal law without attraction has the same area of contact \[m\]; not positive where
    /// the bodies are apart and something between them attracts. Unless a law says otherwise δ.
    #[inline(always)]
    fn indentation<L: Lanes>(_constants: &CohesionConstants<L>, overlap: L) -> L {
        overlap
    }

    /// Attraction A of bodies that touch or, where the law remembers, have touched and are within its reach \[N\]: the
    /// normal force is that of the normal law at the indentation, F_p, less A.
    fn attraction<L: Lanes>(constants: &CohesionConstants<L>, proximity: &Proximity<L>) -> L;

    /// Net pull A - F_p that sets in where bodies begin to touch, and that ends where they are torn apart \[N\].
    fn jumps<L: Lanes>(constants: &CohesionConstants<L>) -> [L; 2];

    /// The part f of the attraction that friction and resistance to rolling feel \[N\]: they follow |F_p - f|.
    fn felt<L: Lanes>(constants: &CohesionConstants<L>, attraction: L) -> L;
}

/// The laws of attraction that a case can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CohesionLaw {
    /// `"sjkr"`: [`Sjkr`].
    Sjkr,
    /// `"sjkr2"`: [`Sjkr2`].
    Sjkr2,
    /// `"dmt"`: [`Dmt`].
    Dmt,
    /// `"jkr"`: [`Jkr`].
    Jkr,
    /// `"capillary"`: [`Capillary`].
    Capillary,
}

/// How two bodies hold together.
#[derive(Clone, Copy, Debug)]
pub struct Hold<L: Lanes> {
    /// Where they are in contact, so that they push, rub and resist.
    pub contact: L::Mask,
    /// See [`Cohesion::indentation`]; 0 where there is no contact.
    pub indentation: L,
    /// See [`Cohesion::attraction`]; 0 where nothing holds them.
    pub attraction: L,
    /// See [`Cohesion::felt`].
    pub felt: L,
}

impl<L: Lanes> Hold<L> {
    /// Bodies that touch or not, and nothing that attracts them.
    #[inline(always)]
    pub fn none(overlap: L, touching: L::Mask) -> Self {
        let zero = L::splat(0.0);
        Self { contact: touching, indentation: overlap.only(touching), attraction: zero, felt: zero }
    }
}

impl CohesionLaw {
    /// Whether contacts remember that they were made.
    pub fn remembers(self) -> bool {
        match self {
            Self::Sjkr => Sjkr::REMEMBERS,
            Self::Sjkr2 => Sjkr2::REMEMBERS,
            Self::Dmt => Dmt::REMEMBERS,
            Self::Jkr => Jkr::REMEMBERS,
            Self::Capillary => Capillary::REMEMBERS,
        }
    }

    /// The constants of two bodies of this effective and this smaller radius \[m\].
    pub fn constants(self, pair: &PairMaterial, effective: f64, smaller: f64) -> CohesionConstants {
        match self {
            Self::Sjkr => Sjkr::constants(pair, effective, smaller),
            Self::Sjkr2 => Sjkr2::constants(pair, effective, smaller),
            Self::Dmt => Dmt::constants(pair, effective, smaller),
            Self::Jkr => Jkr::constants(pair, effective, smaller),
            Self::Capillary => Capillary::constants(pair, effective, smaller),
        }
    }

    /// See [`Cohesion::indentation`].
    pub fn indentation(self, constants: &CohesionConstants, overlap: f64) -> f64 {
        match self {
            Self::Sjkr => Sjkr::indentation(constants, overlap),
            Self::Sjkr2 => Sjkr2::indentation(constants, overlap),
            Self::Dmt => Dmt::indentation(constants, overlap),
            Self::Jkr => Jkr::indentation(constants, overlap),
            Self::Capillary => Capillary::indentation(constants, overlap),
        }
    }

    /// How two bodies hold together that touch or not; `bridge` is 1 where the law remembers that they did in the last step,
    /// else 0, and afterwards whether it remembers that they do now.
    #[inline(always)]
    pub fn hold<L: Lanes>(
        self,
        constants: &CohesionConstants<L>,
        proximity: &Proximity<L>,
        touching: L::Mask,
        bridge: &mut L,
    ) -> Hold<L> {
        match self {
            Self::Sjkr => hold::<Sjkr, L>(constants, proximity, touching, bridge),
            Self::Sjkr2 => hold::<Sjkr2, L>(constants, proximity, touching, bridge),
            Self::Dmt => hold::<Dmt, L>(constants, proximity, touching, bridge),
            Self::Jkr => hold::<Jkr, L>(constants, proximity, touching, bridge),
            Self::Capillary => hold::<Capillary, L>(constants, proximity, touching, bridge),
        }
    }
}

#[inline(always)]
fn hold<C: Cohesion, L: Lanes>(
    constants: &CohesionConstants<L>,
    proximity: &Proximity<L>,
    touching: L::Mask,
    bridge: &mut L,
) -> Hold<L> {
    let (zero, gap) = (L::splat(0.0), -proximity.overlap);
    let first = bridge.less(L::splat(0.5));
    let holds = L::select(touching, L::splat(1.0), bridge.only(gap.less(constants.reach)));
    if C::REMEMBERS {
        *bridge = holds;
    }
    let held = zero.less(holds);
    let proximity = Proximity { overlap: proximity.overlap.only(held), ..*proximity };
    let indentation = C::indentation(constants, proximity.overlap);
    let contact = L::both(held, zero.less(indentation));
    let attraction = C::attraction(constants, &proximity);
    let felt = C::felt(constants, attraction).only(held);
    let attraction = (attraction + onset::<C, L>(constants, &proximity, first)).only(held);
    Hold { contact, indentation: indentation.only(contact), attraction, felt }
}

/// What is to be added to the attraction of a whole step where the pull lasts for a part f of it, or for more \[N\].
///
/// Bodies that are d deep in the range of a pull J in the middle of a step h, and move by v h > d, entered it since the middle
/// of the last step, or leave it before the middle of the next one: the pull lasts for f h in all, f = 1/2 + d/(v h). Then
/// a pull that sets in or ends at once makes no energy and takes none, wherever in a step it does.
#[inline(always)]
fn onset<C: Cohesion, L: Lanes>(
    constants: &CohesionConstants<L>,
    proximity: &Proximity<L>,
    first: L::Mask,
) -> L {
    let Proximity { overlap, travel, .. } = *proximity;
    let (approach, way) = (L::splat(0.0).less(travel), travel.max(-travel));
    let depth = L::select(approach, L::select(first, overlap, way), overlap + constants.reach);
    let partly = depth.less(way);
    let [begun, torn] = C::jumps(constants);
    let part = depth / L::select(partly, way, L::splat(1.0)) - L::splat(0.5);
    (L::select(approach, begun, torn) * part).only(partly)
}

/// The length, or 1 where it is 0, so that no lane divides 0 by 0.
#[inline(always)]
fn divisor<L: Lanes>(length: L) -> L {
    L::select(L::splat(0.0).less(length), length, L::splat(1.0))
}
