//! Liquid that is squeezed out from between grains.
#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use std::f64::consts::PI;

use crate::scenes::{GLASS, floor, gas, glass, hertz, kinetic_energy, run, world};
use dem_solver::contact::Extras;
use dem_solver::contact::lubrication::Lubrication;
use dem_solver::wall::{Facet, Shape, Wall, Walls};
use dem_solver::{Grain, Scene, Vector, World};

const RADIUS: f64 = 1e-3;
const VISCOSITY: f64 = 1e-3;

fn wet(restitution: f64, roughness: f64, cut_off: f64) -> Scene<3> {
    let film = Lubrication { viscosity: VISCOSITY, roughness, cut_off };
    let extras = Extras { lubrication: Some(film), ..Extras::default() };
    Scene::<3>::new(glass(restitution, 0.5), hertz()).with_extras(extras)
}

fn mass() -> f64 {
    GLASS.density * dem_solver::volume::<3>(RADIUS, 1.0)
}

/// A sphere this far above the floor.
fn above(gap: f64) -> Grain<3> {
    Grain::at([0.0, 0.0, RADIUS + gap], RADIUS)
}

#[test]
fn a_sphere_nears_a_wall_and_another_sphere_as_lubrication_theory_has_it() {
    let (speed, start) = (0.01, 1e-4);
    let on_wall = wet(1.0, 1e-7, 2e-4).with_walls(floor());
    let among_spheres = wet(1.0, 1e-7, 2e-4);
    let falling = above(start).moving([0.02, 0.0, -speed]).spinning([0.0, 7.0, 3.0]);
    let half = |sign: f64| {
        let at = sign * (RADIUS + 0.5 * start);
        Grain::at([at, 0.0, 0.0], RADIUS).moving([-0.5 * sign * speed, 0.02, 0.0])
    };
    // Gap, and how fast it closes.
    let of_sphere =
        |world: &World<3>| (world.grains.place[0].centre.z - RADIUS, -world.grains.motion[0].velocity.z);
    let of_pair = |world: &World<3>| {
        let (place, motion) = (&world.grains.place, &world.grains.motion);
        (place[1].centre.x - place[0].centre.x - 2.0 * RADIUS, motion[0].velocity.x - motion[1].velocity.x)
    };
    type Measure = fn(&World<3>) -> (f64, f64);
    let cases: [(&str, Scene<3>, Vec<Grain<3>>, Measure, f64); 2] = [
        ("wall", on_wall, vec![falling], of_sphere, 6.0 * PI * VISCOSITY * RADIUS.powi(2) / mass()),
        (
            "sphere",
            among_spheres,
            vec![half(-1.0), half(1.0)],
            of_pair,
            6.0 * PI * VISCOSITY * (0.5 * RADIUS).powi(2) / (0.5 * mass()),
        ),
    ];
    for (name, scene, grains, gap_and_speed, slowing) in cases {
        let mut world = world(&scene, &grains);
        let mut worst = 0.0_f64;
        for _ in 0..200 {
            run(&scene, &mut world, 1e-4, 20).unwrap();
            let (gap, closing) = gap_and_speed(&world);
            if gap < 2e-6 {
                break;
            }
            let exact = speed - slowing * (start / gap).ln();
            worst = worst.max((closing - exact).abs() / speed);
        }
        println!("{name}: speed off by {worst:.1e} of the first");
        assert!(gap_and_speed(&world).0 < 1e-5, "{name}: it has come near");
        assert!(worst < 1e-3, "{name}: {worst}");
        let motion = &world.grains.motion[0];
        let along = if name == "wall" { motion.velocity.x } else { motion.velocity.y };
        assert_eq!(along, 0.02, "{name}: nothing rubs");
        assert_eq!(motion.angular_velocity, grains[0].angular_velocity);
    }
}

#[test]
fn wet_restitution_falls_with_the_stokes_number_to_nothing_at_the_critical_one() {
    let (dry, roughness, cut_off) = (0.7, 1e-5, 2e-4_f64);
    let slowing = 6.0 * PI * VISCOSITY * RADIUS.powi(2) / mass();
    let critical = (1.0 + 1.0 / dry) * (1.0 + (cut_off / roughness).ln());
    let mut worst = 0.0_f64;
    for share in [0.3, 0.6, 0.9, 1.1, 1.5, 3.0, 10.0] {
        let scene = wet(dry, roughness, cut_off).with_walls(floor());
        let speed = share * critical * slowing;
        let mut ball = world(&scene, &[above(1.01 * cut_off).moving([0.0, 0.0, -speed])]);
        run(&scene, &mut ball, 40.0 * cut_off / speed, 160_000).unwrap();
        let (place, motion) = (&ball.grains.place[0], &ball.grains.motion[0]);
        let found = motion.velocity.z / speed;
        let expected = dry * (1.0 - 1.0 / share);
        if share < 1.0 {
            assert!(place.centre.z < RADIUS + cut_off && found < 1e-3, "St/St_c = {share}: {found}");
        } else {
            println!("St/St_c = {share}: restitution {found}, {expected} expected");
            assert!(place.centre.z > RADIUS + cut_off, "St/St_c = {share}: it has left the film");
            worst = worst.max((found - expected).abs());
        }
    }
    println!("restitution off by {worst:.1e}");
    assert!(worst < 1e-3, "{worst}");
}

#[test]
fn no_viscosity_and_no_step_makes_energy() {
    for viscosity in [1e-3, 1.0, 1e6] {
        let (mut scene, mut grains) = gas(hertz(), 0.7, 0.3, 7.0 * 1.45e-3);
        let film = Lubrication { viscosity, roughness: 1e-6, cut_off: 4e-4 };
        scene.extras = Extras { lubrication: Some(film), ..Extras::default() };
        let start = kinetic_energy(&grains);
        let mut before = start;
        for _ in 0..100 {
            // Contacts are elastic for a while and give back what they took.
            run(&scene, &mut grains, 1e-5, 1).unwrap();
            let stored = dem_solver::contact::stored_energy(&scene, &grains);
            let now = kinetic_energy(&grains) + stored;
            assert!(now < before + 1e-2 * start, "{viscosity} Pa s: {before} J, then {now} J");
            before = now;
        }
        assert!(
            before < if viscosity > 0.1 { 0.5 } else { 1.0 } * start,
            "{viscosity} Pa s: {before} of {start} J"
        );
    }
}

#[test]
fn a_floor_of_triangles_squeezes_once() {
    let corner = |x: f64, y: f64| Vector::from([x, y, 0.0]);
    let (a, b, c, d) = (corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0));
    let facets = [[a, b, c], [a, c, d]].map(|vertices| Shape::Facet(Facet { vertices }));
    let triangles = Walls::new(vec![Wall::new("floor", 0, facets.to_vec())]);
    let ends = [floor(), triangles].map(|walls| {
        let scene = wet(0.7, 1e-6, 2e-4).with_walls(walls).with_gravity([0.0, 0.0, -9.81]);
        let mut ball = world(&scene, &[above(3e-4).moving([0.001, 0.0, -0.02])]);
        run(&scene, &mut ball, 0.02, 20_000).unwrap();
        ball.grains.place[0].centre
    });
    assert!((ends[0] - ends[1]).norm() < 1e-12, "{} and {}", ends[0], ends[1]);
    assert!(ends[0].z < RADIUS + 2e-4);
}
