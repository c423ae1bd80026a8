//! Spring and dashpot up to Coulomb's limit.

use super::{Sliding, Spring, Tangential, shortened};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::lanes::{Lanes, Vec3};

/// F_t = -k_t s - c_t v_t, no longer than μ F_n.
///
/// The memory is the force k_t s:
/// 1. The spring s turns with the contact and keeps its length.
/// 2. Where k_t grows with the load, s shrinks so that the force k_t s stays (a stiffer contact holds no more
///    energy than was put in); where k_t falls the force falls with it.
/// 3. s grows by v_t Δt.
/// 4. Slip: |k_t s| is cut to μ F_n, and after that |F_t| is.
///
/// No step makes energy: 1 keeps it, 2 and the first cut lower that of the spring, and the second cut is a
/// projection on the ball of radius μ F_n that holds k_t s, so that (k_t s + F_t)·v_t ≤ 0.
///
/// Source: Cundall & Strack, Géotechnique 29 (1979) 47–65; 2: Thornton, Cummins & Cleary, Powder Technol. 233
/// (2013) 30–46; 1: Luding, Granular Matter 10 (2008) 235–246, Eq. 10.
#[derive(Clone, Copy, Debug)]
pub struct Coulomb;

impl Tangential for Coulomb {
    const REMEMBERS: bool = true;

    #[inline(always)]
    fn force<L: Lanes>(
        coefficients: &Coefficients<L>,
        growth: Growth<L>,
        sliding: &Sliding<L>,
        spring: &mut Spring<L>,
    ) -> Vec3<L> {
        let stiffness = coefficients.tangential_stiffness * growth.stiffness;
        let damping = coefficients.tangential_damping * growth.damping;
        let held =
            carried_over(spring, sliding.normal, stiffness) + sliding.velocity * (stiffness * sliding.step);
        let held = shortened(held, sliding.limit);
        *spring = Spring { force: held, stiffness, ..*spring };
        shortened(-held - sliding.velocity * damping, sliding.limit)
    }
}

/// What the spring holds after 1 and 2: its force, brought into the plane of the unit normal with its length kept,
/// times the smaller of 1 and k_t/(k_t of the last step). One root and one division do both; no lane divides by 0,
/// which is slow.
#[inline(always)]
fn carried_over<L: Lanes>(spring: &Spring<L>, normal: Vec3<L>, stiffness: L) -> Vec3<L> {
    let flat = spring.force - normal * spring.force.dot(normal);
    let before = spring.stiffness * spring.stiffness;
    let now = (stiffness * stiffness).min(before);
    let left = flat.norm_squared() * before;
    let loaded = L::splat(0.0).less(left);
    let factor = (spring.force.norm_squared() * now / L::select(loaded, left, L::splat(1.0))).sqrt();
    flat * factor.only(loaded)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::normal::{Hertz, Normal};
    use crate::material::{Material, PairMaterial};

    const STEP: f64 = 1e-6;

    fn steel_on_steel() -> Coefficients {
        let steel = Material { density: 7800.0, youngs_modulus: 1e9, poissons_ratio: 0.3 };
        let pair = PairMaterial::new(&steel, &steel, 1.0, 0.5);
        Normal::<3>::coefficients(&Hertz { depth: 1.0 }, &pair, 1e-3, 1e-5)
    }

    fn slide(spring: &mut Spring, overlap: f64, velocity: f64, limit: f64) -> f64 {
        let sliding = Sliding {
            normal: Vec3::new(0.0, 0.0, 1.0),
            velocity: Vec3::new(velocity, 0.0, 0.0),
            limit,
            step: STEP,
        };
        Coulomb::force(&steel_on_steel(), <Hertz as Normal<3>>::growth(overlap), &sliding, spring).x
    }

    #[test]
    fn sliding_force_is_the_limit_and_opposes_the_motion() {
        let mut spring = Spring::relaxed();
        let force = (0..1000).map(|_| slide(&mut spring, 1e-5, 1.0, 3.0)).last().unwrap();
        assert!((force + 3.0).abs() < 1e-14);
        assert!((spring.force.x - 3.0).abs() < 1e-14);
    }

    #[test]
    fn shearing_a_light_contact_and_pressing_it_gives_no_energy_back_that_was_not_put_in() {
        let mut spring = Spring::relaxed();
        let mut work = 0.0;
        let mut strain = |overlap: f64, velocity: f64| {
            work += slide(&mut spring, overlap, velocity, f64::INFINITY) * velocity * STEP;
        };
        (0..1000).for_each(|_| strain(1e-7, 1e-3));
        (0..1000).for_each(|k| strain(1e-7 + k as f64 * 1e-8, 0.0));
        (0..1000).for_each(|_| strain(1e-5, -1e-3));
        assert!(work <= 0.0, "the contact gave {work} J");
    }

    #[test]
    fn a_spring_turned_with_the_contact_keeps_its_length() {
        let spring = Spring { force: Vec3::new(3.0, 0.0, 4.0), stiffness: 7.0, ..Spring::relaxed() };
        let normal = Vec3::new(0.0, 0.6, 0.8);
        let turned = carried_over(&spring, normal, spring.stiffness);
        assert!((turned.norm_squared().sqrt() - 5.0).abs() < 1e-14);
        assert!(turned.dot(normal).abs() < 1e-14);
    }
}
