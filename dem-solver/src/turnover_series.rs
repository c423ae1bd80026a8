//! `series/turnover.csv`: the grains that came and went so far.

use crate::deletion::Taken;
use crate::scene::{Escape, Scene};
use crate::world::World;

/// Of each insertion over time the grains fed, and how often one was due and found no room; of each deletion, and of
/// the domain's sides where they let grains out, the grains taken and their mass. Nothing where no grain comes or goes.
pub fn turnover_titles<const D: usize>(scene: &Scene<D>, world: &World<D>) -> Vec<String> {
    let fed = world.feeds.iter().map(|feed| (&feed.batch.name, ["count[-]", "refused[-]"]));
    let escaped = (scene.escape == Escape::Remove).then(|| "escaped".to_string());
    let takers = scene.deletions.iter().map(|deletion| &deletion.name).chain(&escaped);
    let taken = takers.map(|name| (name, ["count[-]", "mass[kg]"]));
    fed.chain(taken).flat_map(|(name, columns)| columns.map(|column| format!("{name}-{column}"))).collect()
}

/// The time and the values under these titles.
pub fn turnover_row<const D: usize>(scene: &Scene<D>, world: &World<D>) -> Vec<f64> {
    let mut row = vec![world.time];
    row.extend(world.feeds.iter().flat_map(|feed| [feed.count as f64, feed.refused as f64]));
    let takers = scene.deletions.len() + usize::from(scene.escape == Escape::Remove);
    let taken = (0..takers).map(|taker| world.taken.get(taker).copied().unwrap_or_default());
    row.extend(taken.flat_map(|Taken { count, mass }| [count as f64, mass]));
    row
}
