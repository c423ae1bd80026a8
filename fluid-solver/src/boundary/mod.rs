//! What holds on the boundaries of the mesh.

mod case;
mod condition;
mod constraint;
mod error;
mod normal;
mod profile;

pub use case::velocity_field;
pub use condition::{Condition, Inflow, VelocityField};
pub use constraint::Constraints;
pub use error::BoundaryError;

use crate::mesh::Mesh;

/// A condition for every physical group of a mesh, in the order of [`Mesh::groups`].
#[derive(Clone)]
pub struct Boundaries<const D: usize> {
    conditions: Vec<Condition<D>>,
}

impl<const D: usize> Boundaries<D> {
    /// Sets conditions on boundaries by name.
    ///
    /// # Errors
    /// A name that the mesh does not have or that is given twice; a boundary of the mesh without a condition.
    pub fn new<const N: usize>(
        mesh: &Mesh<D, N>,
        named: impl IntoIterator<Item = (String, Condition<D>)>,
    ) -> Result<Self, BoundaryError> {
        let mut conditions: Vec<Option<Condition<D>>> = vec![None; mesh.groups().len()];
        for (name, condition) in named {
            let Some(group) = mesh.group(&name) else {
                return Err(BoundaryError::Unknown { name, names: mesh.groups().join(", ") });
            };
            if conditions[group as usize].replace(condition).is_some() {
                return Err(BoundaryError::Twice { name });
            }
        }
        if let Some(missing) = conditions.iter().position(Option::is_none) {
            return Err(BoundaryError::Missing { name: mesh.groups()[missing].clone() });
        }
        Ok(Self { conditions: conditions.into_iter().flatten().collect() })
    }

    /// The condition on a physical group.
    pub fn of(&self, group: u32) -> &Condition<D> {
        &self.conditions[group as usize]
    }

    /// Whether no fluid can leave: no outlet.
    pub fn enclosed(&self) -> bool {
        !self.conditions.iter().any(|condition| matches!(condition, Condition::Outlet { .. }))
    }
}
