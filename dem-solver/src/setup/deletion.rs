//! The deletions of a case.

use case_io::document::{self, Case};

use super::region::region;
use super::walls::plane;
use crate::deletion::{Deletion, Where};

/// The deletions of a case.
pub fn deletions<const D: usize>(case: &Case) -> Vec<Deletion<D>> {
    case.document.deletion.iter().filter_map(deletion).collect()
}

/// Nothing where no region is stated, which loading has refused.
fn deletion<const D: usize>(stated: &document::Deletion) -> Option<Deletion<D>> {
    let within = stated.region().map(|stated| Where::Within(region(stated)));
    let place = within.or_else(|| stated.beyond.as_ref().map(|stated| Where::Beyond(plane(stated))))?;
    Some(Deletion { name: stated.name.clone(), place })
}
