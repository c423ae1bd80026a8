//! Whether grains can be where they start.

use case_io::document::Case;

use crate::contact::NormalLaw;
use crate::error::DemError;
use crate::insertion::{Partner, coincident, overlaps};
use crate::scene::Scene;
use crate::vector::embed;
use crate::world::World;

/// No two centres coincide, and none is outside the domain; `firsts` are the insertions' first rows.
pub fn check_places<const D: usize>(
    case: &Case,
    scene: &Scene<D>,
    world: &World<D>,
    firsts: &[usize],
) -> Result<(), DemError> {
    let insertion = |row: usize| format!("insertion[{}]", firsts.partition_point(|first| *first <= row) - 1);
    let at = |row: usize| {
        let centre = world.grains.place[row].centre;
        format!("({}, {}, {}) m", centre.x, centre.y, centre.z)
    };
    if let Some((one, other)) = coincident(&world.grains, &scene.domain) {
        let found = format!("grains {one} and {other} both have their centre at {}", at(one));
        return Err(case.error(&insertion(other), found, "", "insert grains apart from each other").into());
    }
    if let Some(row) = world.grains.place.iter().position(|place| !scene.domain.holds(&place.at())) {
        let (lower, upper) = (embed(&scene.domain.lower), embed(&scene.domain.upper));
        let found = format!("the centre of grain {row} is at {}", at(row));
        let allowed = format!(
            "from ({}, {}, {}) m to ({}, {}, {}) m, the domain",
            lower.x, lower.y, lower.z, upper.x, upper.y, upper.z
        );
        return Err(case
            .error(&insertion(row), found, allowed, "move the grain, or enlarge grains.domain")
            .into());
    }
    check_overlaps(case, scene, world, &insertion)
}

/// No grain that can touch another or a wall overlaps it by more than the case allows.
fn check_overlaps<const D: usize>(
    case: &Case,
    scene: &Scene<D>,
    world: &World<D>,
    insertion: &dyn Fn(usize) -> String,
) -> Result<(), DemError> {
    if scene.normal_law == NormalLaw::None {
        return Ok(());
    }
    let allowed = case.document.grains.as_ref().map_or(0.0, |grains| grains.start_overlap);
    let found = overlaps(scene, world, allowed);
    let Some(deepest) = found.iter().reduce(|a, b| if b.fraction > a.fraction { b } else { a }) else {
        return Ok(());
    };
    let (row, with) = match deepest.with {
        Partner::Grain(other) => (other, format!("grain {}", deepest.grain)),
        Partner::Wall(wall) => (deepest.grain, format!("the wall \"{}\"", scene.walls.names[wall as usize])),
    };
    let others = match found.len() {
        1 => String::new(),
        more => format!(" (and {} more overlap)", more - 1),
    };
    let depth = 100.0 * deepest.fraction;
    let told = format!("grain {row} overlaps {with} by {depth:.3} % of a diameter{others}");
    let most = format!("at most {} %", 100.0 * allowed);
    let advice = "insert grains apart from each other and from walls, or state a larger grains.start-overlap";
    Err(case.error(&insertion(row), told, most, advice).into())
}
