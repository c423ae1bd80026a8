//! A head-on impact.

use super::runner::Runner;
use crate::error::DemError;
use crate::grains::Grain;
use crate::scene::Scene;

/// Contacts that last longer than this many steps have not ended.
const MOST_STEPS: u32 = 10_000_000;

/// Restitution of two grains of these radii \[m\], the second of the scene's last material, that meet with this speed
/// \[m/s\], at this fraction of the least critical step so far.
pub fn restitution(scene: Scene<3>, radii: (f64, f64), speed: f64, fraction: f64) -> Result<f64, DemError> {
    let reach = radii.0 + radii.1;
    let material = scene.materials.len() as u32 - 1;
    let gap = 0.01 * radii.0.min(radii.1);
    let grains = [
        Grain::at([0.0; 3], radii.0).moving([speed, 0.0, 0.0]),
        Grain { material, ..Grain::at([reach + gap, 0.0, 0.0], radii.1) },
    ];
    let mut runner = Runner::new(scene, &grains);
    runner.begin()?;
    let (mut steps, mut step) = (0, f64::INFINITY);
    loop {
        let grains = &runner.world.grains;
        let row = |id: u64| grains.id.iter().position(|&other| other == id).unwrap_or_default();
        let (one, other) = (row(0), row(1));
        let distance = grains.place[other].centre.x - grains.place[one].centre.x;
        let parting = grains.motion[other].velocity.x - grains.motion[one].velocity.x;
        if (distance > reach && parting > 0.0) || steps > MOST_STEPS {
            return Ok(parting / speed);
        }
        step = step.min(fraction * runner.critical());
        runner.window(20.0 * step, 20)?;
        steps += 20;
    }
}
