//! The slope of a heap.

use super::finding::Finding;
use super::runner::Runner;
use super::{Effort, laws};
use crate::error::DemError;
use crate::grains::Grain;
use crate::insertion::Random;

/// Mean radius of the grains \[m\].
const RADIUS: f64 = 1e-3;
/// Their radii differ from it by up to this share: like spheres on a lattice build crystals, which stand without friction.
const SPREAD: f64 = 0.2;
/// Height and radius of the cone of loose grains that slumps, over the mean radius.
const CONE: f64 = 24.0;
/// Distance of the grains in it at the start, over the mean radius.
const SPACING: f64 = 2.45;
/// Frozen grains along the sides of the rough floor.
const FLOOR: u32 = 60;
/// Time in which the heap comes to rest \[s\].
const DURATION: f64 = 0.6;

/// A cone of 45° slumps on a rough floor. Spheres that roll freely come to rest below 30°, and the lower the less they
/// rub.
///
/// Source: Zhou, Xu, Yu & Zulli, Powder Technol. 125 (2002) 45–54.
pub fn findings(_: Effort) -> Vec<Finding> {
    let angles = [0.1, 0.5].map(|friction| (friction, angle(friction)));
    let mut findings = Vec::new();
    let mut last = None;
    for (friction, angle) in angles {
        let degrees = angle.as_ref().ok().copied();
        findings.push(Finding::number(format!("μ = {friction}"), "angle in degrees", angle, 5.0..=30.0));
        if let (Some(less), Some(more)) = (last, degrees) {
            let what = format!("μ = {friction} against the last");
            findings.push(Finding::number(what, "more degrees", Ok(more - less), 2.0..=f64::INFINITY));
        }
        last = degrees;
    }
    findings
}

/// Slope H/B, in degrees, of the cone of the heap's mean height H/4 above its base and median distance B/2 from its axis,
/// on which grains that rolled away have little weight.
fn angle(friction: f64) -> Result<f64, DemError> {
    let scene = laws::spheres(laws::own()[0].1, &[1e7], 0.5, friction).with_gravity([0.0, 0.0, -9.81]);
    let mut heap = Runner::new(scene, &cone());
    heap.run(DURATION, 2e-3)?;
    let grains = &heap.world.grains;
    let rows = grains.motion.iter().zip(&grains.place).filter(|(motion, _)| !motion.is_frozen());
    let centres: Vec<_> = rows.map(|(_, place)| place.centre).collect();
    let median = |mut values: Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    // In the hollows of a regular floor centres are at (√2 - 1) r, and the lowest layer begins half a layer, r/√2, below.
    let base = (2.0_f64.sqrt() - 1.0 - 0.5_f64.sqrt()) * RADIUS;
    let height = centres.iter().map(|c| c.z - base).sum::<f64>() / centres.len() as f64;
    let axis = [0, 1].map(|k| median(centres.iter().map(|c| c[k]).collect()));
    let distance = median(centres.iter().map(|c| (c.x - axis[0]).hypot(c.y - axis[1])).collect());
    Ok((4.0 * height / (2.0 * distance)).atan().to_degrees())
}

/// A floor of frozen grains without order, and a loose cone in its middle.
fn cone() -> Vec<Grain<3>> {
    let mut random = Random::new(4);
    let radius = |random: &mut Random| RADIUS * random.between(1.0 - SPREAD, 1.0 + SPREAD);
    let along = |index: u32, count: u32| f64::from(index) - 0.5 * f64::from(count - 1);
    let mut grains = Vec::new();
    for k in 0..FLOOR * FLOOR {
        let [x, y] = [k % FLOOR, k / FLOOR]
            .map(|index| along(index, FLOOR) * 2.0 * RADIUS + RADIUS * random.between(-0.5, 0.5));
        let radius = radius(&mut random);
        grains.push(Grain::at([x, y, -radius], radius).frozen());
    }
    let (layers, side) = ((CONE / SPACING) as u32, (2.0 * CONE / SPACING) as u32);
    for k in 0..side * side * layers {
        let [x, y] = [k % side, k / side % side].map(|index| along(index, side) * SPACING);
        let z = 1.3 + f64::from(k / (side * side)) * SPACING;
        if x.hypot(y) + z <= CONE {
            let at = [x, y, z].map(|at| (at + random.between(-0.02, 0.02)) * RADIUS);
            grains.push(Grain::at(at, radius(&mut random)));
        }
    }
    grains
}
