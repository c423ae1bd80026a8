//! Fabric.

use super::contacts::Contact;
use super::tensor::Tensor;

/// Fabric tensor F_ij = <n_i n_j>, the mean over all contacts, those with walls too; its trace is 1. 0 where nothing
/// touches \[-\].
///
/// Source: Satake, in: Deformation and Failure of Granular Materials (1982) 63–68.
pub fn fabric(contacts: &[Contact]) -> Tensor {
    let sum: Tensor = contacts.iter().map(|contact| contact.normal * contact.normal.transpose()).sum();
    sum / contacts.len().max(1) as f64
}
