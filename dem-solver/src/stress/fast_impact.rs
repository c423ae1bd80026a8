//! Impacts at 100 m/s: the restitution is met, or the run stops because the contact is too soft to bear them.

use super::finding::Finding;
use super::runner::Runner;
use super::{Effort, impact, laws};
use crate::contact::NormalLaw;
use crate::error::DemError;
use crate::grains::Grain;
use crate::scene::Scene;
use crate::wall::{Facet, Wall, Walls};

const SPEED: f64 = 100.0;
const RADIUS: f64 = 1e-3;
const RESTITUTION: f64 = 0.5;
/// Fractions of the critical step, and the allowed error of the restitution: such an impact is over in few steps.
const PRECISION: [(f64, f64); 2] = [(0.5, 0.01), (0.05, 0.001)];

/// Between grains and on walls, of glass and of a stuff as soft as simulations make it.
pub fn findings(_: Effort) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (name, law) in laws::own() {
        for (stuff, youngs_modulus) in [("70 GPa", 7e10), ("100 MPa", 1e8)] {
            // As deep as Hertz's contact at 1 m/s, it would be more than two radii deep at 100 m/s.
            let too_soft = matches!(law, NormalLaw::Hooke(_)) && youngs_modulus < 1e9;
            for (fraction, error) in PRECISION {
                let scene = laws::spheres(law, &[youngs_modulus], RESTITUTION, 0.0);
                let on = |walls: Walls<3>| rebound(scene.clone().with_walls(walls), fraction);
                let outcomes = [
                    ("two grains", impact::restitution(scene.clone(), (RADIUS, RADIUS), SPEED, fraction)),
                    ("on a plane", on(plane())),
                    ("on a triangle", on(triangle())),
                ];
                findings.extend(outcomes.map(|(meets, found)| {
                    let what = format!("{name}, {stuff}, {meets}, {fraction} of the critical step");
                    if too_soft {
                        return Finding::refusal(what, found, "at most 1 is a contact");
                    }
                    Finding::number(what, "restitution", found, RESTITUTION - error..=RESTITUTION + error)
                }));
            }
        }
    }
    findings
}

fn plane() -> Walls<3> {
    Walls::new(vec![Wall::plane("plate", 0, [0.0; 3], [0.0, 0.0, 1.0])])
}

fn triangle() -> Walls<3> {
    Walls::new(vec![Wall::facets(
        "plate",
        0,
        vec![Facet::new([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]])],
    )])
}

fn rebound(scene: Scene<3>, fraction: f64) -> Result<f64, DemError> {
    let grain = Grain::at([0.0, 0.0, 1.01 * RADIUS], RADIUS).moving([0.0, 0.0, -SPEED]);
    let mut runner = Runner::new(scene, &[grain]);
    runner.begin()?;
    let mut step = f64::INFINITY;
    loop {
        let (height, velocity) =
            (runner.world.grains.place[0].centre.z, runner.world.grains.motion[0].velocity.z);
        if height > RADIUS && velocity > 0.0 {
            return Ok(velocity / SPEED);
        }
        // A step that grew while the grain turns round would cost restitution.
        step = step.min(fraction * runner.critical());
        runner.window(20.0 * step, 20)?;
    }
}
