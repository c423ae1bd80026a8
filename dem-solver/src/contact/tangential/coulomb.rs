//! Spring and dashpot up to Coulomb's limit.

use super::{Annuli, Sliding, Spring, Tangential, shortened};
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
/// 5. In the last substep of a contact that is stiff up to its end, a spring that would swing past its rest before the
///    next is let go of there.
///
/// No step makes energy: 1 keeps it, 2 and the first cut lower that of the spring, and the second cut is a
/// projection on the ball of radius μ F_n that holds k_t s, so that (k_t s + F_t)·v_t ≤ 0. 5: [`let_go`].
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
        _: &mut Annuli<L>,
    ) -> Vec3<L> {
        let stiffness = coefficients.tangential_stiffness * growth.stiffness;
        let damping = coefficients.tangential_damping * growth.damping;
        let held =
            carried_over(spring, sliding.normal, stiffness) + sliding.velocity * (stiffness * sliding.step);
        let held = let_go(coefficients, shortened(held, sliding.limit), stiffness, sliding);
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

/// A force at the surface of a sphere moves that 1 + m r²/I = 7/2 times as much as its centre, of a disc 3 times.
const SURFACE_OVER_CENTRE: f64 = 3.5;

/// The force f = k_t s in the last substep of a contact, cut so that the bodies gain no energy.
///
/// In substeps h a spring keeps E = m v²/2 + f·f⁻/(2 k_t), f and f⁻ what it holds in the middles of this substep and
/// the last, m the mass of the surfaces that rub. What it holds when the contact ends is lost:
/// m v'²/2 - E = -θ f·v h + (θ f h)²/(2m) - f·f⁻/(2 k_t) with θ f in place of f and f⁻ = f - k_t v h. With
/// x = -k_t h v·f/f² and w = k_t h²/m this is at most 0 for θ = 1 where x ≤ 1 - w, and for θ = (1 + x - w)/(2 x) elsewhere:
/// where f would pull beyond the place at which the spring is at rest. A spring whose stiffness vanishes with the
/// overlap holds nothing there.
#[inline(always)]
fn let_go<L: Lanes>(
    coefficients: &Coefficients<L>,
    held: Vec3<L>,
    stiffness: L,
    sliding: &Sliding<L>,
) -> Vec3<L> {
    let Some(overlap_ahead) = sliding.overlap_ahead else { return held };
    let ends = overlap_ahead.less(L::splat(0.0));
    if !L::any(ends) {
        return held;
    }
    let step = sliding.step;
    let w = stiffness * step * step * coefficients.inverse_mass * L::splat(SURFACE_OVER_CENTRE);
    let one = L::splat(1.0);
    let swung = -(stiffness * step * sliding.velocity.dot(held));
    let kept = held.norm_squared() * (one - w);
    let beyond = L::both(ends, kept.less(swung));
    let share = (kept + swung) / L::select(beyond, swung + swung, one);
    held * L::select(beyond, share, one)
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
            overlap_ahead: None,
            step: STEP,
        };
        Coulomb::force(
            &steel_on_steel(),
            <Hertz as Normal<3>>::growth(overlap),
            &sliding,
            spring,
            &mut Annuli::relaxed(),
        )
        .x
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
