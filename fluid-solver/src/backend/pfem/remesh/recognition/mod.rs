//! Which triangles between the moved nodes are fluid.

mod alpha_shape;
mod crossings;
mod moved_domain;

use super::draft::Draft;
use super::tessellation::Tessellation;
use crate::backend::pfem::cloud::Cloud;

/// The rule.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Recognition {
    /// What lies inside of the moved surface: remeshing as such changes no volume.
    #[default]
    MovedDomain,
    /// Triangles whose circumscribed circle is at most this many h in radius, whatever was fluid before.
    AlphaShape {
        /// The number.
        alpha: f64,
    },
}

/// How the fluid is told from the void.
trait Predicate {
    /// Triangulates the nodes and marks the triangles that are fluid; false if the surface had to be changed for it.
    fn recognise(&self, cloud: &mut Cloud<2, 3>, draft: &mut Draft, triangles: &mut Tessellation) -> bool;
}

impl Recognition {
    /// Triangulates the nodes and marks the triangles that are fluid; false if the surface had to be changed for it.
    pub fn recognise(self, cloud: &mut Cloud<2, 3>, draft: &mut Draft, triangles: &mut Tessellation) -> bool {
        match self {
            Self::MovedDomain => moved_domain::MovedDomain.recognise(cloud, draft, triangles),
            Self::AlphaShape { alpha } => {
                alpha_shape::AlphaShape { alpha }.recognise(cloud, draft, triangles)
            }
        }
    }
}
