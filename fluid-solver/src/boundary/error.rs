//! What can be wrong with boundary conditions.

/// Boundary conditions were refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum BoundaryError {
    #[error("fluid.boundary: the mesh has no boundary \"{name}\"; allowed: {names}")]
    Unknown { name: String, names: String },
    #[error(
        "fluid.boundary: \"{name}\" is named twice; each boundary of the mesh is named exactly once: delete one"
    )]
    Twice { name: String },
    #[error(
        "fluid.boundary: boundary \"{name}\" of the mesh has no condition; each is named exactly once: add it to the \
         `on` of a [[fluid.boundary]]"
    )]
    Missing { name: String },
    #[error(
        "fluid.boundary: every node of inlet \"{name}\" lies on a wall where the fluid sticks, so the stated speed cannot \
         pass; refine the mesh across it"
    )]
    NoFreeNode { name: String },
}
