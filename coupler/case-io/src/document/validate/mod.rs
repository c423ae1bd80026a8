//! What must hold beyond the form: all that can be checked without the mesh and without the solvers.

mod bond;
mod clump;
mod cohesion;
mod coupling;
mod deletion;
mod fluid;
mod gate;
mod general;
mod grains;
mod insertion;
mod lubrication;
mod material;
mod mesh;
mod motion_table;
mod pfem;
mod probe;
mod region;
mod rules;
mod sizes;
mod sleep;
mod surface;
mod wall;

use super::Document;
use crate::error::CaseError;
use crate::tree::Source;
use rules::Rules;

pub(super) use rules::{check_name, check_run_name};

/// Refuses the first thing that cannot be, or that would have no effect.
pub(super) fn validate(document: &Document, source: &Source) -> Result<(), CaseError> {
    let rules = &Rules { source, dimension: document.case.dimension };
    general::check(document, rules)?;
    insertion::check(document, rules)?;
    clump::check(document, rules)?;
    bond::check(document, rules)?;
    deletion::check(document, rules)?;
    wall::check(document, rules)?;
    material::check(document, rules)?;
    fluid::check(document, rules)?;
    grains::check(document, rules)?;
    sleep::check(document, rules)?;
    surface::check(document, rules)?;
    cohesion::check(document, rules)?;
    lubrication::check(document, rules)?;
    coupling::check(document, rules)?;
    probe::check(document, rules)
}
