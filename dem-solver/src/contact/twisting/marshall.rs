//! The tangential spring and dashpot, spread over the area of contact.

use super::{Resistance, Twist, Twisting};
use crate::lanes::Lanes;

/// T = T_k + c Ω, dT_k/dt = k Ω, both no larger than 2/3 a μ |F_n|, Ω the relative spin about the normal.
///
/// | symbol | formula |
/// |---|---|
/// | k | k_t a²/2 |
/// | c | c_t a²/2 |
/// | a | √(R* δ), δ the overlap, or that of a Hertz contact as wide where bodies adhere |
///
/// As in [`crate::contact::tangential::Coulomb`] the memory is the torque, which falls with the stiffness and does not grow
/// with it: no step makes energy. k adds less than δ/r of what k_t does to the stiffness of a grain's rotation.
///
/// Source: Marshall, J. Comput. Phys. 228 (2009) 1541–1561, Eqs. 47–49; as LAMMPS' `pair granular`, `twisting marshall`.
#[derive(Clone, Copy, Debug)]
pub struct Marshall;

impl Resistance for Marshall {
    #[inline(always)]
    fn torque<L: Lanes>(twisting: &Twisting<L>, twist: &mut Twist<L>) -> L {
        let half_square = L::splat(0.5) * twisting.contact_radius_squared;
        let (stiffness, damping) = (twisting.stiffness * half_square, twisting.damping * half_square);
        let limit = L::splat(2.0 / 3.0) * twisting.contact_radius_squared.sqrt() * twisting.limit;
        let cut = |torque: L| torque.max(-limit).min(limit);
        let before = L::select(L::splat(0.0).less(twist.stiffness), twist.stiffness, L::splat(1.0));
        let left = twist.torque * (stiffness.min(before) / before);
        let held = cut(left + twisting.rate * (stiffness * twisting.step));
        *twist = Twist { torque: held, stiffness };
        cut(held + twisting.rate * damping)
    }
}
