//! Parallel bond: an elastic beam of cement beside the contact.

use super::{Failure, Law, Profile, Resultants, Rigidity, Section};

/// A beam of radius R̄ = λ min(r_i, r_j) that acts beside the contact of its grains:
///
/// | symbol | code | unit | formula |
/// |---|---|---|---|
/// | F_n | `tension` | N | k_n A (d - d₀), k_n = Ē/d₀ |
/// | ΔF_s | `shear` | N | -k_s A Δu_s, k_s = k_n/κ |
/// | ΔM_b | `bending` | N m | -k_n I Δθ_b |
/// | ΔM_t | `twisting` | N m | -k_s J Δθ_t |
///
/// d₀ is the distance of the centres when the bond was made, r_i + r_j of grains that touch. It breaks, and lets go
/// of all its load at once, when F_n/A + |M_b| R̄/I ≥ σ_c or |F_s|/A + |M_t| R̄/J ≥ τ_c.
///
/// A row of n bonds is a Timoshenko beam of modulus Ē and shear stiffness Ē A/κ; the tip of its cantilever bends by
/// 1/(4 n²) less.
///
/// Source: Potyondy & Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329–1364, Eqs. 12–18 and 21. Departures: F_n
/// follows from the distance and not from its increments; the bond has dashpots of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParallelBond {
    /// Ē, Young's modulus of the cement \[Pa\].
    pub modulus: f64,
    /// κ = k_n/k_s.
    pub stiffness_ratio: f64,
    /// λ, radius of the bond over that of the smaller grain.
    pub radius_multiplier: f64,
    /// σ_c \[Pa\].
    pub tensile_strength: f64,
    /// τ_c \[Pa\].
    pub shear_strength: f64,
    /// ζ.
    pub damping_ratio: f64,
}

impl Law for ParallelBond {
    fn replaces_contact(&self) -> bool {
        false
    }

    fn section(&self, [i, j]: [f64; 2], profile: Profile) -> Section {
        Section::new(profile, self.radius_multiplier * i.min(j))
    }

    fn stiffness(&self, section: &Section, length: f64) -> Rigidity {
        let normal = self.modulus / length;
        let shear = normal / self.stiffness_ratio;
        Rigidity {
            normal: normal * section.area,
            shear: shear * section.area,
            bending: normal * section.second_moment,
            twisting: shear * section.polar_moment.unwrap_or(0.0),
        }
    }

    fn damping_ratio(&self) -> f64 {
        self.damping_ratio
    }

    fn failure(&self, section: &Section, load: &Resultants) -> Option<Failure> {
        if section.tensile_stress(load.tension, load.bending) >= self.tensile_strength {
            Some(Failure::Tension)
        } else if section.shear_stress(load.shear, load.twisting) >= self.shear_strength {
            Some(Failure::Shear)
        } else {
            None
        }
    }
}
