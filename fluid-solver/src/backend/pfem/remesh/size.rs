//! How far apart nodes should be.

/// Target size h of the cells (m).
#[derive(Clone, Debug, PartialEq)]
pub enum TargetSize {
    /// The same everywhere.
    Constant(f64),
    /// One value per node of the cloud.
    Nodal(Vec<f64>),
}

impl TargetSize {
    /// Writes h at each of `nodes` nodes.
    pub fn at_nodes(&self, nodes: usize, sizes: &mut Vec<f64>) {
        sizes.clear();
        match self {
            Self::Constant(h) => sizes.resize(nodes, *h),
            Self::Nodal(values) => sizes.extend_from_slice(values),
        }
    }
}
