//! Resistance to rolling.

use crate::scenes::{GLASS, floor, glass, hertz, run, world};
use dem_solver::contact::Extras;
use dem_solver::contact::rolling::RollingLaw;
use dem_solver::wall::{Facet, Shape, Wall, Walls};
use dem_solver::{Grain, Scene, Vector, World};

const RADIUS: f64 = 1e-2;
const FRICTION: f64 = 0.05;

fn resisting<const D: usize>(law: RollingLaw) -> Scene<D> {
    let materials = glass(0.5, 0.5).with(|_, _, pair| {
        pair.rolling_friction = FRICTION;
        pair.rolling_damping_ratio = 0.3;
    });
    let mut down = [0.0; D];
    down[D - 1] = -9.81;
    Scene::<D>::new(materials, hertz())
        .with_gravity(down)
        .with_walls(floor())
        .with_extras(Extras { rolling: Some(law), ..Extras::default() })
}

fn rolling_ball() -> Grain<3> {
    let resting = {
        let weight = GLASS.density * dem_solver::volume::<3>(RADIUS, 1.0) * 9.81;
        let modulus = 0.5 * GLASS.youngs_modulus / (1.0 - GLASS.poissons_ratio.powi(2));
        (0.75 * weight / (modulus * RADIUS.sqrt())).powf(2.0 / 3.0)
    };
    Grain::at([0.0, 0.0, RADIUS - resting], RADIUS).moving([0.3, 0.0, 0.0]).spinning([0.0, 0.3 / RADIUS, 0.0])
}

/// Deceleration between 0.1 and 0.2 s.
fn deceleration<const D: usize>(scene: &Scene<D>, world: &mut World<D>) -> f64 {
    run(scene, world, 0.1, 10_000).unwrap();
    let before = world.grains.motion[0].velocity.x;
    run(scene, world, 0.1, 10_000).unwrap();
    (before - world.grains.motion[0].velocity.x) / 0.1
}

#[test]
fn a_rolling_sphere_is_braked_at_five_sevenths_of_mu_g_and_a_disc_at_two_thirds() {
    for law in [RollingLaw::Cdt, RollingLaw::Epsd, RollingLaw::Epsd2] {
        let scene = resisting::<3>(law);
        let found = deceleration(&scene, &mut world(&scene, &[rolling_ball()]));
        assert!((found / (5.0 / 7.0 * FRICTION * 9.81) - 1.0).abs() < 1e-4, "{law:?}: {found} m/s²");
        let scene = resisting::<2>(law);
        let disc = Grain::at([0.0, 0.9999 * RADIUS], RADIUS).moving([0.3, 0.0]).spinning([0.0, 0.0, -30.0]);
        let found = deceleration(&scene, &mut world(&scene, &[disc]));
        assert!((found / (2.0 / 3.0 * FRICTION * 9.81) - 1.0).abs() < 1e-3, "{law:?}: {found} m/s²");
    }
}

#[test]
fn on_a_floor_of_triangles_a_sphere_is_braked_as_on_a_plane() {
    let corner = |x: f64, y: f64| Vector::from([x, y, 0.0]);
    let triangle = Facet { vertices: [corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 2.0)] };
    for law in [RollingLaw::Cdt, RollingLaw::Epsd] {
        let plane = resisting::<3>(law);
        let facet =
            plane.clone().with_walls(Walls::new(vec![Wall::new("floor", 0, vec![Shape::Facet(triangle)])]));
        let mut balls = [&plane, &facet].map(|scene| {
            let mut ball = world(scene, &[rolling_ball()]);
            run(scene, &mut ball, 0.05, 5000).unwrap();
            ball.grains.motion[0]
        });
        let [on_plane, on_facet] = &mut balls;
        assert!((on_plane.velocity - on_facet.velocity).norm() < 1e-12, "{law:?}");
        assert!((on_plane.angular_velocity - on_facet.angular_velocity).norm() < 1e-10, "{law:?}");
    }
}

#[test]
fn between_unlike_grains_it_keeps_momentum_and_angular_momentum() {
    for law in [RollingLaw::Cdt, RollingLaw::Epsd] {
        let scene = Scene { walls: Walls::new(vec![]), ..resisting::<3>(law) }.with_gravity([0.0; 3]);
        let grains = [
            Grain::at([0.0; 3], 1e-3).spinning([30.0, 200.0, -90.0]).moving([0.1, 0.0, 0.0]),
            Grain::at([1.5e-3, 0.7e-3, 0.3e-3], 0.7e-3)
                .spinning([-100.0, 0.0, 50.0])
                .moving([-0.2, 0.1, 0.0]),
        ];
        let mut pair = world(&scene, &grains);
        let start = angular_momentum(&pair);
        run(&scene, &mut pair, 2e-4, 400).unwrap();
        let spin = pair.grains.motion[0].angular_velocity - Vector::from([30.0, 200.0, -90.0]);
        assert!(spin.norm() > 1.0, "they touched");
        assert!((angular_momentum(&pair) - start).norm() < 1e-12 * start.norm(), "{law:?}");
    }
}

#[test]
fn a_sphere_that_rocks_comes_to_rest_below_the_critical_step() {
    // epsd2: of the usual laws the stiffest against rolling.
    let scene = resisting::<3>(RollingLaw::Epsd2);
    let resting = rolling_ball().moving([0.0; 3]).spinning([0.0; 3]);
    let mut ball = world(&scene, &[resting]);
    run(&scene, &mut ball, 1e-3, 100).unwrap();
    ball.grains.motion[0].angular_velocity.y = 1e-6;
    let step = dem_solver::critical_time_step(&scene, &ball).step;
    run(&scene, &mut ball, 2000.0 * 0.9 * step, 2000).unwrap();
    let motion = &ball.grains.motion[0];
    assert!(motion.velocity.norm() < 1e-6 * RADIUS && motion.angular_velocity.norm() < 1e-6, "{motion:?}");
}

fn angular_momentum(world: &World<3>) -> Vector<3> {
    let grains = world.grains.place.iter().zip(&world.grains.motion);
    grains.fold(Vector::zeros(), |sum, (place, m)| {
        sum + place.centre.cross(&m.velocity) / m.inverse_mass + m.angular_velocity / m.inverse_inertia
    })
}

#[test]
fn a_resumed_world_still_holds_its_torques() {
    let scene = resisting::<3>(RollingLaw::Epsd);
    let second = Grain::at([0.0, 1.99 * RADIUS, RADIUS], RADIUS).spinning([5.0, 0.0, 0.0]);
    let mut through = world(&scene, &[rolling_ball(), second]);
    run(&scene, &mut through, 0.002, 200).unwrap();
    let path = std::env::temp_dir().join(format!("dem-solver-rolling-{}.checkpoint", std::process::id()));
    through.write_checkpoint(&path).unwrap();
    let mut resumed = World::read_checkpoint(&path, &scene, vec![]).unwrap();
    std::fs::remove_file(&path).unwrap();
    let held = |world: &World<3>| {
        let chunk = &world.contacts.chunks[0];
        chunk
            .planes
            .all_springs()
            .chain(chunk.inner.all_springs())
            .map(|spring| spring.spring.torque.norm_squared())
            .sum::<f64>()
    };
    assert!(held(&through) > 0.0 && held(&resumed) == held(&through));
    run(&scene, &mut through, 0.002, 200).unwrap();
    run(&scene, &mut resumed, 0.002, 200).unwrap();
    assert!(resumed == through);
}
