//! Regions of a case.

use case_io::document;

use crate::insertion::{BoxRegion, CylinderRegion, Region, SphereRegion};

/// The region that a table states.
pub fn region<const D: usize>(stated: document::Region) -> Region<D> {
    match stated {
        document::Region::Box(lower, upper) => {
            Region::Box(BoxRegion { lower: lower.to_array().into(), upper: upper.to_array().into() })
        }
        document::Region::Sphere(centre, radius) => {
            Region::Sphere(SphereRegion { centre: centre.to_array().into(), radius: radius.si() })
        }
        document::Region::Cylinder(from, to, radius) => Region::Cylinder(CylinderRegion {
            start: from.to_array().into(),
            end: to.to_array().into(),
            radius: radius.si(),
        }),
    }
}
