//! The laws that are tried, and scenes with them.

use crate::contact::NormalLaw;
use crate::contact::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke, Onate};
use crate::material::{Material, Materials};
use crate::scene::Scene;

/// The laws that keep to a stated restitution.
pub fn own() -> [(&'static str, NormalLaw); 4] {
    [
        ("hertz", NormalLaw::Hertz(Hertz { depth: 1.0 })),
        ("hertz, partial-slip", NormalLaw::HertzPartialSlip(Hertz { depth: 1.0 })),
        ("hooke", NormalLaw::Hooke(Hooke { characteristic_velocity: 1.0, depth: 1.0 })),
        ("onate", NormalLaw::Onate(Onate { area_factor: 1.0, depth: 1.0 })),
    ]
}

/// All laws under which grains touch.
pub fn all() -> [(&'static str, NormalLaw); 6] {
    let [hertz, partial_slip, hooke, onate] = own();
    [
        hertz,
        partial_slip,
        hooke,
        onate,
        ("liggghts-hertz", NormalLaw::LiggghtsHertz(LiggghtsHertz)),
        ("liggghts-hooke", NormalLaw::LiggghtsHooke(LiggghtsHooke { characteristic_velocity: 1.0 })),
    ]
}

/// Spheres of 2500 kg/m³ with these Young's moduli \[Pa\], by material, of one restitution and friction.
pub fn spheres(law: NormalLaw, youngs_moduli: &[f64], restitution: f64, friction: f64) -> Scene<3> {
    let material = |&youngs_modulus| Material { density: 2500.0, youngs_modulus, poissons_ratio: 0.3 };
    let list = youngs_moduli.iter().map(material).collect();
    Scene::new(Materials::new(list, |_, _| (restitution, friction)), law)
}
