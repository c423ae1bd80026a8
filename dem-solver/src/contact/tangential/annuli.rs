//! What a contact that slips in part remembers of its annuli.

use crate::lanes::{Lanes, Vec3};

/// Annuli that a contact has at most; at least half of them are in contact.
pub const ANNULI: usize = 8;

/// Forces in concentric annuli of a contact; all zero before the first touch.
///
/// They are as wide as each other and stay where they are while the contact grows and shrinks: annulus k reaches from
/// a = k/8 to (k + 1)/8 of the radius at which all are in contact. Radii are told by the tangential stiffness, which is
/// proportional to them, k_t = 8 G* a.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Annuli<L = f64> {
    /// What each of them bears, from the middle outwards, as the first body feels it \[N\].
    pub force: [Vec3<L>; ANNULI],
    /// Tangential stiffness of a contact that covers all of them \[N/m\].
    pub full_stiffness: L,
    /// Unit normal of the contact when they were last loaded.
    pub normal: Vec3<L>,
}

impl<L: Lanes> Annuli<L> {
    /// Those of two bodies that do not touch.
    #[inline(always)]
    pub fn relaxed() -> Self {
        Self { force: [Vec3::zero(); ANNULI], full_stiffness: L::splat(0.0), normal: Vec3::zero() }
    }

    /// The annuli where the mask holds, else relaxed ones.
    #[inline(always)]
    pub fn only(self, mask: L::Mask) -> Self {
        let mut force = self.force;
        for force in &mut force {
            *force = force.only(mask);
        }
        Self { force, full_stiffness: self.full_stiffness.only(mask), normal: self.normal.only(mask) }
    }

    /// Turns forces in the last plane of contact into that of the unit normal b, as the rotation that brings the last
    /// normal a to b: F - (a + b) (b·F)/(1 + a·b).
    #[inline(always)]
    pub fn turn(&mut self, normal: Vec3<L>) {
        let one = L::splat(1.0);
        // A contact does not turn by more than a right angle in a step; the first has no normal to turn from.
        let between = (self.normal + normal) * (one / (one + self.normal.dot(normal)).max(one));
        for force in &mut self.force {
            *force = *force - between * normal.dot(*force);
        }
        self.normal = normal;
    }

    /// Makes the annuli twice as wide or half as wide until more than half of them, and no more than all, are in
    /// contact at the tangential stiffness k_t. Two that become one bear what both bore: no energy is made, since
    /// (F₁ + F₂)²/(k₁ + k₂) ≤ F₁²/k₁ + F₂²/k₂.
    #[inline(always)]
    pub fn fit(&mut self, stiffness: L) {
        let (zero, half, two) = (L::splat(0.0), L::splat(0.5), L::splat(2.0));
        let loaded = zero.less(self.full_stiffness);
        self.full_stiffness = L::select(loaded, self.full_stiffness, stiffness);
        loop {
            let small = self.full_stiffness.less(stiffness);
            if !L::any(small) {
                break;
            }
            for k in 0..ANNULI {
                let both =
                    if 2 * k < ANNULI { self.force[2 * k] + self.force[2 * k + 1] } else { Vec3::zero() };
                self.force[k] = Vec3::select(small, both, self.force[k]);
            }
            self.full_stiffness = L::select(small, self.full_stiffness * two, self.full_stiffness);
        }
        let touching = zero.less(stiffness);
        loop {
            let large = L::both(touching, stiffness.less(self.full_stiffness * half));
            if !L::any(large) {
                break;
            }
            for k in (0..ANNULI).rev() {
                self.force[k] = Vec3::select(large, self.force[k / 2] * half, self.force[k]);
            }
            self.full_stiffness = L::select(large, self.full_stiffness * half, self.full_stiffness);
        }
    }

    #[inline(always)]
    fn edge(&self, annulus: usize) -> L {
        self.full_stiffness * L::splat(annulus as f64 / ANNULI as f64)
    }

    /// The tangential stiffness up to the inner and outer edge of an annulus, in a contact of stiffness k_t \[N/m\].
    #[inline(always)]
    pub fn edges(&self, annulus: usize, stiffness: L) -> (L, L) {
        (self.edge(annulus).min(stiffness), self.edge(annulus + 1).min(stiffness))
    }
}

impl Annuli {
    /// The annuli as the second body sees them.
    pub fn reversed(self) -> Self {
        Self { force: self.force.map(|force| -force), normal: -self.normal, ..self }
    }

    /// Energy in a contact of tangential stiffness k_t, Σ F²/(2 k) \[J\].
    pub fn energy(&self, stiffness: f64) -> f64 {
        let of_annulus = |(k, force): (usize, &Vec3<f64>)| {
            let (inner, outer) = self.edges(k, stiffness);
            if inner < outer { 0.5 * force.norm_squared() / (outer - inner) } else { 0.0 }
        };
        self.force.iter().enumerate().map(of_annulus).sum()
    }
}
