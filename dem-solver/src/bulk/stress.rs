//! Stress.

use super::contacts::Contact;
use super::tensor::Tensor;

/// Stress that contacts carry, σ_ij = 1/V Σ_c F_i b_j, V the volume \[m³\], positive in tension \[Pa\].
///
/// Bridges of liquid count as contacts, and contacts with walls count with the branch from the grain's centre to where the wall's force acts, so that σ is the
/// mean of the grains' stresses in a volume that all of them fill up. It is symmetric where no grain is turned. What
/// fluctuations of the velocity carry, -1/V Σ m v' v', is not in it.
///
/// Source: Christoffersen, Mehrabadi & Nemat-Nasser, J. Appl. Mech. 48 (1981) 339–344.
pub fn contact_stress(contacts: &[Contact], volume: f64) -> Tensor {
    let sum: Tensor = contacts.iter().map(|contact| contact.force * contact.branch.transpose()).sum();
    sum / volume
}
