//! Tensors of second order.

use nalgebra::SMatrix;

/// A tensor T_ij, i the row; in 2D only T_xx, T_xy, T_yx and T_yy are not 0.
pub type Tensor = SMatrix<f64, 3, 3>;

/// Axes of the six components xx, yy, zz, yz, xz, xy.
const COMPONENTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)];

/// What the components are called.
pub const NAMES: [&str; 6] = ["xx", "yy", "zz", "yz", "xz", "xy"];

/// The components of the symmetric part.
pub fn components(tensor: &Tensor) -> [f64; 6] {
    COMPONENTS.map(|(i, j)| 0.5 * (tensor[(i, j)] + tensor[(j, i)]))
}
