//! Regions of a case.

use case_io::document::{self, Case};

use crate::error::DemError;
use crate::insertion::{BoxRegion, CylinderRegion, Region, SphereRegion, SurfaceRegion};
use surface::triangles::{Format, read_closed};

/// The region that the table at `key` states.
///
/// # Errors
/// A file that is no closed surface.
pub fn region<const D: usize>(
    case: &Case,
    key: &str,
    stated: document::Region,
) -> Result<Region<D>, DemError> {
    Ok(match stated {
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
        document::Region::Stl(path, scale) => {
            let key = format!("{key}.path");
            let facets = read_closed(&case.folder.join(path), Format::Stl, scale)
                .map_err(|error| error.at_key(case, &key))?;
            let region = SurfaceRegion::new(facets);
            Region::Surface(region.ok_or_else(|| case.error(&key, "holds no triangle", "", ""))?)
        }
    })
}
