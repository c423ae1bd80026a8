//! How far apart nodes should be.

use super::grading::Grading;
use crate::backend::pfem::cloud::Cloud;

/// Target size h of the cells (m).
#[derive(Clone, Debug, PartialEq)]
pub enum TargetSize {
    /// The same everywhere.
    Constant(f64),
    /// One value per node of the cloud.
    Nodal(Vec<f64>),
    /// Finer near some things.
    Graded(Grading),
}

impl TargetSize {
    /// Writes h at each node of the cloud.
    pub fn at_nodes<const D: usize, const N: usize>(&self, cloud: &Cloud<D, N>, sizes: &mut Vec<f64>) {
        sizes.clear();
        match self {
            Self::Constant(h) => sizes.resize(cloud.place.len(), *h),
            Self::Nodal(values) => sizes.extend_from_slice(values),
            Self::Graded(grading) => grading.at_nodes(cloud, sizes),
        }
    }

    /// The largest h that there may be at a node (m).
    pub fn most_at(&self, node: usize) -> f64 {
        match self {
            Self::Constant(h) | Self::Graded(Grading { coarse: h, .. }) => *h,
            Self::Nodal(sizes) => sizes[node],
        }
    }

    /// Whether it holds for the nodes of one cloud only.
    pub fn is_of_nodes(&self) -> bool {
        match self {
            Self::Constant(_) => false,
            Self::Nodal(_) => true,
            Self::Graded(grading) => !grading.by_grains.is_empty(),
        }
    }
}
