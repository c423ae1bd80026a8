//! The clumps of a world at work.

use rayon::prelude::*;

use crate::body::{Bodies, Carried, Load, Rigid};
use crate::engine::{Fastest, Periods, Speeds};
use crate::grains::{Grains, Motion};
use crate::lanes::{Backend, Row8};
use crate::vector::Spin;

/// Clumps that one task moves.
const TEAM: usize = 256;

/// A row that is no member.
const LOOSE: u32 = u32::MAX;

/// The members of all clumps, clump by clump, tied to the rows of a window; with the scratch of their steps.
#[derive(Clone, Debug, Default)]
pub struct Members {
    /// Row of each member.
    rows: Vec<u32>,
    /// Member in each row.
    of_row: Vec<u32>,
    /// Loads by row, while clumps gather them; empty without clumps.
    pub loads: Vec<Row8>,
    /// Where the members are carried.
    carried: Vec<Carried>,
    /// Their mean velocities in the last flight.
    flown: Vec<Row8>,
}

/// A flight of clumps, after a kick if there is one.
pub struct Flight<'a> {
    /// The lanes.
    pub backend: Backend,
    /// Periodic axes.
    pub periods: &'a Periods,
    /// Velocity that speeds are measured against \[m/s\].
    pub frame: [f64; 3],
    /// Acceleration of gravity \[m/s²\], and the time of the kick that it and the loads give \[s\].
    pub kick: Option<(Spin, f64)>,
    /// Time of the flight \[s\].
    pub time: f64,
}

impl Members {
    /// Ties the members to their rows.
    pub fn tie(bodies: &Bodies, grains: &Grains) -> Self {
        if bodies.is_empty() {
            return Self::default();
        }
        let mut firsts = vec![0];
        for clump in bodies.as_slice() {
            firsts.push(firsts[firsts.len() - 1] + clump.count());
        }
        let count = firsts[bodies.as_slice().len()];
        let mut rows = vec![LOOSE; count];
        let mut of_row = vec![LOOSE; grains.len()];
        for (row, &id) in grains.id.iter().enumerate() {
            if let Some((clump, member)) = bodies.of(id) {
                rows[firsts[clump] + member] = row as u32;
                of_row[row] = (firsts[clump] + member) as u32;
            }
        }
        let still =
            Carried { centre: Spin::zeros(), velocity: Spin::zeros(), angular_velocity: Spin::zeros() };
        Self {
            rows,
            of_row,
            loads: vec![Row8::default(); grains.len()],
            carried: vec![still; count],
            flown: vec![Row8::default(); count],
        }
    }

    /// Each clump with the rows of its members.
    pub fn of_each<'a>(&'a self, bodies: &'a Bodies) -> impl Iterator<Item = (&'a Rigid, &'a [u32])> {
        let mut rest = self.rows.as_slice();
        bodies.as_slice().iter().map(move |clump| {
            let (rows, later) = rest.split_at(clump.count());
            rest = later;
            (clump, rows)
        })
    }

    /// Pairs of rows of one clump, the lower first: they have no contact.
    pub fn pairs(&self, bodies: &Bodies) -> Vec<[u32; 2]> {
        let all = |(_, rows): (&Rigid, &[u32])| -> Vec<[u32; 2]> {
            let later =
                |k: usize| rows[k + 1..].iter().map(move |&other| [rows[k].min(other), rows[k].max(other)]);
            (0..rows.len()).flat_map(later).collect()
        };
        self.of_each(bodies).flat_map(all).collect()
    }
}

impl Flight<'_> {
    /// Kicks and flies the clumps and carries their members along; tells how fast members flew.
    ///
    /// Places of members, which wrap, stay the nearest images of where their clump has them.
    pub fn fly(&self, bodies: &mut Bodies, grains: &mut Grains, members: &mut Members) -> Fastest {
        if bodies.is_empty() {
            return Fastest::none();
        }
        let Members { rows, of_row, loads, carried, flown } = members;
        let (mut rows, mut flown, mut carried_on) =
            (rows.as_slice(), flown.as_mut_slice(), carried.as_mut_slice());
        let mut teams = Vec::with_capacity(bodies.as_slice().len() / TEAM + 1);
        for clumps in bodies.as_mut_slice().chunks_mut(TEAM) {
            let count = clumps.iter().map(Rigid::count).sum();
            let (mine, later) = rows.split_at(count);
            let (to, later_carried) = std::mem::take(&mut carried_on).split_at_mut(count);
            let (speeds, later_flown) = std::mem::take(&mut flown).split_at_mut(count);
            (rows, carried_on, flown) = (later, later_carried, later_flown);
            teams.push(Team { clumps, rows: mine, carried: to, flown: speeds });
        }
        let loads = loads.as_slice();
        let fastest = teams
            .into_par_iter()
            .map(|team| self.of_team(team, loads))
            .reduce(Fastest::none, |a, b| a.joined(&b));
        let carried = carried.as_slice();
        let Grains { place, motion, mass, .. } = grains;
        let rows = place.par_iter_mut().zip(motion).zip(&*mass).zip(&*of_row).with_min_len(TEAM);
        rows.for_each(|(((place, motion), &mass), &member)| {
            if let Some(carried) = carried.get(member as usize) {
                place.centre = self.periods.image_near(&carried.centre, &place.centre);
                *motion = Motion::carried(carried, mass);
            }
        });
        fastest
    }

    fn of_team(&self, team: Team, loads: &[Row8]) -> Fastest {
        let Team { clumps, mut rows, carried, flown } = team;
        let mut all = carried.iter_mut().zip(flown.iter_mut());
        for Rigid { shape, body, .. } in clumps {
            let (mine, later) = rows.split_at(shape.members().len());
            rows = later;
            if let Some((gravity, step)) = self.kick {
                let load = body.gather(shape, mine.iter().map(|&row| load(&loads[row as usize])));
                body.kick(shape, &load, step);
                body.velocity += gravity * step;
            }
            let before = *body;
            body.drift(shape, self.time);
            let after = body.members(shape);
            for ((old, new), (carried, flown)) in before.members(shape).zip(after).zip(&mut all) {
                let Spin { data, .. } = (new.centre - old.centre) / self.time;
                let [x, y, z] = data.0[0];
                *flown = Row8([x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0]);
                *carried = new;
            }
        }
        self.backend.run(Speeds { motions: flown, frame: self.frame })
    }
}

/// Clumps that one task moves, and what it writes of their members.
struct Team<'a> {
    clumps: &'a mut [Rigid],
    rows: &'a [u32],
    carried: &'a mut [Carried],
    flown: &'a mut [Row8],
}

fn load(&Row8([fx, fy, fz, _, tx, ty, tz, _]): &Row8) -> Load {
    Load { force: Spin::new(fx, fy, fz), torque: Spin::new(tx, ty, tz) }
}
