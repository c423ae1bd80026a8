//! The forces of one bond.

use super::bonds::Bond;
use super::carry::{Carry, across};
use super::turn::Turn;
use super::{Beam, Failure, Law, Resultants};
use crate::vector::Vector;

/// How the two grains of a bond moved since it was last pulled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// From the first centre to the second, now \[m\].
    pub separation: Vector<3>,
    /// Rotation vectors of the two grains, ω Δt \[rad\].
    pub turns: [Vector<3>; 2],
    /// Δt > 0 \[s\].
    pub time: f64,
}

/// Force on the first grain, its opposite on the second, and the torque on either.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Action {
    /// Force on the first grain \[N\].
    pub force: Vector<3>,
    /// Torques on the first and on the second about their centres \[N m\].
    pub torques: [Vector<3>; 2],
}

impl Action {
    /// That of a broken bond.
    pub fn none() -> Self {
        Self { force: Vector::zeros(), torques: [Vector::zeros(); 2] }
    }
}

impl Bond {
    /// Moves the bond, and pulls the grains; or finds it broken, and leaves it without load.
    ///
    /// With n, n' the directions of the bond before and now, d its length, R_i, R_j the rotations of its grains and
    /// s_i, s_j its shares of the distance, the first end moves against the second by
    ///
    /// Δu_s = d (1 - n'n'ᵀ)(s_i R_i n + s_j R_j n),  Δθ = θ_i - θ_j,
    ///
    /// both exactly zero in a rigid motion. The shear force and the moments are carried along and then change by -k Δu_s
    /// and -k Δθ. The elastic part alone is held against the strength.
    ///
    /// # Errors
    /// How the bond broke.
    pub fn pull(&mut self, law: &dyn Law, beam: &Beam, moved: &Moved) -> Result<Action, Failure> {
        let (length_before, length) = (self.separation.norm(), moved.separation.norm());
        let (before, direction) = (self.separation / length_before, moved.separation / length);
        let carry = Carry::new(&before, &direction, &moved.turns);
        let [share_i, share_j] = beam.shares;
        let [lean_i, lean_j] = moved.turns.map(|turn| Turn::new(turn).apply(&before));
        let lean = lean_i * share_i + lean_j * share_j;
        let slip = across(&lean, &direction) * length;
        let turn = moved.turns[0] - moved.turns[1];
        let bend = across(&turn, &direction);
        let twist = turn - bend;

        let k = &beam.stiffness;
        self.separation = moved.separation;
        self.shear = across(&(carry.apply(&self.shear) - slip * k.shear), &direction);
        self.moment = carry.apply(&self.moment) - bend * k.bending - twist * k.twisting;
        let load = self.along(&direction, length, beam);
        if let Some(failure) = law.failure(&beam.section, &load) {
            self.shear = Vector::zeros();
            self.moment = Vector::zeros();
            return Err(failure);
        }

        let c = &beam.damping;
        let tension = load.tension + c.normal * (length - length_before) / moved.time;
        let force = direction * tension + self.shear - slip * (c.shear / moved.time);
        let moment = self.moment - (bend * c.bending + twist * c.twisting) / moved.time;
        let lever = moved.separation.cross(&force);
        Ok(Action { force, torques: [lever * share_i + moment, lever * share_j - moment] })
    }

    /// What the springs of the bond carry.
    pub fn resultants(&self, beam: &Beam) -> Resultants {
        let length = self.separation.norm();
        self.along(&(self.separation / length), length, beam)
    }

    /// What they carry in this direction, at this length \[m\].
    fn along(&self, direction: &Vector<3>, length: f64, beam: &Beam) -> Resultants {
        Resultants {
            tension: beam.stiffness.normal * (length - beam.length),
            shear: self.shear.norm(),
            bending: across(&self.moment, direction).norm(),
            twisting: self.moment.dot(direction).abs(),
        }
    }

    /// Energy in its springs, Σ F²/(2 k) \[J\].
    pub fn stored_energy(&self, beam: &Beam) -> f64 {
        let load = self.resultants(beam);
        let k = &beam.stiffness;
        [
            (load.tension, k.normal),
            (load.shear, k.shear),
            (load.bending, k.bending),
            (load.twisting, k.twisting),
        ]
        .into_iter()
        .filter(|&(_, stiffness)| stiffness > 0.0)
        .map(|(force, stiffness)| 0.5 * force * force / stiffness)
        .sum()
    }
}
