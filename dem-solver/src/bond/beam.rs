//! The constants of a bond.

use super::{Law, Profile, Section};

/// A number for each of the four motions of a bond's two ends against each other: stiffness, or damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigidity {
    /// Along the bond \[N/m\], \[N s/m\].
    pub normal: f64,
    /// Across it \[N/m\], \[N s/m\].
    pub shear: f64,
    /// Turning about axes across it \[N m\], \[N m s\].
    pub bending: f64,
    /// Turning about its own axis \[N m\], \[N m s\].
    pub twisting: f64,
}

/// A grain at an end of a bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Radius r \[m\].
    pub radius: f64,
    /// 1/m \[1/kg\]; 0 for a grain fixed in place.
    pub inverse_mass: f64,
    /// 1/I \[1/(kg m²)\]; 0 for a grain fixed in place.
    pub inverse_inertia: f64,
}

/// A bond as a beam: all of it that does not change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// Its cross-section.
    pub section: Section,
    /// Its springs.
    pub stiffness: Rigidity,
    /// Its dashpots, c = 2 ζ √(k m*), with m* the effective mass or inertia of the motion.
    pub damping: Rigidity,
    /// Where on the line of centres it acts, as shares of the distance from either end, r_i/(r_i + r_j); their sum is
    /// 1, so that no angular momentum is lost.
    pub shares: [f64; 2],
    /// Distance of the centres when the bond was made \[m\].
    pub length: f64,
}

impl Beam {
    /// The bond of two grains whose centres were `length` \[m\] apart when it was made.
    pub fn new(law: &dyn Law, ends: [End; 2], length: f64, profile: Profile) -> Self {
        let [i, j] = ends;
        let section = law.section([i.radius, j.radius], profile);
        let stiffness = law.stiffness(&section, length);
        let shares = [i, j].map(|end| end.radius / (i.radius + j.radius));
        let mobility = i.inverse_mass + j.inverse_mass;
        let turning = i.inverse_inertia + j.inverse_inertia;
        let lever = |end: End, share: f64| (share * length).powi(2) * end.inverse_inertia;
        let sliding = mobility + lever(i, shares[0]) + lever(j, shares[1]);
        // Two grains that are both fixed never move against each other.
        let damping = |k: f64, inverse: f64| {
            if inverse > 0.0 { 2.0 * law.damping_ratio() * (k / inverse).sqrt() } else { 0.0 }
        };
        let damping = Rigidity {
            normal: damping(stiffness.normal, mobility),
            shear: damping(stiffness.shear, sliding),
            bending: damping(stiffness.bending, turning),
            twisting: damping(stiffness.twisting, turning),
        };
        Self { section, stiffness, damping, shares, length }
    }
}
