//! The alpha shape on the local target size.

use super::super::draft::{Draft, circumradius};
use super::super::tessellation::Tessellation;
use super::Predicate;
use crate::backend::pfem::cloud::Cloud;
use delaunay::Error;

/// R ≤ α h.
pub struct AlphaShape {
    /// α.
    pub alpha: f64,
}

impl Predicate for AlphaShape {
    fn recognise(
        &self,
        cloud: &mut Cloud<2, 3>,
        draft: &mut Draft,
        triangles: &mut Tessellation,
    ) -> Result<bool, Error> {
        triangles.triangulate(cloud, draft)?;
        triangles.fluid.clear();
        for triangle in 0..triangles.len() {
            let h = triangles.nodes(triangle).map(|node| draft.size[node as usize]).iter().sum::<f64>() / 3.0;
            triangles.fluid.push(circumradius(&triangles.vertices(triangle)) <= self.alpha * h);
        }
        Ok(true)
    }
}
