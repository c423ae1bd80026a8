//! How much work was done and saved, for `summary.json`.

use crate::engine::{ContactList, Counters};
use crate::scene::Scene;
use crate::sleep::Slumber;

/// Counters of work and, with their units, what saving it took away.
pub type Thrift = (Vec<(String, u64)>, Vec<(String, f64)>);

/// What a run has counted since t = 0; sleep only where grains may sleep.
pub fn thrift<const D: usize>(scene: &Scene<D>, contacts: &ContactList) -> Thrift {
    let Counters { outer, inner, walls } = contacts.counters;
    let mut counters =
        vec![("lists-of-neighbours", outer), ("lists-of-contacts", inner), ("lists-near-walls", walls)];
    let mut taken = vec![];
    if scene.sleep.is_some() {
        let Slumber { fallings, wakings, grain_steps, grain_steps_without_forces, energy } = contacts.slumber;
        counters.extend([
            ("grains-fallen-asleep", fallings),
            ("grains-woken", wakings),
            ("grain-steps-asleep", grain_steps),
            ("grain-steps-asleep-without-forces", grain_steps_without_forces),
        ]);
        taken.push(("energy-taken-by-sleep[J]", energy));
    }
    fn owned<T>(list: Vec<(&str, T)>) -> Vec<(String, T)> {
        list.into_iter().map(|(name, value)| (name.to_string(), value)).collect()
    }
    (owned(counters), owned(taken))
}
