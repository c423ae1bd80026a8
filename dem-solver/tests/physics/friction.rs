use crate::scenes::{floor, glass, hertz, hooke, run, world};
use dem_solver::engine::Periods;
use dem_solver::{Domain, Grain, Scene};

#[test]
#[allow(clippy::print_stdout, reason = "the deviation is a figure of the documentation")]
fn a_sliding_sphere_ends_up_rolling_at_five_sevenths_of_its_speed_and_a_disc_at_two_thirds() {
    let (radius, mut worst) = (1e-2, 0.0_f64);
    for law in [hertz(), hooke()] {
        for friction in [0.1, 0.6] {
            let scene = Scene::<3>::new(glass(0.5, friction), law)
                .with_gravity([0.0, 0.0, -9.81])
                .with_walls(floor());
            let mut ball =
                world(&scene, &[Grain::at([0.0, 0.0, 0.99999 * radius], radius).moving([0.3, 0.0, 0.0])]);
            run(&scene, &mut ball, 0.3, 30_000).unwrap();
            let motion = &ball.grains.motion[0];
            let v = motion.velocity.x / 0.3;
            worst = worst.max((v - 5.0 / 7.0).abs());
            assert!((v - 5.0 / 7.0).abs() < 1e-4, "{law:?} mu {friction}: {v}");
            assert!((motion.velocity.x - motion.angular_velocity.y * radius).abs() < 1e-5);

            let scene =
                Scene::<2>::new(glass(0.5, friction), law).with_gravity([0.0, -9.81]).with_walls(floor());
            let mut disc = world(&scene, &[Grain::at([0.0, 0.99999 * radius], radius).moving([0.3, 0.0])]);
            run(&scene, &mut disc, 0.3, 30_000).unwrap();
            let v = disc.grains.motion[0].velocity.x / 0.3;
            assert!((v - 2.0 / 3.0).abs() < 1e-4, "{law:?} mu {friction}: {v}");
        }
    }
    println!("rolling starts at 5/7: {worst:.1e} [1e-4]");
}

#[test]
fn while_it_slides_a_sphere_slows_down_at_mu_g() {
    let scene = Scene::<3>::new(glass(0.2, 0.3), hertz()).with_gravity([0.0, 0.0, -9.81]).with_walls(floor());
    let mut world = world(&scene, &[Grain::at([0.0, 0.0, 1e-2], 1e-2).moving([1.0, 0.0, 0.0])]);
    run(&scene, &mut world, 0.02, 4000).unwrap();
    let (start, t) = (world.grains.motion[0].velocity.x, 0.04);
    run(&scene, &mut world, t, 8000).unwrap();
    let deceleration = (start - world.grains.motion[0].velocity.x) / t;
    assert!((deceleration / (0.3 * 9.81) - 1.0).abs() < 5e-3, "{deceleration}");
}

#[test]
fn a_grain_on_a_slope_stays_below_the_angle_of_friction_and_slides_above() {
    // Four grains glued into one by nothing but their number cannot roll off: a frozen spin is not needed, since
    // the disc is wedged between two frozen discs that rub.
    let slide = |friction: f64| {
        let scene = Scene::<2>::new(glass(0.5, friction), hertz()).with_gravity([0.0, -9.81]);
        let r = 1e-3;
        let grains = [
            Grain::at([-0.9995 * r, 0.0], r).frozen(),
            Grain::at([2.9995 * r, 0.0], r).frozen(),
            Grain::at([r, 0.0], r),
        ];
        let mut world = world(&scene, &grains);
        run(&scene, &mut world, 0.01, 20_000).unwrap();
        world.grains.place[2].centre.y
    };
    assert!(slide(0.9) > -1e-5, "{}", slide(0.9));
    assert!(slide(0.0) < -4e-4, "{}", slide(0.0));
}

#[test]
fn history_follows_a_pair_across_a_periodic_boundary() {
    let scene = Scene::<3>::new(glass(0.5, 0.5), hertz());
    let periodic = Scene::<3>::new(glass(0.5, 0.5), hertz())
        .in_domain(Domain::new([0.0; 3], [0.02; 3]).periodic([true; 3]));
    let pair = |x: f64| {
        [
            Grain::at([x, 1e-2, 1e-2], 1e-3).moving([3.0, 0.2, 0.0]),
            Grain::at([x + 1.99e-3, 1e-2, 1e-2], 1e-3).moving([2.5, -0.2, 0.0]),
        ]
    };
    let (mut open, mut wrapping) = (world(&scene, &pair(0.0185)), world(&periodic, &pair(0.0185)));
    run(&scene, &mut open, 1e-3, 1000).unwrap();
    run(&periodic, &mut wrapping, 1e-3, 1000).unwrap();
    let mut inside = wrapping.grains.place[0].centre;
    Periods::new(&periodic.domain).wrap(&mut inside);
    assert!(inside.x < 0.01, "the pair crossed the boundary");
    for (a, b) in open.grains.motion.iter().zip(&wrapping.grains.motion) {
        assert!(
            (a.velocity - b.velocity).norm() < 1e-9
                && (a.angular_velocity - b.angular_velocity).norm() < 1e-6
        );
    }
}
