//! Eight contacts side by side.

use crate::contact::cohesion::CohesionConstants;
use crate::contact::rolling::RollingConstants;
use crate::contact::tangential::{ANNULI, Annuli};
use crate::contact::twisting::Twist;
use crate::contact::{Coefficients, ExtraConstants, Spring};
use crate::lanes::{Lanes, Vec3};

/// Contacts in a block.
pub const WIDTH: usize = 8;

/// Two grains each.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct PairBlock {
    /// Rows of the first grains.
    pub i: [u32; WIDTH],
    /// Rows of the second grains.
    pub j: [u32; WIDTH],
    /// Where the chunk adds up the loads on the first grains.
    pub slot_i: [u32; WIDTH],
    /// Where it adds up those on the second.
    pub slot_j: [u32; WIDTH],
}

/// A grain and a plane each.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct PlaneBlock {
    /// Rows of the grains.
    pub grain: [u32; WIDTH],
    /// Where the chunk adds up the loads on them.
    pub slot: [u32; WIDTH],
    /// The planes.
    pub plane: [u32; WIDTH],
}

/// What eight contacts remember.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub struct SpringBlock {
    force: [[f64; WIDTH]; 3],
    stiffness: [f64; WIDTH],
}

impl SpringBlock {
    /// The springs from this lane on; torques, bridges and twists are in blocks of their own.
    #[inline(always)]
    pub fn load<L: Lanes>(&self, lane: usize) -> Spring<L> {
        let [x, y, z] = &self.force;
        Spring {
            force: Vec3::load(&x[lane..], &y[lane..], &z[lane..]),
            stiffness: L::load(&self.stiffness[lane..]),
            ..Spring::relaxed()
        }
    }

    /// Stores springs from this lane on.
    #[inline(always)]
    pub fn store<L: Lanes>(&mut self, lane: usize, spring: &Spring<L>) {
        let [x, y, z] = &mut self.force;
        spring.force.x.store(&mut x[lane..]);
        spring.force.y.store(&mut y[lane..]);
        spring.force.z.store(&mut z[lane..]);
        spring.stiffness.store(&mut self.stiffness[lane..]);
    }

    /// Energy of all springs \[J\].
    pub fn energy(&self) -> f64 {
        (0..WIDTH).map(|lane| self.load::<f64>(lane).energy()).sum()
    }

    /// Forgets the springs from this lane on; most often there is nothing to forget.
    #[inline(always)]
    pub fn relax<L: Lanes>(&mut self, lane: usize) {
        if L::any(L::splat(0.0).less(L::load(&self.stiffness[lane..]))) {
            self.store(lane, &Spring::<L>::relaxed());
        }
    }
}

/// Radii and constants of eight contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub struct ConstantsBlock {
    radius_i: [f64; WIDTH],
    radius_j: [f64; WIDTH],
    coefficients: [[f64; WIDTH]; 6],
}

impl ConstantsBlock {
    /// Radii from this lane on.
    #[inline(always)]
    pub fn radii<L: Lanes>(&self, lane: usize) -> (L, L) {
        (L::load(&self.radius_i[lane..]), L::load(&self.radius_j[lane..]))
    }

    /// Constants from this lane on.
    #[inline(always)]
    pub fn coefficients<L: Lanes>(&self, lane: usize) -> Coefficients<L> {
        let [kn, cn, kt, ct, mu, inverse_mass] = &self.coefficients;
        Coefficients {
            normal_stiffness: L::load(&kn[lane..]),
            normal_damping: L::load(&cn[lane..]),
            tangential_stiffness: L::load(&kt[lane..]),
            tangential_damping: L::load(&ct[lane..]),
            sliding_friction: L::load(&mu[lane..]),
            inverse_mass: L::load(&inverse_mass[lane..]),
        }
    }

    /// Sets one contact.
    pub fn set(&mut self, lane: usize, radii: (f64, f64), coefficients: &Coefficients) {
        (self.radius_i[lane], self.radius_j[lane]) = radii;
        let Coefficients {
            normal_stiffness: kn,
            normal_damping: cn,
            tangential_stiffness: kt,
            tangential_damping: ct,
            sliding_friction: mu,
            inverse_mass,
        } = *coefficients;
        let all = [kn, cn, kt, ct, mu, inverse_mass];
        for (row, constant) in self.coefficients.iter_mut().zip(all) {
            row[lane] = constant;
        }
    }
}

/// What the springs against rolling of eight contacts hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub struct TorqueBlock([[f64; WIDTH]; 3]);

impl TorqueBlock {
    /// The torques from this lane on.
    #[inline(always)]
    pub fn load<L: Lanes>(&self, lane: usize) -> Vec3<L> {
        let [x, y, z] = &self.0;
        Vec3::load(&x[lane..], &y[lane..], &z[lane..])
    }

    /// Stores torques from this lane on.
    #[inline(always)]
    pub fn store<L: Lanes>(&mut self, lane: usize, torque: Vec3<L>) {
        let [x, y, z] = &mut self.0;
        torque.x.store(&mut x[lane..]);
        torque.y.store(&mut y[lane..]);
        torque.z.store(&mut z[lane..]);
    }
}

#[inline(always)]
fn load_vector<L: Lanes>([x, y, z]: &[[f64; WIDTH]; 3], lane: usize) -> Vec3<L> {
    Vec3::load(&x[lane..], &y[lane..], &z[lane..])
}

#[inline(always)]
fn store_vector<L: Lanes>([x, y, z]: &mut [[f64; WIDTH]; 3], lane: usize, vector: Vec3<L>) {
    vector.x.store(&mut x[lane..]);
    vector.y.store(&mut y[lane..]);
    vector.z.store(&mut z[lane..]);
}

/// What the annuli of eight contacts bear.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub struct AnnuliBlock {
    force: [[[f64; WIDTH]; 3]; ANNULI],
    full_stiffness: [f64; WIDTH],
    normal: [[f64; WIDTH]; 3],
}

impl AnnuliBlock {
    /// The annuli from this lane on.
    #[inline(always)]
    pub fn load<L: Lanes>(&self, lane: usize) -> Annuli<L> {
        let mut annuli = Annuli::relaxed();
        for (force, from) in annuli.force.iter_mut().zip(&self.force) {
            *force = load_vector(from, lane);
        }
        annuli.full_stiffness = L::load(&self.full_stiffness[lane..]);
        annuli.normal = load_vector(&self.normal, lane);
        annuli
    }

    /// Stores annuli from this lane on.
    #[inline(always)]
    pub fn store<L: Lanes>(&mut self, lane: usize, annuli: &Annuli<L>) {
        for (to, &force) in self.force.iter_mut().zip(&annuli.force) {
            store_vector(to, lane, force);
        }
        annuli.full_stiffness.store(&mut self.full_stiffness[lane..]);
        store_vector(&mut self.normal, lane, annuli.normal);
    }

    /// Forgets the annuli from this lane on; most often there is nothing to forget.
    #[inline(always)]
    pub fn relax<L: Lanes>(&mut self, lane: usize) {
        if L::any(L::splat(0.0).less(L::load(&self.full_stiffness[lane..]))) {
            self.store(lane, &Annuli::<L>::relaxed());
        }
    }
}

/// Whether something holds the bodies of eight contacts together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub struct BridgeBlock([f64; WIDTH]);

impl BridgeBlock {
    /// The bridges from this lane on.
    #[inline(always)]
    pub fn load<L: Lanes>(&self, lane: usize) -> L {
        L::load(&self.0[lane..])
    }

    /// Stores bridges from this lane on.
    #[inline(always)]
    pub fn store<L: Lanes>(&mut self, lane: usize, bridge: L) {
        bridge.store(&mut self.0[lane..]);
    }
}

/// What the springs against twisting of eight contacts hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub struct TwistBlock([[f64; WIDTH]; 2]);

impl TwistBlock {
    /// The twists from this lane on.
    #[inline(always)]
    pub fn load<L: Lanes>(&self, lane: usize) -> Twist<L> {
        let [torque, stiffness] = self.0.each_ref().map(|row| L::load(&row[lane..]));
        Twist { torque, stiffness }
    }

    /// Stores twists from this lane on.
    #[inline(always)]
    pub fn store<L: Lanes>(&mut self, lane: usize, twist: Twist<L>) {
        let [torque, stiffness] = &mut self.0;
        twist.torque.store(&mut torque[lane..]);
        twist.stiffness.store(&mut stiffness[lane..]);
    }
}

/// Constants of the laws besides normal and tangential force, of eight contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(64))]
pub struct ExtrasBlock([[f64; WIDTH]; 9]);

impl ExtrasBlock {
    /// Constants from this lane on.
    #[inline(always)]
    pub fn load<L: Lanes>(&self, lane: usize) -> ExtraConstants<L> {
        let [friction, rolled, stiffness, damping, strength, length, reach, lubrication, effective_radius] =
            self.0.each_ref().map(|row| L::load(&row[lane..]));
        let rolling = RollingConstants { friction, effective_radius: rolled, stiffness, damping };
        let cohesion = CohesionConstants { strength, length, reach };
        ExtraConstants { rolling, cohesion, lubrication, effective_radius }
    }

    /// Sets one contact.
    pub fn set(&mut self, lane: usize, constants: &ExtraConstants) {
        let ExtraConstants { rolling, cohesion, lubrication, effective_radius } = *constants;
        let RollingConstants { friction, effective_radius: rolled, stiffness, damping } = rolling;
        let CohesionConstants { strength, length, reach } = cohesion;
        let all =
            [friction, rolled, stiffness, damping, strength, length, reach, lubrication, effective_radius];
        for (row, constant) in self.0.iter_mut().zip(all) {
            row[lane] = constant;
        }
    }
}
