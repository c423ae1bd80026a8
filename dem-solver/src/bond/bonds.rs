//! The bonds of a world.

use super::{BondError, Failure};
use crate::vector::Vector;

/// A bond, as it is between two steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bond {
    /// Identities of its grains.
    pub grains: [u64; 2],
    /// Which of the scene's laws it follows.
    pub law: u32,
    /// Distance of the centres without tension \[m\].
    pub rest_length: f64,
    /// From the first centre to the second when it was last pulled \[m\].
    pub separation: Vector<3>,
    /// Elastic shear force on the first grain \[N\].
    pub shear: Vector<3>,
    /// Elastic moment on the first grain: twisting along the bond, bending across it \[N m\].
    pub moment: Vector<3>,
    /// How it broke; nothing while it holds.
    pub failure: Option<Failure>,
}

impl Bond {
    /// A bond without load between two grains; `separation` goes from the first centre to the second \[m\].
    pub fn new(grains: [u64; 2], law: u32, separation: Vector<3>) -> Self {
        Self {
            grains,
            law,
            rest_length: separation.norm(),
            separation,
            shear: Vector::zeros(),
            moment: Vector::zeros(),
            failure: None,
        }
    }
}

/// How many bonds are no more, and why.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Broken {
    /// Torn apart.
    pub tension: u64,
    /// Sheared off.
    pub shear: u64,
    /// Gone with a grain that was removed.
    pub orphaned: u64,
}

/// All bonds, ascending in their grains.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bonds {
    pub(super) bonds: Vec<Bond>,
    /// Time since they were last pulled \[s\].
    pub(super) elapsed: f64,
    pub(super) broken: Broken,
}

impl Bonds {
    /// These bonds, none broken yet.
    ///
    /// # Errors
    /// A bond of a grain with itself; two bonds of one pair; grains whose centres coincide.
    pub fn new(mut bonds: Vec<Bond>) -> Result<Self, BondError> {
        for bond in &bonds {
            let [one, other] = bond.grains;
            if one == other {
                return Err(BondError::WithItself { grain: one });
            }
            if !(bond.rest_length > 0.0 && bond.rest_length.is_finite()) {
                return Err(BondError::NoLength { one, other, length: bond.rest_length });
            }
        }
        let pair = |bond: &Bond| {
            let [one, other] = bond.grains;
            [one.min(other), one.max(other)]
        };
        bonds.sort_by_key(pair);
        match bonds.windows(2).find(|two| pair(&two[0]) == pair(&two[1])) {
            Some(two) => Err(BondError::Twice { one: two[0].grains[0], other: two[0].grains[1] }),
            None => Ok(Self { bonds, elapsed: 0.0, broken: Broken::default() }),
        }
    }

    /// The bonds, broken ones included until they are swept.
    pub fn iter(&self) -> impl Iterator<Item = &Bond> {
        self.bonds.iter()
    }

    /// Their number.
    pub fn len(&self) -> usize {
        self.bonds.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.bonds.is_empty()
    }

    /// How many were swept.
    pub fn broken(&self) -> Broken {
        self.broken
    }

    /// The grains flew for `time` \[s\]; they must before bonds are pulled again.
    pub fn fly(&mut self, time: f64) {
        if !self.is_empty() {
            self.elapsed += time;
        }
    }

    /// Copies `other` into memory that is already here.
    pub fn copy_from(&mut self, other: &Self) {
        self.bonds.clone_from(&other.bonds);
        self.elapsed = other.elapsed;
        self.broken = other.broken;
    }

    /// Takes out the bonds that broke, and those of grains that are no more; counts and returns them.
    pub fn sweep(&mut self, exists: impl Fn(u64) -> bool) -> Vec<Bond> {
        let mut swept = vec![];
        self.bonds.retain(|bond| {
            let orphaned = !bond.grains.into_iter().all(&exists);
            match bond.failure {
                Some(Failure::Tension) => self.broken.tension += 1,
                Some(Failure::Shear) => self.broken.shear += 1,
                None if orphaned => self.broken.orphaned += 1,
                None => return true,
            }
            swept.push(*bond);
            false
        });
        swept
    }
}
