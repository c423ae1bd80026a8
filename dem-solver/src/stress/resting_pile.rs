//! A pile that rests for very many steps, awake and asleep.

use super::finding::Finding;
use super::runner::Runner;
use super::{Effort, laws};
use crate::error::DemError;
use crate::grains::Grain;
use crate::insertion::Random;
use crate::scene::Scene;
use crate::sleep::SleepBound;
use crate::vector::Spin;

const RADIUS: f64 = 1e-3;
const GRAVITY: f64 = 9.81;
/// Grains along the sides of the lowest layer, which is frozen.
const BASE: u32 = 6;
/// Time in which the pile comes to rest \[s\].
const SETTLING: f64 = 0.5;
const STEPS_PER_WINDOW: u32 = 1000;

/// What became of a pile at rest, relative to the radius r and to the weight m g of a grain.
struct Rest {
    /// Furthest way of a grain, over r.
    drift: f64,
    /// Largest kinetic energy seen at the end of a window, over m g r.
    kinetic_energy: f64,
    /// Growth of all energy, over m g r.
    growth: f64,
    /// Share of the grain-steps in which grains moved or forces were found.
    worked: f64,
}

/// Energy and drift of a pyramid of spheres.
pub fn findings(effort: Effort) -> Vec<Finding> {
    let steps = if effort == Effort::Quick { 20_000 } else { 1_000_000 };
    let mut findings = Vec::new();
    for (name, law) in laws::own() {
        let scene = laws::spheres(law, &[1e7], 0.5, 0.5).with_gravity([0.0, 0.0, -GRAVITY]);
        findings.extend(asleep(name, scene.clone(), steps));
        let (what, rest) = (format!("{name}, {steps} steps"), rest(Runner::new(scene, &pyramid()), steps));
        // An error is told in the first row of the three.
        let (drift, others) = match rest {
            Ok(rest) => (Ok(rest.drift), Some([rest.kinetic_energy, rest.growth])),
            Err(error) => (Err(error), None),
        };
        findings.push(Finding::number(&what, "drift over the radius", drift, 0.0..=1e-6));
        if let Some([kinetic_energy, growth]) = others {
            let allowed = 0.0..=1e-9;
            findings.push(Finding::number(&what, "kinetic energy over m g r", Ok(kinetic_energy), allowed));
            let allowed = f64::NEG_INFINITY..=1e-9;
            findings.push(Finding::number(&what, "growth of energy over m g r", Ok(growth), allowed));
        }
    }
    findings
}

/// The same pile where idle grains sleep: none moves, next to nothing is worked on.
fn asleep(name: &str, scene: Scene<3>, steps: u32) -> Vec<Finding> {
    let bound = SleepBound { speed: 1e-4 * (2.0 * GRAVITY * RADIUS).sqrt(), acceleration: 1e-3 * GRAVITY };
    let rest = rest(Runner::new(scene.with_sleep(bound), &pyramid()), steps);
    let what = format!("{name}, {steps} steps, asleep");
    let (drift, worked) = match rest {
        Ok(rest) => (Ok(rest.drift), Some(rest.worked)),
        Err(error) => (Err(error), None),
    };
    let worked =
        worked.map(|worked| Finding::number(&what, "share of grain-steps worked on", Ok(worked), 0.0..=0.2));
    std::iter::once(Finding::number(&what, "drift over the radius", drift, 0.0..=1e-6))
        .chain(worked)
        .collect()
}

/// Layers of n², (n - 1)², … spheres in each other's hollows, not quite in place: overlaps at the start hold less than the
/// weight lifts, else the stiffest law throws grains off.
fn pyramid() -> Vec<Grain<3>> {
    let mut random = Random::new(2);
    let mut jitter = || random.between(-0.001, 0.001) * RADIUS;
    let mut grains = Vec::new();
    for layer in 0..BASE {
        let side = BASE - layer;
        for k in 0..side * side {
            let along = |index: u32| (2.0 * f64::from(index) + f64::from(layer)) * RADIUS;
            let at = [along(k % side), along(k / side), f64::from(layer) * 2.0_f64.sqrt() * RADIUS];
            grains.push(if layer == 0 {
                Grain::at(at, RADIUS).frozen()
            } else {
                Grain::at(at.map(|x| x + jitter()), RADIUS)
            });
        }
    }
    grains
}

fn rest(mut pile: Runner, steps: u32) -> Result<Rest, DemError> {
    pile.run(SETTLING, 0.01)?;
    let centres = |pile: &Runner| -> Vec<Spin> {
        let grains = &pile.world.grains;
        let mut all: Vec<_> =
            grains.id.iter().zip(&grains.place).map(|(id, place)| (*id, place.centre)).collect();
        all.sort_by_key(|(id, _)| *id);
        all.into_iter().map(|(_, centre)| centre).collect()
    };
    let (before, energy) = (centres(&pile), pile.energy());
    let step = 0.5 * pile.critical();
    let slept = |pile: &Runner| pile.world.contacts.slumber.grain_steps_without_forces;
    let slept_before = slept(&pile);
    let mut kinetic_energy = 0.0_f64;
    for _ in 0..steps / STEPS_PER_WINDOW {
        pile.window(f64::from(STEPS_PER_WINDOW) * step, STEPS_PER_WINDOW)?;
        kinetic_energy = kinetic_energy.max(pile.kinetic_energy());
    }
    let ways = centres(&pile).into_iter().zip(&before).map(|(after, before)| (after - before).norm());
    let grain_steps = f64::from(steps) * pile.world.grains.len() as f64;
    let lift = pile.world.grains.mass[0] * GRAVITY * RADIUS;
    Ok(Rest {
        drift: ways.fold(0.0, f64::max) / RADIUS,
        kinetic_energy: kinetic_energy / lift,
        growth: (pile.energy() - energy) / lift,
        worked: 1.0 - (slept(&pile) - slept_before) as f64 / grain_steps,
    })
}
