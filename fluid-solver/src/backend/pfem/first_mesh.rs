//! The mesh of the start, as fine as it is asked to be.

use super::cloud::Cloud;
use super::remesh::{Books, TargetSize};
use super::renewal::Renewal;
use super::wall::Wall;

/// Each remeshing puts at most one node into a patch: more of them than this are not waited for, the steps go on with them.
const MOST: usize = 100;

/// Puts nodes into the cells of the start until they have the target size, with v linear between those that were there. Sizes
/// near grains are not known yet.
///
/// # Errors
/// A place that is not finite.
pub fn refine<const D: usize, const N: usize>(
    cloud: &mut Cloud<D, N>,
    renewal: &mut dyn Renewal<D, N>,
    walls: &[Wall<D>],
    size: &TargetSize,
) -> Result<(), delaunay::Error> {
    if matches!(size, TargetSize::Constant(_)) {
        return Ok(());
    }
    let mut books = Books::start(cloud);
    for _ in 0..MOST {
        let nodes = cloud.place.len();
        renewal.remesh(cloud, walls, 0.0, size, &mut books)?;
        if cloud.place.len() == nodes {
            break;
        }
    }
    Ok(())
}
