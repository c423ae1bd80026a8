//! The critical time step, where all grains touch all neighbours.

use super::finding::Finding;
use super::runner::Runner;
use super::{Effort, laws};
use crate::contact::NormalLaw;
use crate::critical_time_step::{Substep, critical_time_step, substeps};
use crate::domain::Domain;
use crate::error::DemError;
use crate::grains::Grain;
use crate::insertion::Random;
use crate::wall::{Wall, Walls};

const RADIUS: f64 = 1e-3;
/// Grains along each side of the packing.
const SIDE: usize = 5;
/// Overlap of all neighbours, relative to the radius.
const OVERLAP: f64 = 0.02;
/// Largest speed at the start \[m/s\].
const SPEED: f64 = 0.02;
const STEPS: u32 = 2000;
/// Energy at the end over that at the start: no more than round-off above 1.
const MOST_ENERGY: f64 = 1.0 + 1e-9;

/// Stable at 0.9 of the critical step, refused at 1.1; how far the critical step could go.
pub fn findings(_: Effort) -> Vec<Finding> {
    let with_law = |(name, law)| {
        [
            Finding::number(
                format!("{name}, 0.9 of the critical step, {STEPS} steps"),
                "energy over that at the start",
                energy_after(law, STEPS, 0.9),
                0.0..=MOST_ENERGY,
            ),
            Finding::refusal(format!("{name}, 1.1 of it"), refused(law), "above the critical step"),
            Finding::number(
                format!("{name}, the longest step that gains no energy"),
                "fraction of the critical step",
                longest_stable(law),
                1.0..=f64::INFINITY,
            ),
        ]
    };
    laws::all().into_iter().flat_map(with_law).collect()
}

/// A cubic packing between two plates, periodic across, squeezed and stirred.
fn packing(law: NormalLaw) -> Result<Runner, DemError> {
    let spacing = (2.0 - OVERLAP) * RADIUS;
    let length = SIDE as f64 * spacing;
    let plates = Walls::new(vec![
        Wall::plane("floor", 0, [0.0; 3], [0.0, 0.0, 1.0]),
        Wall::plane("lid", 0, [0.0, 0.0, length], [0.0, 0.0, -1.0]),
    ]);
    let domain = Domain::new([0.0; 3], [length; 3]).periodic([true, true, false]);
    let scene = laws::spheres(law, &[1e7], 0.9, 0.5).in_domain(domain).with_walls(plates);
    let mut random = Random::new(1);
    let grains: Vec<_> = (0..SIDE.pow(3))
        .map(|k| {
            let at = [0, 1, 2].map(|axis| ((k / SIDE.pow(axis) % SIDE) as f64 + 0.5) * spacing);
            Grain::at(at, RADIUS).moving([(); 3].map(|()| random.between(-SPEED, SPEED)))
        })
        .collect();
    let mut runner = Runner::new(scene, &grains);
    runner.begin()?;
    Ok(runner)
}

fn energy_after(law: NormalLaw, steps: u32, fraction: f64) -> Result<f64, DemError> {
    let mut packing = packing(law)?;
    let start = packing.energy();
    for _ in 0..steps / 20 {
        packing.steps(20, fraction)?;
    }
    Ok(packing.energy() / start)
}

fn refused(law: NormalLaw) -> Result<u32, DemError> {
    let Runner { scene, world, .. } = packing(law)?;
    let critical = critical_time_step(&scene, &world);
    substeps(100.0 * critical.step, Substep::Given(1.1 * critical.step), &critical)
}

/// In steps of a tenth up to 4.
fn longest_stable(law: NormalLaw) -> Result<f64, DemError> {
    let mut longest = 0.0;
    for tenths in 9..=40 {
        let fraction = f64::from(tenths) / 10.0;
        // That the run ends in a fault is instability, too.
        if !energy_after(law, STEPS / 4, fraction).is_ok_and(|energy| energy <= MOST_ENERGY) {
            break;
        }
        longest = fraction;
    }
    Ok(longest)
}
