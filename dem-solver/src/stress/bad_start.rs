//! Starts that are extreme, empty or wrong.

use super::finding::Finding;
use super::runner::Runner;
use super::{Effort, laws};
use crate::domain::Domain;
use crate::error::DemError;
use crate::grains::Grain;

const RADIUS: f64 = 1e-3;
/// Fractions f of the critical step, and the error (ω Δt)²/4 of the energy that a spring of slope k gives back:
/// ω² = 2 k/m, and 2/Δt² of the critical step is 7/2 k_t/m, k_t = 0.82 k for ν = 0.3, so that it is f²/2.9.
const RELEASE: [(f64, f64); 2] = [(0.5, 0.1), (0.05, 0.001)];

/// Overlaps at the start; what cannot be computed; one grain, and none.
pub fn findings(_: Effort) -> Vec<Finding> {
    let mut findings = Vec::new();
    for overlap in [0.01, 0.1, 0.5] {
        for (fraction, error) in RELEASE {
            let what = format!("overlap by {overlap} of a diameter, {fraction} of the critical step");
            let (name, found) = ("kinetic energy over that stored", released(overlap, fraction));
            findings.push(Finding::number(what, name, found, 1.0 - error..=1.0 + error));
        }
    }
    let sunk = [Grain::at([0.0; 3], RADIUS), Grain::at([0.2 * RADIUS, 0.0, 0.0], RADIUS)];
    findings.push(Finding::refusal(
        "overlap by 0.9 of a diameter",
        start(&sunk),
        "its centre is inside grain",
    ));
    let twins = [Grain::at([0.0; 3], RADIUS), Grain::at([0.0; 3], RADIUS)];
    findings.push(Finding::refusal("two grains with one centre", start(&twins), "centres coincide"));
    for bad in [f64::NAN, f64::INFINITY] {
        let alone = Grain::at([1.0, 0.0, 0.0], RADIUS);
        let nowhere = [alone, Grain::at([bad, 0.0, 0.0], RADIUS)];
        let wild = [alone, Grain::at([0.0; 3], RADIUS).moving([bad, 0.0, 0.0])];
        let whirling = [alone, Grain::at([0.0; 3], RADIUS).spinning([0.0, bad, 0.0])];
        for (name, grains) in [("centre", nowhere), ("velocity", wild), ("spin", whirling)] {
            let what = format!("a grain whose {name} is {bad}");
            findings.push(Finding::refusal(what, start(&grains), "not finite"));
        }
    }
    let outside = Runner::new(
        laws::spheres(laws::own()[0].1, &[1e7], 0.5, 0.5).in_domain(Domain::new([-1.0; 3], [1.0; 3])),
        &[Grain::at([2.0, 0.0, 0.0], RADIUS)],
    );
    findings.push(Finding::refusal("a grain outside the domain", begin(outside), "left the domain"));
    findings.push(Finding::number("one grain that falls for 1 s", "error of its fall", fall(), 0.0..=1e-12));
    let mut none = Runner::new(laws::spheres(laws::own()[0].1, &[1e7], 0.5, 0.5), &[]);
    let time = none.window(1.0, 10).map(|()| none.world.time);
    findings.push(Finding::number("no grain for 1 s", "time in s", time, 1.0..=1.0));
    findings
}

fn start(grains: &[Grain<3>]) -> Result<Runner, DemError> {
    begin(Runner::new(laws::spheres(laws::own()[0].1, &[1e7], 0.5, 0.5), grains))
}

fn begin(mut runner: Runner) -> Result<Runner, DemError> {
    runner.begin()?;
    Ok(runner)
}

/// Of two grains without damping.
fn released(overlap: f64, fraction: f64) -> Result<f64, DemError> {
    let scene = laws::spheres(laws::own()[0].1, &[1e7], 1.0, 0.5);
    let distance = 2.0 * RADIUS * (1.0 - overlap);
    let grains = [Grain::at([0.0; 3], RADIUS), Grain::at([distance, 0.0, 0.0], RADIUS)];
    let mut runner = begin(Runner::new(scene, &grains))?;
    let stored = runner.energy();
    let apart = |runner: &Runner| {
        let [one, other] = [0, 1].map(|row| runner.world.grains.place[row].centre);
        (one - other).norm() > 2.0 * RADIUS
    };
    while !apart(&runner) {
        runner.steps(20, fraction)?;
    }
    Ok(runner.kinetic_energy() / stored)
}

/// |z + g t²/2|/(g t²/2).
fn fall() -> Result<f64, DemError> {
    let scene = laws::spheres(laws::own()[0].1, &[1e7], 0.5, 0.5).with_gravity([0.0, 0.0, -9.81]);
    let mut runner = Runner::new(scene, &[Grain::at([0.0; 3], RADIUS)]);
    runner.window(1.0, 1000)?;
    Ok((runner.world.grains.place[0].centre.z / (-0.5 * 9.81) - 1.0).abs())
}
