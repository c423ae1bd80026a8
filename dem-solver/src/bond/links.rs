//! Bonds tied to the rows of the grains.

use std::collections::HashMap;

use rayon::prelude::*;

use super::{Action, Beam, Bond, BondError, BondLaw, Bonds, End, Moved, Profile, Resistance};
use crate::fault::Fault;
use crate::vector::Vector;

/// Bonds worked on together.
const CHUNK: usize = 1024;

/// Centres nearer than this fraction of the rest length have no direction that a force could take.
const COINCIDENT: f64 = 1e-9;

/// Where grains are and how they spin, by row.
pub trait Positions: Sync {
    /// From the centre of row `i` to the nearest image of row `j` \[m\].
    fn separation(&self, i: usize, j: usize) -> Vector<3>;

    /// Angular velocity of a row \[rad/s\].
    fn angular_velocity(&self, row: usize) -> Vector<3>;
}

/// What bonds need of the rows as they stand; made anew when bonds are swept or rows reordered.
///
/// Each bond writes its own [`Action`], each grain adds up those of its own bonds in their order: the same bits from
/// any number of threads.
#[derive(Clone, Debug, Default)]
pub struct Links {
    /// Rows of the grains of each bond.
    rows: Vec<[u32; 2]>,
    beams: Vec<Beam>,
    actions: Vec<Action>,
    /// Where the ends of each row begin in `ends`; one more than there are rows.
    first: Vec<u32>,
    /// Ends of bonds by row: twice the bond, and one more for its second end.
    ends: Vec<u32>,
}

impl Links {
    /// Ties the bonds to grains of these identities; `end` tells of each row what bonds must know.
    ///
    /// # Errors
    /// A bond of a grain, or of a law, that is not there.
    pub fn new(
        laws: &[BondLaw],
        profile: Profile,
        bonds: &Bonds,
        identities: &[u64],
        end: impl Fn(usize) -> End,
    ) -> Result<Self, BondError> {
        let row_of: HashMap<u64, u32> = identities.iter().copied().zip(0..).collect();
        let mut links = Self::default();
        for bond in bonds.iter() {
            let [one, other] = bond.grains;
            let row = |missing: u64| {
                let grains = identities.len();
                row_of.get(&missing).copied().ok_or(BondError::MissingGrain { one, other, missing, grains })
            };
            let missing = BondError::MissingLaw { one, other, law: bond.law, laws: laws.len() };
            let law = laws.get(bond.law as usize).ok_or(missing)?.law();
            let rows = [row(one)?, row(other)?];
            links.beams.push(Beam::new(law, rows.map(|row| end(row as usize)), bond.rest_length, profile));
            links.rows.push(rows);
        }
        links.actions.resize(links.rows.len(), Action::none());
        links.gather_ends(identities.len());
        Ok(links)
    }

    /// Sorts the ends of bonds by row, those of one row by bond.
    fn gather_ends(&mut self, grains: usize) {
        let flat = || self.rows.iter().flatten().map(|&row| row as usize);
        self.first = vec![0; grains + 1];
        flat().for_each(|row| self.first[row + 1] += 1);
        (0..grains).for_each(|row| self.first[row + 1] += self.first[row]);
        let mut next = self.first.clone();
        self.ends = vec![0; 2 * self.rows.len()];
        for (end, row) in flat().enumerate() {
            self.ends[next[row] as usize] = end as u32;
            next[row] += 1;
        }
    }

    /// Pulls all bonds; returns how many broke.
    ///
    /// # Errors
    /// Two bonded grains whose centres coincide.
    pub fn pull(
        &mut self,
        laws: &[BondLaw],
        bonds: &mut Bonds,
        positions: &impl Positions,
    ) -> Result<usize, Fault> {
        let time = std::mem::take(&mut bonds.elapsed);
        let constants = self.rows.par_chunks(CHUNK).zip(self.beams.par_chunks(CHUNK));
        let state = bonds.bonds.par_chunks_mut(CHUNK).zip(self.actions.par_chunks_mut(CHUNK));
        let broke: Vec<Result<usize, Fault>> = constants
            .zip(state)
            .map(|((rows, beams), (bonds, actions))| {
                let mut broke = 0;
                for ((rows, beam), (bond, action)) in
                    rows.iter().zip(beams).zip(bonds.iter_mut().zip(actions))
                {
                    *action = Action::none();
                    if bond.failure.is_none() {
                        let moved = moved(bond, rows.map(|row| row as usize), positions, time)?;
                        match bond.pull(laws[bond.law as usize].law(), beam, &moved) {
                            Ok(pull) => *action = pull,
                            Err(failure) => bond.failure = Some(failure),
                        }
                        broke += usize::from(bond.failure.is_some());
                    }
                }
                Ok(broke)
            })
            .collect();
        broke.into_iter().sum()
    }

    /// Force \[N\] and torque \[N m\] of its bonds on a grain, as they were last pulled.
    pub fn load(&self, row: usize) -> (Vector<3>, Vector<3>) {
        let mut load = (Vector::zeros(), Vector::zeros());
        for &end in self.ends_of(row) {
            let Action { force, torques } = &self.actions[end as usize / 2];
            match end % 2 {
                0 => load.0 += force,
                _ => load.0 -= force,
            }
            load.1 += torques[end as usize % 2];
        }
        load
    }

    /// The rows that have bonds, ascending.
    pub fn bonded_rows(&self) -> impl Iterator<Item = usize> {
        self.first.windows(2).enumerate().filter(|(_, ends)| ends[0] < ends[1]).map(|(row, _)| row)
    }

    /// How hard its bonds resist the motion of a grain with this m/I \[1/m²\], all of them together.
    pub fn resistance(&self, row: usize, mass_over_inertia: f64) -> Resistance {
        let ends = self.ends_of(row).iter();
        ends.map(|&end| Resistance::of(&self.beams[end as usize / 2], end as usize % 2, mass_over_inertia))
            .sum()
    }

    /// Rows of the grains, the lower first and ascending, that have no contact of their own while they are bonded.
    pub fn without_contact(&self, laws: &[BondLaw], bonds: &Bonds) -> Vec<[u32; 2]> {
        let replaces =
            |bond: &Bond| bond.failure.is_none() && laws[bond.law as usize].law().replaces_contact();
        let apart = self.rows.iter().zip(bonds.iter()).filter(|(_, bond)| replaces(bond));
        let mut pairs: Vec<_> = apart.map(|(&[i, j], _)| [i.min(j), i.max(j)]).collect();
        pairs.sort_unstable();
        pairs
    }

    /// Rows of the grains of each bond.
    pub fn rows(&self) -> &[[u32; 2]] {
        &self.rows
    }

    /// The constants of the bonds, in their order.
    pub fn beams(&self) -> &[Beam] {
        &self.beams
    }

    fn ends_of(&self, row: usize) -> &[u32] {
        &self.ends[self.first[row] as usize..self.first[row + 1] as usize]
    }
}

/// How the grains of a bond moved in this time \[s\].
fn moved(bond: &Bond, [i, j]: [usize; 2], positions: &impl Positions, time: f64) -> Result<Moved, Fault> {
    let separation = positions.separation(i, j);
    if separation.norm() <= COINCIDENT * bond.rest_length {
        let [one, other] = bond.grains;
        return Err(Fault::Coincident { one, other });
    }
    Ok(Moved { separation, turns: [i, j].map(|row| positions.angular_velocity(row) * time), time })
}
