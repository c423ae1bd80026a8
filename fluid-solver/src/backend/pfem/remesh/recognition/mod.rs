//! Which triangles between the moved nodes are fluid.

mod alpha_shape;
mod crossings;
mod moved_domain;

use super::draft::Draft;
use super::tessellation::Tessellation;
use crate::backend::pfem::cloud::Cloud;
use delaunay::Error;

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
    ///
    /// # Errors
    /// A place that is not finite.
    fn recognise(
        &self,
        cloud: &mut Cloud<2, 3>,
        draft: &mut Draft,
        triangles: &mut Tessellation,
    ) -> Result<bool, Error>;
}

impl Recognition {
    /// Triangulates the nodes and marks the triangles that are fluid; false if the surface had to be changed for it.
    ///
    /// # Errors
    /// A place that is not finite.
    pub fn recognise(
        self,
        cloud: &mut Cloud<2, 3>,
        draft: &mut Draft,
        triangles: &mut Tessellation,
    ) -> Result<bool, Error> {
        match self {
            Self::MovedDomain => moved_domain::MovedDomain.recognise(cloud, draft, triangles),
            Self::AlphaShape { alpha } => {
                alpha_shape::AlphaShape { alpha }.recognise(cloud, draft, triangles)
            }
        }
    }
}
