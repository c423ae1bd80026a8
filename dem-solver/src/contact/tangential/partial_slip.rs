//! Hertz's contact of spheres that slips from its edge inwards.

use super::annuli::{ANNULI, Annuli};
use super::{Sliding, Spring, Tangential, shortened};
use crate::contact::coefficients::{Coefficients, Growth};
use crate::lanes::{Lanes, Vec3};

/// F_t = -Σ F_k - c_t v_t over [`ANNULI`] concentric annuli, each of which sticks or slips by itself.
///
/// Mindlin & Deresiewicz's contact under any history of both forces: the edge, where Hertz's pressure vanishes, slips
/// first. By the method of dimensionality reduction the contact of radius a is a row of springs on -a < x < a, which bear
/// the normal force in proportion to a² - x², have together the stiffness k_t = 8 G* a of the contact that sticks, and
/// obey Coulomb's law one by one. An annulus r < |x| < R holds
///
/// | symbol | formula |
/// |---|---|
/// | k, its stiffness | k_t (R - r)/a; only what is in contact counts |
/// | its limit | μ F_n (s(R/a) - s(r/a)), s(z) = (3 z - z³)/2 |
///
/// and its force is that of [`super::Coulomb`]: it turns with the contact, stays where k grows, falls with k, grows by
/// k v_t Δt, and is cut to the limit. So no step makes energy. With 8 annuli the surface speed after an impact is within
/// 0.03 μ v_n of that with very many.
///
/// Source: Mindlin & Deresiewicz, J. Appl. Mech. 20 (1953) 327–344; Popov & Heß, Method of Dimensionality Reduction in
/// Contact Mechanics and Friction (2015), chapter 5.
#[derive(Clone, Copy, Debug)]
pub struct PartialSlip;

impl Tangential for PartialSlip {
    const REMEMBERS: bool = true;
    const SLIPS_IN_PART: bool = true;

    #[inline(always)]
    fn force<L: Lanes>(
        coefficients: &Coefficients<L>,
        growth: Growth<L>,
        sliding: &Sliding<L>,
        spring: &mut Spring<L>,
        annuli: &mut Annuli<L>,
    ) -> Vec3<L> {
        let stiffness = coefficients.tangential_stiffness * growth.stiffness;
        let before = spring.stiffness;
        annuli.turn(sliding.normal);
        annuli.fit(stiffness);
        let touching = L::splat(0.0).less(stiffness);
        let per_radius = L::splat(1.0) / L::select(touching, stiffness, L::splat(1.0));
        let slide = sliding.velocity * sliding.step;
        let mut held = Vec3::zero();
        for k in 0..ANNULI {
            let (inner, outer) = annuli.edges(k, stiffness);
            let limit = sliding.limit * (pressed(outer * per_radius) - pressed(inner * per_radius));
            let (inner_before, outer_before) = annuli.edges(k, before);
            let left = left_in_contact(outer - inner, outer_before - inner_before);
            let force = annuli.force[k] * left + slide * (outer - inner);
            annuli.force[k] = shortened(force, limit);
            held = held + annuli.force[k];
        }
        *spring = Spring { force: held, stiffness, ..*spring };
        let damping = coefficients.tangential_damping * growth.damping;
        shortened(-held - sliding.velocity * damping, sliding.limit)
    }
}

/// Share s(z) of the normal force within the fraction z of the radius, on the row of springs.
#[inline(always)]
fn pressed<L: Lanes>(fraction: L) -> L {
    fraction * (L::splat(1.5) - L::splat(0.5) * fraction * fraction)
}

/// The smaller of 1 and stiffness over that of the last step.
#[inline(always)]
fn left_in_contact<L: Lanes>(now: L, before: L) -> L {
    let one = L::splat(1.0);
    let less = now.less(before);
    if !L::any(less) {
        return one;
    }
    L::select(less, now / L::select(less, before, one), one)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::normal::{Hertz, Normal};
    use crate::material::{Material, PairMaterial};

    const OVERLAP: f64 = 1e-5;
    const LIMIT: f64 = 2.0;

    /// Force of a contact under a constant normal force, μ F_n = 2 N, that slides along x by the steps k_t Δs \[N\].
    fn slide(memory: &mut (Spring, Annuli), steps: impl Iterator<Item = f64>) -> f64 {
        let steel = Material { density: 7800.0, youngs_modulus: 1e9, poissons_ratio: 0.3 };
        let pair = PairMaterial::new(&steel, &steel, 1.0, 0.5);
        let coefficients = Normal::<3>::coefficients(&Hertz { depth: 1.0 }, &pair, 1e-3, 1e-5);
        let growth = <Hertz as Normal<3>>::growth(OVERLAP);
        let stiffness = coefficients.tangential_stiffness * growth.stiffness;
        let mut force = 0.0;
        for pull in steps {
            let sliding = Sliding {
                normal: Vec3::new(0.0, 0.0, 1.0),
                velocity: Vec3::new(pull / stiffness, 0.0, 0.0),
                limit: LIMIT,
                overlap_ahead: None,
                step: 1.0,
            };
            force = PartialSlip::force(&coefficients, growth, &sliding, &mut memory.0, &mut memory.1).x;
        }
        -force
    }

    fn untouched() -> (Spring, Annuli) {
        (Spring::relaxed(), Annuli::relaxed())
    }

    /// μ F_n (1 - (1 - 2 x/3)^(3/2)), x = k_t s/(μ F_n).
    fn cattaneo_mindlin(pull: f64) -> f64 {
        LIMIT * (1.0 - (1.0 - pull / (1.5 * LIMIT)).max(0.0).powf(1.5))
    }

    #[test]
    fn under_a_constant_normal_force_it_is_cattaneo_and_mindlins_contact() {
        for pull in [0.1, 0.5, 1.0, 1.5, 2.0, 2.5, 2.9, 3.0, 4.0] {
            let found = slide(&mut untouched(), (0..100).map(|_| pull / 100.0));
            assert!((found - cattaneo_mindlin(pull)).abs() < 5e-3 * LIMIT, "{pull}: {found}");
        }
    }

    #[test]
    fn turned_back_it_follows_mindlin_and_deresiewiczs_curve_of_twice_the_size() {
        let mut memory = untouched();
        let top = slide(&mut memory, (0..100).map(|_| 0.02));
        for back in [0.5, 1.0, 2.0, 3.0] {
            let found = slide(&mut memory.clone(), (0..100).map(|_| -back / 100.0));
            let curve = top - 2.0 * cattaneo_mindlin(0.5 * back);
            assert!((found - curve).abs() < 1e-2 * LIMIT, "{back}: {found}, {curve}");
        }
    }

    #[test]
    fn beyond_all_sticking_it_bears_the_limit() {
        assert!((slide(&mut untouched(), (0..100).map(|_| 1.0)) - LIMIT).abs() < 1e-14);
    }

    #[test]
    fn annuli_turn_with_the_contact_and_keep_the_length_of_their_forces() {
        let mut annuli: Annuli = Annuli { normal: Vec3::new(0.0, 0.0, 1.0), ..Annuli::relaxed() };
        annuli.force[3] = Vec3::new(3.0, 4.0, 0.0);
        let normal = Vec3::new(0.0, 0.6, 0.8);
        annuli.turn(normal);
        let turned = annuli.force[3];
        assert!((turned.norm_squared().sqrt() - 5.0).abs() < 1e-14 && turned.dot(normal).abs() < 1e-14);
        assert!((turned.x - 3.0).abs() < 1e-14, "the part along the axis of the turn stays");
    }

    #[test]
    fn wider_annuli_bear_what_both_bore_and_narrower_ones_share_it() {
        let mut annuli: Annuli = Annuli { full_stiffness: 8.0, ..Annuli::relaxed() };
        for (k, force) in annuli.force.iter_mut().enumerate() {
            force.x = k as f64;
        }
        let energy = annuli.energy(8.0);
        annuli.fit(15.0);
        assert_eq!(annuli.force.map(|force| force.x), [1.0, 5.0, 9.0, 13.0, 0.0, 0.0, 0.0, 0.0]);
        assert!(annuli.full_stiffness == 16.0 && annuli.energy(8.0) < energy);
        annuli.fit(7.0);
        assert_eq!(annuli.force.map(|force| force.x), [0.5, 0.5, 2.5, 2.5, 4.5, 4.5, 6.5, 6.5]);
    }
}
