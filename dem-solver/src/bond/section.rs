//! Cross-sections of bonds.

use std::f64::consts::PI;

/// What the bonds of a scene look like across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Profile {
    /// Discs: bonds of spheres.
    Round,
    /// Strips of the slab's depth b \[m\]: bonds in two dimensions.
    Strip {
        /// b \[m\].
        depth: f64,
    },
}

/// Cross-section of a bond of radius R̄.
///
/// | | area A | second moment I | polar moment J |
/// |---|---|---|---|
/// | round | π R̄² | π R̄⁴/4 | π R̄⁴/2 |
/// | strip | 2 R̄ b | 2/3 R̄³ b | none: it is never twisted |
///
/// Source: Potyondy & Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329–1364, Eq. 17.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// R̄, the distance of the outermost fibre \[m\].
    pub radius: f64,
    /// A \[m²\].
    pub area: f64,
    /// I, about an axis across the bond \[m⁴\].
    pub second_moment: f64,
    /// J, about the bond's own axis \[m⁴\]; nothing in two dimensions.
    pub polar_moment: Option<f64>,
}

impl Section {
    /// The section of this profile and radius \[m\].
    pub fn new(profile: Profile, radius: f64) -> Self {
        let (square, fourth) = (radius * radius, radius.powi(4));
        match profile {
            Profile::Round => Self {
                radius,
                area: PI * square,
                second_moment: 0.25 * PI * fourth,
                polar_moment: Some(0.5 * PI * fourth),
            },
            Profile::Strip { depth } => Self {
                radius,
                area: 2.0 * radius * depth,
                second_moment: 2.0 / 3.0 * square * radius * depth,
                polar_moment: None,
            },
        }
    }

    /// Largest tensile stress, σ = F/A + M R̄/I \[Pa\], of a tension F \[N\] and a bending moment M \[N m\].
    pub fn tensile_stress(&self, tension: f64, bending: f64) -> f64 {
        tension / self.area + bending * self.radius / self.second_moment
    }

    /// Largest shear stress, τ = F/A + M R̄/J \[Pa\], of a shear force F \[N\] and a twisting moment M \[N m\].
    pub fn shear_stress(&self, shear: f64, twisting: f64) -> f64 {
        shear / self.area + self.polar_moment.map_or(0.0, |polar| twisting * self.radius / polar)
    }
}
