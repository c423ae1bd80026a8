//! Bonds as arrays, for a checkpoint, and back.

use super::bonds::{Bond, Bonds, Broken};
use super::{BondError, Failure};
use crate::vector::Vector;

/// Numbers of a bond: length without tension, separation, shear force, moment.
const WIDTH: usize = 10;

/// All of [`Bonds`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BondArrays {
    /// Time since they were last pulled \[s\].
    pub elapsed: f64,
    /// Those that are no more: torn, sheared, orphaned.
    pub broken: [u64; 3],
    /// Identities of the grains, two each.
    pub grains: Vec<u64>,
    /// Laws.
    pub laws: Vec<u32>,
    /// Numbers, [`WIDTH`] each.
    pub numbers: Vec<f64>,
    /// How each broke: 0 it holds, 1 torn, 2 sheared.
    pub failures: Vec<u8>,
}

impl BondArrays {
    /// Those of these bonds.
    pub fn of(bonds: &Bonds) -> Self {
        let Broken { tension, shear, orphaned } = bonds.broken;
        let numbers = |bond: &Bond| {
            let vectors = [bond.separation, bond.shear, bond.moment];
            std::iter::once(bond.rest_length).chain(vectors.into_iter().flat_map(<[f64; 3]>::from))
        };
        let failure = |bond: &Bond| match bond.failure {
            None => 0,
            Some(Failure::Tension) => 1,
            Some(Failure::Shear) => 2,
        };
        Self {
            elapsed: bonds.elapsed,
            broken: [tension, shear, orphaned],
            grains: bonds.iter().flat_map(|bond| bond.grains).collect(),
            laws: bonds.iter().map(|bond| bond.law).collect(),
            numbers: bonds.iter().flat_map(numbers).collect(),
            failures: bonds.iter().map(failure).collect(),
        }
    }

    /// The bonds; nothing if the arrays do not fit each other.
    ///
    /// # Errors
    /// Those of [`Bonds::new`].
    pub fn restore(self) -> Result<Option<Bonds>, BondError> {
        let Self { elapsed, broken: [tension, shear, orphaned], grains, laws, numbers, failures } = self;
        let lengths = [grains.len() / 2, numbers.len() / WIDTH, failures.len()];
        if lengths.iter().any(|&length| length != laws.len()) {
            return Ok(None);
        }
        let vector = |numbers: &[f64]| Vector::from([numbers[0], numbers[1], numbers[2]]);
        let rows = grains.chunks_exact(2).zip(laws).zip(numbers.chunks_exact(WIDTH).zip(failures));
        let bonds = rows.map(|((grains, law), (numbers, failure))| Bond {
            grains: [grains[0], grains[1]],
            law,
            rest_length: numbers[0],
            separation: vector(&numbers[1..]),
            shear: vector(&numbers[4..]),
            moment: vector(&numbers[7..]),
            failure: match failure {
                0 => None,
                1 => Some(Failure::Tension),
                _ => Some(Failure::Shear),
            },
        });
        let broken = Broken { tension, shear, orphaned };
        Ok(Some(Bonds { elapsed, broken, ..Bonds::new(bonds.collect())? }))
    }
}
