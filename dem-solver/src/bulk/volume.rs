//! The volume that grains fill up.

use crate::scene::Scene;
use crate::world::World;

/// Volume of the smallest box around all grains that can move, its sides along the axes; along a periodic axis it is
/// as long as the domain. 0 without such grains. In 2D it has the slab's depth \[m³\].
pub fn bulk_volume<const D: usize>(scene: &Scene<D>, world: &World<D>) -> f64 {
    let grains = &world.grains;
    if grains.motion.iter().all(|motion| motion.is_frozen()) {
        return 0.0;
    }
    let length = |axis: usize| {
        if scene.domain.periodic[axis] {
            return scene.domain.period(axis);
        }
        let moving = grains.place.iter().zip(&grains.motion).filter(|(_, motion)| !motion.is_frozen());
        let (lower, upper) = moving.fold((f64::INFINITY, f64::NEG_INFINITY), |(lower, upper), (place, _)| {
            let x = place.centre[axis];
            (lower.min(x - place.radius), upper.max(x + place.radius))
        });
        upper - lower
    };
    let depth = if D == 2 { scene.depth } else { 1.0 };
    (0..D).map(length).product::<f64>() * depth
}
