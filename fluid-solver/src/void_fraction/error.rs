//! What can be wrong with grains on a mesh.

/// Grains were refused: what, which, found, allowed, what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum VoidFractionError {
    #[error("grain {grain} is at {position:?}: its position must be finite; reduce the time step")]
    Position { grain: usize, position: Vec<f64> },
    #[error(
        "grain {grain} has diameter {diameter}: the kernel was made for {smallest} to {largest}; make it for the whole range \
         of diameters"
    )]
    Diameter { grain: usize, diameter: f64, smallest: f64, largest: f64 },
    #[error(
        "range of diameters {smallest} to {largest}: needs 0 < smallest <= largest, finite; correct the diameters"
    )]
    Range { smallest: f64, largest: f64 },
    #[error(
        "void fraction {value} at node {node}: allowed is {floor} and above; grains overlap too much or the kernel is too \
         narrow: enlarge the mesh size or stiffen the contacts"
    )]
    BelowFloor { node: usize, value: f64, floor: f64 },
}
