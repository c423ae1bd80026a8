//! Bonds: pairs of grains glued together, which carry tension, shear, bending and twist until they break.
//!
//! A bond is a short beam. Its law says how stiff the beam is and what it bears; all else is the same for all laws:
//!
//! 1. [`Bond`] is the state of one beam, [`Beam`] its constants; [`Bond::pull`] moves the state and gives the forces.
//! 2. [`Bonds`] are all of a world, in the order of the grains they join; they break, and are counted.
//! 3. [`Links`] tie them to the rows of the grains: forces are found bond by bond, then gathered grain by grain, so
//!    that no sum depends on the number of threads.

mod archive;
mod beam;
mod bonds;
mod carry;
mod cohesive;
mod error;
mod links;
mod parallel_bond;
mod pull;
mod resistance;
mod section;
mod turn;

pub use archive::BondArrays;
pub use beam::{Beam, End, Rigidity};
pub use bonds::{Bond, Bonds, Broken};
pub use cohesive::Cohesive;
pub use error::BondError;
pub use links::{Links, Positions};
pub use parallel_bond::ParallelBond;
pub use pull::{Action, Moved};
pub use resistance::Resistance;
pub use section::{Profile, Section};

/// What a bond carries, as its strength sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resultants {
    /// Normal force, positive in tension \[N\].
    pub tension: f64,
    /// Size of the shear force \[N\].
    pub shear: f64,
    /// Size of the bending moment \[N m\].
    pub bending: f64,
    /// Size of the twisting moment \[N m\].
    pub twisting: f64,
}

/// How a bond broke.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// It was torn apart.
    Tension,
    /// It was sheared off.
    Shear,
}

/// A law of bonds.
pub trait Law {
    /// Whether the two grains have no contact of their own while they are bonded; else contact and bond act side by
    /// side.
    fn replaces_contact(&self) -> bool;

    /// Cross-section of a bond of grains of these radii \[m\].
    fn section(&self, radii: [f64; 2], profile: Profile) -> Section;

    /// Stiffness of a bond of this section and length \[m\].
    fn stiffness(&self, section: &Section, length: f64) -> Rigidity;

    /// Damping ratio ζ of each of the four motions of a lone bonded pair.
    fn damping_ratio(&self) -> f64;

    /// How a bond of this section breaks under this load; nothing while it holds.
    fn failure(&self, section: &Section, load: &Resultants) -> Option<Failure>;
}

/// The laws of bonds a case can name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BondLaw {
    /// `"parallel-bond"`: [`ParallelBond`].
    ParallelBond(ParallelBond),
    /// `"cohesive"`: [`Cohesive`].
    Cohesive(Cohesive),
}

impl BondLaw {
    /// The law itself.
    pub fn law(&self) -> &dyn Law {
        match self {
            Self::ParallelBond(law) => law,
            Self::Cohesive(law) => law,
        }
    }
}
