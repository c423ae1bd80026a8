//! Resistance to twisting.
#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::scenes::{GLASS, floor, glass, hertz, kinetic_energy, run, world};
use dem_solver::contact::Extras;
use dem_solver::contact::cohesion::CohesionLaw;
use dem_solver::contact::rolling::RollingLaw;
use dem_solver::contact::twisting::{Twist, Twisting, TwistingLaw};
use dem_solver::wall::{Facet, Shape, Wall, Walls};
use dem_solver::{Grain, Scene, Vector};

const RADIUS: f64 = 1e-2;
const FRICTION: f64 = 0.5;
const TWISTING: Extras =
    Extras { twisting: Some(TwistingLaw::Marshall), rolling: None, lubrication: None, cohesion: None };

fn resisting() -> Scene<3> {
    Scene::<3>::new(glass(0.5, FRICTION), hertz())
        .with_gravity([0.0, 0.0, -9.81])
        .with_walls(floor())
        .with_extras(TWISTING)
}

fn weight() -> f64 {
    GLASS.density * dem_solver::volume::<3>(RADIUS, 1.0) * 9.81
}

/// Overlap of a sphere that rests on the floor.
fn resting() -> f64 {
    let modulus = 0.5 * GLASS.youngs_modulus / (1.0 - GLASS.poissons_ratio.powi(2));
    (0.75 * weight() / (modulus * RADIUS.sqrt())).powf(2.0 / 3.0)
}

fn spinning(spin: f64) -> Grain<3> {
    Grain::at([0.0, 0.0, RADIUS - resting()], RADIUS).spinning([0.0, 0.0, spin])
}

#[test]
fn a_sphere_that_spins_on_the_floor_stops_when_coulombs_limit_says() {
    // I dω/dt = -2/3 a μ m g, a² = R δ.
    let torque = 2.0 / 3.0 * (RADIUS * resting()).sqrt() * FRICTION * weight();
    let inertia = dem_solver::inertia::<3>(weight() / 9.81, RADIUS);
    let spin = 50.0;
    let time = inertia * spin / torque;
    let corner = |x: f64, y: f64| Vector::from([x, y, 0.0]);
    let triangle = Facet { vertices: [corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 2.0)] };
    let facet = Walls::new(vec![Wall::new("floor", 0, vec![Shape::Facet(triangle)])]);
    for walls in [floor(), facet] {
        let scene = resisting().with_walls(walls);
        let mut ball = world(&scene, &[spinning(spin)]);
        let mut energy = kinetic_energy(&ball);
        for part in 1..10 {
            run(&scene, &mut ball, 0.1 * time, 10_000).unwrap();
            let found = ball.grains.motion[0].angular_velocity.z / spin;
            let expected = 1.0 - 0.1 * f64::from(part);
            assert!((found - expected).abs() < 1e-3, "{found} for {expected}");
            assert!(kinetic_energy(&ball) < energy);
            energy = kinetic_energy(&ball);
        }
        // What is left is the swing of a spring wound up to the limit, I dω²/2 = T²/(2 k), k = 4 G* a³.
        run(&scene, &mut ball, 0.2 * time, 20_000).unwrap();
        let nu = GLASS.poissons_ratio;
        let modulus = GLASS.youngs_modulus / (4.0 * (2.0 - nu) * (1.0 + nu));
        let stiffness = 4.0 * modulus * (RADIUS * resting()).powf(1.5);
        let swing = torque / (stiffness * inertia).sqrt();
        let left = ball.grains.motion[0].angular_velocity.norm();
        assert!(left < 1.01 * swing && swing < 0.03 * spin, "{left} rad/s, swings of {swing} rad/s");
        assert!(ball.grains.motion[0].velocity.norm() < 1e-6);
    }
}

#[test]
fn below_the_limit_the_contact_is_a_spring_of_golden_stiffness() {
    // k = k_t a²/2 = 4 G* a³, limit 2/3 a μ F.
    let (radius_squared, stiffness, limit) = (4e-8, 1e4, 2.0);
    let mut twist = Twist::relaxed();
    let twisted = |rate: f64| Twisting {
        rate,
        contact_radius_squared: radius_squared,
        stiffness,
        damping: 0.0,
        limit,
        step: 1e-3,
    };
    let law = TwistingLaw::Marshall;
    let torque = law.torque(&twisted(0.5), &mut twist);
    assert!((torque / (0.5 * stiffness * radius_squared * 0.5e-3) - 1.0).abs() < 1e-14);
    let most = 2.0 / 3.0 * radius_squared.sqrt() * limit;
    let torque = law.torque(&twisted(1e6), &mut twist);
    assert!((torque / most - 1.0).abs() < 1e-14 && twist.torque == torque);
    // It follows an unloading contact, and a heavier one gives back no more than was put in.
    let lighter = Twisting { stiffness: 0.5 * stiffness, ..twisted(0.0) };
    assert!((law.torque(&lighter, &mut twist) / (0.5 * most) - 1.0).abs() < 1e-14);
    assert!((law.torque(&twisted(0.0), &mut twist) / (0.5 * most) - 1.0).abs() < 1e-14);
}

#[test]
fn spheres_that_adhere_share_their_spin_and_keep_angular_momentum() {
    let materials = glass(0.5, FRICTION).with(|_, _, pair| {
        pair.work_of_adhesion = 10.0;
        pair.rolling_friction = 0.05;
    });
    let cohesion = Some(CohesionLaw::Jkr);
    for rolling in [None, Some(RollingLaw::Epsd2)] {
        let scene =
            Scene::<3>::new(materials.clone(), hertz()).with_extras(Extras { rolling, cohesion, ..TWISTING });
        let grains = [
            Grain::at([0.0; 3], RADIUS).spinning([300.0, 0.0, 0.0]),
            Grain::at([1.599 * RADIUS, 0.0, 0.0], 0.6 * RADIUS).spinning([-100.0, 0.0, 0.0]),
        ];
        let mut pair = world(&scene, &grains);
        let about_x = |pair: &dem_solver::World<3>| -> f64 {
            pair.grains.motion.iter().map(|motion| motion.angular_velocity.x / motion.inverse_inertia).sum()
        };
        let start = about_x(&pair);
        let first = kinetic_energy(&pair);
        let mut energy = first;
        for _ in 0..20 {
            run(&scene, &mut pair, 20e-3, 1000).unwrap();
            let spinning: f64 = pair
                .grains
                .motion
                .iter()
                .map(|motion| 0.5 * motion.angular_velocity.norm_squared() / motion.inverse_inertia)
                .sum();
            assert!(spinning < energy + 1e-3 * first, "{spinning} J after {energy} J");
            energy = spinning;
        }
        let spins = pair.grains.motion.iter().map(|motion| motion.angular_velocity.x).collect::<Vec<_>>();
        println!("spins {spins:?} rad/s");
        assert!((spins[0] - spins[1]).abs() < 40.0, "{spins:?}");
        assert!((about_x(&pair) / start - 1.0).abs() < 1e-12);
    }
}
