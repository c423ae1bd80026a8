//! The laws of LIGGGHTS against LIGGGHTS itself; parameters: tests/reference/liggghts/SOURCE.md.
#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use std::f64::consts::PI;

use crate::scenes::{floor, run, world};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::{LiggghtsHertz, LiggghtsHooke};
use dem_solver::{Grain, Material, Materials, PairMaterial, Scene, Spin, Vector, World, volume};

/// A velocity and a spin that LIGGGHTS found for a grain at a time.
pub struct Sample {
    pub time: f64,
    pub grain: usize,
    pub velocity: Vector<3>,
    pub spin: Spin,
}

pub fn samples(table: &str) -> Vec<Sample> {
    let sample = |line: &str| {
        let row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        let three = |first: usize| Vector::from([row[first], row[first + 1], row[first + 2]]);
        Sample { time: row[0], grain: row[1] as usize - 1, velocity: three(2), spin: three(5) }
    };
    table.lines().skip(1).map(sample).collect()
}

/// Largest deviation of velocity \[m/s\] and of spin \[rad/s\] from the samples.
///
/// Both programs kick at x(k h) from v((k - 1/2) h) to v((k + 1/2) h), h the step; a window of one substep is one
/// kick with half a flight before and behind. LIGGGHTS reports v(k h), the mean of the two.
pub fn deviation(scene: &Scene<3>, mut world: World<3>, step: f64, table: &str) -> (f64, f64) {
    for k in 0..world.grains.len() {
        let half_a_flight = world.grains.motion[k].velocity * (0.5 * step);
        world.grains.place[k].centre += half_a_flight;
    }
    let (mut of_velocity, mut of_spin, mut kicks) = (0.0_f64, 0.0_f64, 0);
    let mut before = world.grains.motion.clone();
    for sample in samples(table) {
        while kicks < (sample.time / step).round() as u32 {
            before.clone_from(&world.grains.motion);
            run(scene, &mut world, step, 1).unwrap();
            kicks += 1;
        }
        let (then, now) = (&before[sample.grain], &world.grains.motion[sample.grain]);
        of_velocity = of_velocity.max(((then.velocity + now.velocity) / 2.0 - sample.velocity).norm());
        of_spin = of_spin.max(((then.angular_velocity + now.angular_velocity) / 2.0 - sample.spin).norm());
    }
    assert!(kicks > 500, "the table is not of this step");
    (of_velocity, of_spin)
}

pub fn hertz() -> NormalLaw {
    NormalLaw::LiggghtsHertz(LiggghtsHertz)
}

fn hooke(characteristic_velocity: f64) -> NormalLaw {
    NormalLaw::LiggghtsHooke(LiggghtsHooke { characteristic_velocity })
}

/// Duration of an elastic impact at `speed`, 2.87 (m*²/(R* E*² V))^(1/5).
fn hertz_time(pair: &PairMaterial, radius: f64, mass: f64, speed: f64) -> f64 {
    2.87 * (mass * mass / (radius * pair.effective_modulus.powi(2) * speed)).powf(0.2)
}

#[test]
fn spheres_that_meet_head_on_agree_to_the_digits_stored() {
    let (radius, soft) = (5e-3, Material { density: 2500.0, youngs_modulus: 1e7, poissons_ratio: 0.3 });
    let tables = [
        (hertz(), 1.0, include_str!("../reference/liggghts/pair_hertz_e10.csv")),
        (hertz(), 0.7, include_str!("../reference/liggghts/pair_hertz_e07.csv")),
        (hertz(), 0.3, include_str!("../reference/liggghts/pair_hertz_e03.csv")),
        (hooke(1.0), 1.0, include_str!("../reference/liggghts/pair_hooke_e10.csv")),
        (hooke(1.0), 0.7, include_str!("../reference/liggghts/pair_hooke_e07.csv")),
        (hooke(1.0), 0.3, include_str!("../reference/liggghts/pair_hooke_e03.csv")),
    ];
    for (law, restitution, table) in tables {
        let scene = Scene::<3>::new(Materials::new(vec![soft], |_, _| (restitution, 0.5)), law);
        let mass = 0.5 * soft.density * volume::<3>(radius, 1.0);
        let step = if law == hertz() {
            hertz_time(scene.materials.pair(0, 0), 0.5 * radius, mass, 1.0) / 400.0
        } else {
            let stiffness = scene.coefficients((0, 0), 0.5 * radius, mass).unwrap().normal_stiffness;
            1.2 * PI * (mass / stiffness).sqrt() / 400.0
        };
        let x = 1.01 * radius;
        let grains = [
            Grain::at([-x, 0.0, 0.0], radius).moving([0.5, 0.0, 0.0]),
            Grain::at([x, 0.0, 0.0], radius).moving([-0.5, 0.0, 0.0]),
        ];
        let (velocity, _) = deviation(&scene, world(&scene, &grains), step, table);
        println!("{law:?}, e {restitution}: {velocity:.1e} of the impact speed [1e-6]");
        assert!(velocity < 1e-8, "{law:?}, e = {restitution}: {velocity}");
    }
}

#[test]
fn spheres_that_hit_a_plane_obliquely_agree_to_the_digits_stored() {
    let (radius, speed) = (3e-3, 2.0);
    let steel = Material { density: 7800.0, youngs_modulus: 2e9, poissons_ratio: 0.28 };
    let rigid = Material { youngs_modulus: 2e13, ..steel };
    let tables = [
        (hertz(), include_str!("../reference/liggghts/oblique_wall_hertz.csv")),
        (hooke(speed), include_str!("../reference/liggghts/oblique_wall_hooke.csv")),
    ];
    for (law, table) in tables {
        let mut scene =
            Scene::<3>::new(Materials::new(vec![steel, rigid], |_, _| (0.8, 0.25)), law).with_walls(floor());
        scene.walls.materials[0] = 1;
        let unyielding = PairMaterial {
            effective_modulus: steel.youngs_modulus / (1.0 - steel.poissons_ratio.powi(2)),
            ..*scene.materials.pair(0, 1)
        };
        let mass = steel.density * volume::<3>(radius, 1.0);
        let step = hertz_time(&unyielding, radius, mass, speed) / 500.0;
        let mut grains = Vec::new();
        for (k, degrees) in
            [2.0_f64, 5.0, 10.0, 15.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0].iter().enumerate()
        {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let at = [0.0, 0.02 * k as f64, 1.02 * radius];
            grains.push(Grain::at(at, radius).moving([speed * sin, 0.0, -speed * cos]));
        }
        let (velocity, spin) = deviation(&scene, world(&scene, &grains), step, table);
        let (velocity, spin) = (velocity / speed, spin * radius / speed);
        println!("{law:?}, plane: {velocity:.1e} of the impact speed [1e-3], spin {spin:.1e} of v/r [1e-2]");
        assert!(velocity < 1e-8 && spin < 1e-8, "{law:?}: {velocity}, {spin}");
    }
}

#[test]
fn spheres_that_hit_each_other_obliquely_and_spinning_agree_to_the_digits_stored() {
    let (radius, speed) = (4e-3_f64, 2.0);
    let material = Material { density: 2600.0, youngs_modulus: 5e7, poissons_ratio: 0.25 };
    let tables = [
        (hertz(), include_str!("../reference/liggghts/oblique_pair_hertz.csv")),
        (hooke(speed), include_str!("../reference/liggghts/oblique_pair_hooke.csv")),
    ];
    let offset_and_spin = [
        (0.0, 0.0),
        (0.3, 0.0),
        (0.6, 0.0),
        (0.9, 0.0),
        (1.2, 0.0),
        (0.5, 150.0),
        (0.5, -150.0),
        (1.0, 60.0),
    ];
    let mut grains = Vec::new();
    for (k, (offset, spin)) in offset_and_spin.into_iter().enumerate() {
        let (b, y) = (offset * radius, 0.03 * k as f64);
        // The first pair is 100 substeps apart to rounding; as in LIGGGHTS the 100th is not yet a touch.
        let x = 0.5 * ((2.01 * radius).powi(2) - b * b).sqrt() + if k == 0 { 1e-15 } else { 0.0 };
        let second = if k == 7 { [40.0, 0.0, spin] } else { [0.0, 0.0, 0.5 * spin] };
        grains.push(
            Grain::at([-x, y - 0.5 * b, 0.0], radius).moving([1.0, 0.0, 0.0]).spinning([0.0, 0.0, spin]),
        );
        grains.push(Grain::at([x, y + 0.5 * b, 0.0], radius).moving([-1.0, 0.0, 0.0]).spinning(second));
    }
    for (law, table) in tables {
        let scene = Scene::<3>::new(Materials::new(vec![material], |_, _| (0.75, 0.35)), law);
        let (velocity, spin) = deviation(&scene, world(&scene, &grains), 2e-7, table);
        let (velocity, spin) = (velocity / speed, spin * radius / speed);
        println!("{law:?}, pair: {velocity:.1e} of the impact speed [1e-3], spin {spin:.1e} of v/r [1e-2]");
        assert!(velocity < 1e-8 && spin < 1e-8, "{law:?}: {velocity}, {spin}");
    }
}

#[test]
fn a_sphere_that_starts_to_roll_ends_up_at_the_same_speed() {
    let (radius, soft) = (1e-2, Material { density: 2000.0, youngs_modulus: 1e7, poissons_ratio: 0.3 });
    let rigid = Material { youngs_modulus: 1e11, ..soft };
    let materials = Materials::new(vec![soft, soft, soft, rigid], |a, b| match (a, b) {
        (0, 3) => (0.5, 0.1),
        (1, 3) => (0.5, 0.3),
        (2, 3) => (0.5, 0.6),
        _ => (0.5, 0.0),
    });
    let weight = soft.density * volume::<3>(radius, 1.0) * 9.81;
    let modulus = soft.youngs_modulus / (1.0 - soft.poissons_ratio.powi(2));
    let overlap = (0.75 * weight / (modulus * radius.sqrt())).powf(2.0 / 3.0);
    let mut scene = Scene::<3>::new(materials, hertz()).with_gravity([0.0, 0.0, -9.81]).with_walls(floor());
    scene.walls.materials[0] = 3;
    let grains: Vec<_> = (0..3)
        .map(|k| {
            let at = [-0.4, 0.05 * f64::from(k), radius - overlap];
            Grain { material: k, ..Grain::at(at, radius).moving([1.0, 0.0, 0.0]) }
        })
        .collect();
    let mut world = world(&scene, &grains);
    run(&scene, &mut world, 0.45, 45_000).unwrap();
    for sample in samples(include_str!("../reference/liggghts/slip_to_roll_hertz.csv")) {
        let motion = &world.grains.motion[sample.grain];
        let velocity = (motion.velocity - sample.velocity).norm();
        let spin = (motion.angular_velocity - sample.spin).norm() * radius;
        println!("slip to roll: {velocity:.1e} of the speed [1e-3], spin {spin:.1e} of v/r [1e-2]");
        assert!(velocity < 1e-5 && spin < 1e-5, "{velocity}, {spin}");
    }
}
