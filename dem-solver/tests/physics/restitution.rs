//! What the own laws promise, whatever the substep and wherever in it a contact begins.
#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::scenes::{floor, glass, hertz, hooke, kinetic_energy, onate, partial_slip, run, world};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::{LiggghtsHertz, LiggghtsHooke};
use dem_solver::{Grain, Scene, Substep, World, critical_time_step, substeps};

/// Phases of a substep at which contacts begin.
const PHASES: u32 = 24;

const RADIUS: f64 = 1e-3;

/// The substep of a run that does not state one.
fn usual_step(scene: &Scene<3>, world: &World<3>) -> f64 {
    let critical = critical_time_step(scene, world);
    1.0 / f64::from(substeps(1.0, Substep::Fraction(0.5), &critical).unwrap())
}

/// The substep that a Hertz contact at 1 m/s with the floor takes 30 of.
fn thirtieth(scene: &Scene<3>, world: &World<3>) -> f64 {
    let mass = world.grains.mass[0];
    let modulus = scene.materials.pair(0, 0).effective_modulus;
    2.87 * (mass * mass / (RADIUS * modulus * modulus)).powf(0.2) / 30.0
}

/// A sphere that hits the floor at 1 m/s, `degrees` from its normal, when the phase of a substep has gone by.
fn throw(scene: &Scene<3>, degrees: f64, phase: f64, step: f64) -> World<3> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let height = RADIUS + cos * step * (1.0 + phase);
    world(scene, &[Grain::at([0.0, 0.0, height], RADIUS).moving([sin, 0.0, -cos])])
}

/// Moves the world until the sphere is off the floor again.
fn bounce(scene: &Scene<3>, world: &mut World<3>, step: f64) {
    for _ in 0..100 {
        run(scene, world, 20.0 * step, 20).unwrap();
        if world.grains.motion[0].velocity.z > 0.0 && world.grains.place[0].centre.z > RADIUS {
            return;
        }
    }
    panic!("the sphere did not come back");
}

fn own_laws_at_their_steps(e: f64, friction: f64) -> [(Scene<3>, f64); 4] {
    [hertz(), hooke(), onate(), partial_slip()].map(|law| {
        let scene = Scene::<3>::new(glass(e, friction), law).with_walls(floor());
        let sphere = world(&scene, &[Grain::at([0.0, 0.0, 1.0], RADIUS)]);
        let grows = law == hertz() || law == partial_slip();
        let step = if grows { thirtieth(&scene, &sphere) } else { usual_step(&scene, &sphere) };
        (scene, step)
    })
}

#[test]
fn restitution_is_the_stated_one_to_a_thousandth_wherever_in_a_substep_the_contact_begins() {
    let (mut worst, mut usual) = ([0.0_f64; 4], 0.0_f64);
    for e in [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 1.0] {
        for phase in 0..PHASES {
            let phase = (f64::from(phase) + 0.5) / f64::from(PHASES);
            let laws = own_laws_at_their_steps(e, 0.0);
            for ((scene, step), worst) in laws.iter().zip(&mut worst) {
                let mut world = throw(scene, 0.0, phase, *step);
                bounce(scene, &mut world, *step);
                *worst = worst.max((world.grains.motion[0].velocity.z - e).abs());
            }
            let scene = &laws[0].0;
            let step = usual_step(scene, &throw(scene, 0.0, phase, 1e-6));
            let mut world = throw(scene, 0.0, phase, step);
            bounce(scene, &mut world, step);
            usual = usual.max((world.grains.motion[0].velocity.z - e).abs());
        }
    }
    let [hertz, hooke, onate, _] = worst;
    println!(
        "restitution: hertz, 30 substeps {hertz:.1e}, hooke and onate, 36 substeps {hooke:.1e}, {onate:.1e} [1e-3]"
    );
    println!("restitution: hertz, usual substep of soft glass {usual:.1e}");
    assert!(worst.iter().all(|worst| *worst < 1e-3), "{worst:?}");
}

#[test]
fn a_sphere_that_slides_all_along_leaves_with_the_surface_speed_of_coulombs_limit() {
    let mut worst = 0.0_f64;
    for e in [0.1, 0.3, 0.5, 0.7, 0.9, 1.0] {
        for friction in [0.1, 0.3, 0.5] {
            // v_t/v_n twice that at which the sliding would end.
            let ratio = 7.0 * friction * (1.0 + e);
            for (scene, step) in own_laws_at_their_steps(e, friction) {
                for phase in 0..4 {
                    let degrees = ratio.atan().to_degrees();
                    let mut world = throw(&scene, degrees, (f64::from(phase) + 0.5) / 4.0, step);
                    let tangential = world.grains.motion[0].velocity.x;
                    bounce(&scene, &mut world, step);
                    let motion = &world.grains.motion[0];
                    let surface = (motion.velocity.x - motion.angular_velocity.y * RADIUS) / tangential;
                    let limit = 1.0 - 3.5 * friction * (1.0 + e) / ratio;
                    worst = worst.max((surface - limit).abs());
                }
            }
        }
    }
    println!("sliding limit: {worst:.1e} [1e-3]");
    assert!(worst < 1e-3, "{worst}");
}

#[test]
fn no_incidence_from_0_to_89_degrees_gains_energy() {
    let mut largest = f64::NEG_INFINITY;
    for e in [0.1, 0.9, 0.999, 1.0] {
        for friction in [0.1, 0.5, 1.0] {
            for (scene, step) in own_laws_at_their_steps(e, friction) {
                for degrees in 0..90 {
                    for phase in 0..4 {
                        let phase = (f64::from(phase) + 0.5) / 4.0;
                        let mut world = throw(&scene, f64::from(degrees), phase, step);
                        let before = kinetic_energy(&world);
                        bounce(&scene, &mut world, step);
                        largest = largest.max(kinetic_energy(&world) / before - 1.0);
                    }
                }
            }
        }
    }
    println!("energy gained at 0 to 89°: {largest:.1e} [none]");
    assert!(largest < 1e-12, "{largest}");
}

/// Largest loss of speed of a sphere that leaves the floor in one substep, and its speed in the end.
fn pull(law: NormalLaw, e: f64) -> (f64, f64) {
    let scene = Scene::<3>::new(glass(e, 0.0), law).with_walls(floor());
    let step = usual_step(&scene, &throw(&scene, 0.0, 0.0, 1e-6));
    let mut world = throw(&scene, 0.0, 0.3, step);
    let (mut speed, mut pulled) = (-1.0, 0.0_f64);
    for _ in 0..300 {
        run(&scene, &mut world, step, 1).unwrap();
        let now = world.grains.motion[0].velocity.z;
        pulled = pulled.max(speed - now);
        speed = now;
    }
    (pulled, speed)
}

#[test]
fn no_contact_pulls_but_those_of_liggghts() {
    for e in [0.1, 0.5, 0.9, 1.0] {
        for law in [hertz(), hooke(), onate(), partial_slip()] {
            assert_eq!(pull(law, e).0, 0.0, "{law:?}, e = {e}");
        }
    }
    let hooke = NormalLaw::LiggghtsHooke(LiggghtsHooke { characteristic_velocity: 1.0 });
    for law in [NormalLaw::LiggghtsHertz(LiggghtsHertz), hooke] {
        let (pulled, speed) = pull(law, 0.5);
        assert!(pulled > 1e-3 && (speed - 0.5).abs() < 0.02, "{law:?}: {pulled}, {speed}");
    }
}
