//! LIGGGHTS' resistance to rolling and cohesion against LIGGGHTS itself; parameters:
//! tests/reference/liggghts/SOURCE.md.
#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::liggghts::{deviation, hertz};
use crate::scenes::{floor, glass, run, world};
use dem_solver::contact::Extras;
use dem_solver::contact::cohesion::CohesionLaw;
use dem_solver::contact::rolling::RollingLaw;
use dem_solver::{Grain, Material, Materials, Motion, Scene};

const STEP: f64 = 1e-5;
const RADIUS: f64 = 1e-2;

/// The grains after the half kick that LIGGGHTS starts with where they touch; it does not keep the springs.
fn started(scene: &Scene<3>, grains: Vec<Grain<3>>) -> Vec<Grain<3>> {
    let mut kicked = world(scene, &grains);
    for (place, motion) in kicked.grains.place.iter_mut().zip(&kicked.grains.motion) {
        place.centre -= motion.velocity * (0.5 * STEP);
    }
    run(scene, &mut kicked, STEP, 1).unwrap();
    let half = |grain: Grain<3>, after: &Motion| Grain {
        velocity: (grain.velocity + after.velocity) / 2.0,
        angular_velocity: (grain.angular_velocity + after.angular_velocity) / 2.0,
        ..grain
    };
    grains.into_iter().zip(&kicked.grains.motion).map(|(grain, after)| half(grain, after)).collect()
}

/// Three spheres that roll along x at 0.3 m/s on the floor, μ_r 0.01, 0.05, 0.1.
fn rolling(law: RollingLaw) -> (Scene<3>, Vec<Grain<3>>) {
    let soft = Material { density: 2000.0, youngs_modulus: 1e7, poissons_ratio: 0.3 };
    let rigid = Material { youngs_modulus: 1e11, ..soft };
    let materials = Materials::new(vec![soft, soft, soft, rigid], |_, _| (0.5, 0.5)).with(|a, _, pair| {
        pair.rolling_friction = [0.01, 0.05, 0.1, 0.0][a];
        pair.rolling_damping_ratio = 0.3;
    });
    let extras = Extras { rolling: Some(law), ..Extras::default() };
    let mut scene = Scene::<3>::new(materials, hertz()).with_gravity([0.0, 0.0, -9.81]).with_walls(floor());
    scene = scene.with_extras(extras);
    scene.walls.materials[0] = 3;
    let grain = |k: u32| {
        let at = [-0.3, 0.05 * f64::from(k), 0.00998534699];
        let rolling = Grain::at(at, RADIUS).moving([0.3, 0.0, 0.0]).spinning([0.0, 0.3 / RADIUS, 0.0]);
        Grain { material: k, ..rolling }
    };
    (scene, (0..3).map(grain).collect())
}

#[test]
fn spheres_that_roll_are_braked_as_by_liggghts() {
    for (law, table) in [
        (RollingLaw::Cdt, include_str!("../reference/liggghts/rolling_cdt.csv")),
        (RollingLaw::Epsd, include_str!("../reference/liggghts/rolling_epsd.csv")),
        (RollingLaw::Epsd2, include_str!("../reference/liggghts/rolling_epsd2.csv")),
    ] {
        let (scene, grains) = rolling(law);
        let start = world(&scene, &started(&scene, grains));
        let (velocity, spin) = deviation(&scene, start, STEP, table);
        let (velocity, spin) = (velocity / 0.3, spin * RADIUS / 0.3);
        println!("{law:?}: {velocity:.1e} of the speed [1e-3], spin {spin:.1e} of v/r [1e-2]");
        assert!(velocity < 1e-8 && spin < 1e-8, "{law:?}: {velocity}, {spin}");
    }
}

fn cohesive(law: CohesionLaw, restitution: f64) -> Scene<3> {
    let materials = glass(restitution, 0.5).with(|_, _, pair| pair.cohesion_energy_density = 2e5);
    Scene::<3>::new(materials, hertz()).with_extras(Extras { cohesion: Some(law), ..Extras::default() })
}

#[test]
fn spheres_that_cohere_pull_as_hard_as_those_of_liggghts() {
    for (law, table) in [
        (CohesionLaw::Sjkr, include_str!("../reference/liggghts/force_sjkr.csv")),
        (CohesionLaw::Sjkr2, include_str!("../reference/liggghts/force_sjkr2.csv")),
    ] {
        let scene = cohesive(law, 1.0);
        let mut worst = 0.0_f64;
        for line in table.lines().skip(1) {
            let [distance, force] =
                line.split(',').map(|cell| cell.parse().unwrap()).collect::<Vec<f64>>()[..]
            else {
                panic!("two columns")
            };
            let at = |x: f64| Grain::at([x, 0.0, 0.0], 1e-3);
            let mut world = world(&scene, &[at(-0.5 * distance), at(0.5 * distance)]);
            run(&scene, &mut world, 1e-9, 1).unwrap();
            let found = -world.grains.motion[0].velocity.x / world.grains.motion[0].inverse_mass / 1e-9;
            worst = worst.max((found - force).abs());
        }
        println!("{law:?}: {worst:.1e} N of 2.1e-3 N");
        assert!(worst < 1e-11, "{law:?}: {worst} N");
    }
}

#[test]
fn slow_impacts_of_cohesive_spheres_stick_as_in_liggghts() {
    let scene = cohesive(CohesionLaw::Sjkr, 0.8);
    let mut grains = Vec::new();
    for (k, speed) in [0.02, 0.05, 0.1, 0.2, 0.5].into_iter().enumerate() {
        let y = 0.01 * k as f64;
        grains.push(Grain::at([-1.01e-3, y, 0.0], 1e-3).moving([0.5 * speed, 0.0, 0.0]));
        grains.push(Grain::at([1.01e-3, y, 0.0], 1e-3).moving([-0.5 * speed, 0.0, 0.0]));
    }
    let table = include_str!("../reference/liggghts/collisions_sjkr.csv");
    let (velocity, _) = deviation(&scene, world(&scene, &grains), 2e-7, table);
    println!("sjkr, impacts: {velocity:.1e} m/s of 0.02 to 0.5 m/s");
    // All start a whole number of substeps apart: rounding decides in which they touch first, and a dashpot ∝ δ^(1/4)
    // makes 1e-7 m/s of it. In LIGGGHTS' order of additions the same formulas agree to 5e-11 m/s.
    assert!(velocity < 2e-7, "{velocity} m/s");
}
