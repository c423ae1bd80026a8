//! The deletions of a case.

use case_io::document::{self, Case};

use super::region::region;
use super::walls::plane;
use crate::deletion::{Deletion, Where};
use crate::error::DemError;

/// The deletions of a case.
///
/// # Errors
/// A file that is no closed surface.
pub fn deletions<const D: usize>(case: &Case) -> Result<Vec<Deletion<D>>, DemError> {
    let tables = case.document.deletion.iter().enumerate();
    tables.filter_map(|(index, stated)| deletion(case, index, stated).transpose()).collect()
}

/// Nothing where no region is stated, which loading has refused.
fn deletion<const D: usize>(
    case: &Case,
    index: usize,
    stated: &document::Deletion,
) -> Result<Option<Deletion<D>>, DemError> {
    let of_region = |stated| region(case, &format!("deletion[{index}].stl"), stated).map(Where::Within);
    let within = stated.region().map(of_region).transpose()?;
    let place = within.or_else(|| stated.beyond.as_ref().map(|stated| Where::Beyond(plane(stated))));
    Ok(place.map(|place| Deletion { name: stated.name.clone(), place }))
}
