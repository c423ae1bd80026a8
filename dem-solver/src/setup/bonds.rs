//! The bonds of a case.

use std::collections::BTreeMap;

use case_io::document::{self, Case};

use crate::bond::{Bond, BondLaw, Bonds, Cohesive, ParallelBond};
use crate::engine::{Grid, Periods};
use crate::error::DemError;
use crate::scene::Scene;
use crate::vector::{lane, unlane};
use crate::world::World;

/// The laws of the case's bonds, one for each table.
pub fn laws(case: &Case) -> Vec<BondLaw> {
    case.document.bond.iter().map(law).collect()
}

fn law(stated: &document::Bond) -> BondLaw {
    let modulus = stated.youngs_modulus.si();
    let tensile_strength = stated.tensile_strength.map_or(f64::INFINITY, |strength| strength.si());
    let shear_strength = stated.shear_strength.map_or(f64::INFINITY, |strength| strength.si());
    let damping_ratio = stated.damping_ratio;
    match stated.law {
        document::BondLaw::ParallelBond => BondLaw::ParallelBond(ParallelBond {
            modulus,
            stiffness_ratio: stated.stiffness_ratio.unwrap_or(1.0),
            radius_multiplier: stated.radius_multiplier.unwrap_or(1.0),
            tensile_strength,
            shear_strength,
            damping_ratio,
        }),
        document::BondLaw::Cohesive => BondLaw::Cohesive(Cohesive {
            modulus,
            poissons_ratio: stated.poissons_ratio.unwrap_or(0.0),
            area_factor: stated.area_factor.unwrap_or(1.0),
            tensile_strength,
            shear_strength,
            internal_friction: stated.internal_friction.unwrap_or(0.0),
            damping_ratio,
        }),
    }
}

/// Bonds the pairs of grains that are near enough, of which one at least can move; `firsts` are the insertions' first
/// rows.
///
/// # Errors
/// A table that bonds nothing; a pair that two tables bond.
pub fn bonds<const D: usize>(
    case: &Case,
    scene: &Scene<D>,
    world: &World<D>,
    firsts: &[usize],
) -> Result<Bonds, DemError> {
    let tables = &case.document.bond;
    if tables.is_empty() {
        return Ok(Bonds::default());
    }
    let (grains, periods) = (&world.grains, Periods::new(&scene.domain));
    let member = members(case, firsts, grains.len());
    let widest = tables.iter().map(|table| table.gap.si()).fold(0.0, f64::max);
    let largest = grains.largest_radius();
    let grid = Grid::of_all(grains, &periods, 2.0 * largest + widest);
    let mut found = BTreeMap::new();
    let mut counts = vec![0; tables.len()];
    for (i, a) in grains.place.iter().enumerate() {
        let (mut near, frozen) = (vec![], grains.motion[i].is_frozen());
        grid.visit_around(a, a.radius + largest + widest, |j| {
            if j > i && !(frozen && grains.motion[j].is_frozen()) {
                near.push(j);
            }
        });
        for j in near {
            let b = &grains.place[j];
            let gap = -periods.overlap(a, b);
            let of = |k: &usize| gap <= tables[*k].gap.si() && member[*k][i] && member[*k][j];
            let ids = [grains.id[i], grains.id[j]];
            let separation = unlane(periods.nearest(lane(&(b.centre - a.centre))));
            for k in (0..tables.len()).filter(of) {
                counts[k] += 1;
                if let Some(Bond { law, .. }) = found.insert(ids, Bond::new(ids, k as u32, separation)) {
                    let [one, other] = ids;
                    let told = format!("bonds grains {one} and {other}, which bond[{law}] bonds too");
                    let advice = "name the insertions of each, or leave one of them out";
                    return Err(case.error(&format!("bond[{k}]"), told, "one table a pair", advice).into());
                }
            }
        }
    }
    if let Some(k) = counts.iter().position(|&count| count == 0) {
        let allowed = format!("two grains, not both frozen, up to {} apart", tables[k].gap);
        let advice = "state a larger gap, or insert the grains nearer to each other";
        return Err(case
            .error(&format!("bond[{k}].gap"), "no pair of grains is so near", allowed, advice)
            .into());
    }
    Ok(Bonds::new(found.into_values().collect())?)
}

/// By table, whether the grain of a row is of one of its insertions.
fn members(case: &Case, firsts: &[usize], grains: usize) -> Vec<Vec<bool>> {
    let names = |row: usize| &case.document.insertion[firsts.partition_point(|first| *first <= row) - 1].name;
    let of_table = |table: &document::Bond| {
        let holds = |row| table.insertions.as_ref().is_none_or(|insertions| insertions.contains(names(row)));
        (0..grains).map(holds).collect()
    };
    case.document.bond.iter().map(of_table).collect()
}
