//! Cohesive contact: normal and shear springs that bear tension.

use super::{Failure, Law, Profile, Resultants, Rigidity, Section};

/// Springs instead of the contact of two grains, of the effective area Ā = α π r_c² (2 α r_c b in two dimensions),
/// r_c = 2 r_i r_j/(r_i + r_j):
///
/// | symbol | code | unit | formula |
/// |---|---|---|---|
/// | F_n | `tension` | N | K_n (d - d₀), K_n = E Ā/d₀, in tension and in compression |
/// | ΔF_s | `shear` | N | -K_s Δu_s, K_s = K_n/(2 (1 + ν)) |
///
/// d₀ is the distance of the centres when the bond was made. It carries no moment: a single row of grains bends freely
/// at its joints, a packing does not. It breaks at once, and the grains are then in plain contact, when
/// F_n ≥ σ_t Ā or |F_s| ≥ τ_f Ā + μ max(-F_n, 0).
///
/// Source: Idelsohn, Oñate & Becker (2017), Eqs. 109–115; strength: Oñate et al., Comput. Part. Mech. 2 (2015)
/// 139–160, without its softening and plasticity. Departures: the papers leave r_c open; their C_n makes of ξ no
/// damping ratio, here it is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cohesive {
    /// E \[Pa\].
    pub modulus: f64,
    /// ν.
    pub poissons_ratio: f64,
    /// α, for packings that are not optimal; about 1.
    pub area_factor: f64,
    /// σ_t \[Pa\].
    pub tensile_strength: f64,
    /// τ_f \[Pa\].
    pub shear_strength: f64,
    /// μ, by which compression raises the shear strength.
    pub internal_friction: f64,
    /// ζ.
    pub damping_ratio: f64,
}

impl Law for Cohesive {
    fn replaces_contact(&self) -> bool {
        true
    }

    fn section(&self, [i, j]: [f64; 2], profile: Profile) -> Section {
        let plain = Section::new(profile, 2.0 * i * j / (i + j));
        Section { area: self.area_factor * plain.area, ..plain }
    }

    fn stiffness(&self, section: &Section, length: f64) -> Rigidity {
        let normal = self.modulus * section.area / length;
        Rigidity { normal, shear: normal / (2.0 * (1.0 + self.poissons_ratio)), bending: 0.0, twisting: 0.0 }
    }

    fn damping_ratio(&self) -> f64 {
        self.damping_ratio
    }

    fn failure(&self, section: &Section, load: &Resultants) -> Option<Failure> {
        let sheared = self.shear_strength * section.area + self.internal_friction * (-load.tension).max(0.0);
        if load.tension >= self.tensile_strength * section.area {
            Some(Failure::Tension)
        } else if load.shear >= sheared {
            Some(Failure::Shear)
        } else {
            None
        }
    }
}
