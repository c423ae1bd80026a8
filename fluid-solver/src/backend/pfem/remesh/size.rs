//! How far apart nodes should be.

use super::grading::Grading;
use crate::backend::pfem::cloud::Cloud;

/// Target size h of the cells (m).
#[derive(Clone, Debug, PartialEq)]
pub enum TargetSize {
    /// The same everywhere.
    Constant(f64),
    /// Finer near some things.
    Graded(Grading),
}

impl TargetSize {
    /// Writes h at each node of the cloud.
    pub fn at_nodes<const D: usize, const N: usize>(&self, cloud: &Cloud<D, N>, sizes: &mut Vec<f64>) {
        sizes.clear();
        match self {
            Self::Constant(h) => sizes.resize(cloud.place.len(), *h),
            Self::Graded(grading) => grading.at_nodes(cloud, sizes),
        }
    }

    /// The largest h that there may be (m).
    pub fn largest(&self) -> f64 {
        match self {
            Self::Constant(h) | Self::Graded(Grading { coarse: h, .. }) => *h,
        }
    }

    /// Takes the share of fluid ε at each node of a cloud: grains are where it is below 1.
    pub fn see_grains(&mut self, void_fraction: &[f64]) {
        if let Self::Graded(grading) = self
            && grading.asks_for_grains()
        {
            grading.by_grains.clear();
            grading.by_grains.extend(void_fraction.iter().map(|&share| share < 1.0));
        }
    }

    /// Whether it holds for the nodes of one cloud only.
    pub fn is_of_nodes(&self) -> bool {
        matches!(self, Self::Graded(grading) if !grading.by_grains.is_empty())
    }
}
