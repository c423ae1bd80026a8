use crate::scenes::{glass, hertz, run, world};
use dem_solver::{Grain, Scene, Vector, World};

#[test]
fn a_thrown_grain_follows_the_parabola_to_rounding() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz()).with_gravity([0.1, 0.0, -9.81]);
    let mut world = world(&scene, &[Grain::at([0.0, 0.0, 1.0], 1e-3).moving([2.0, -1.0, 3.0])]);
    let t = 0.5;
    run(&scene, &mut world, t, 1000).unwrap();
    let centre = Vector::from([2.0 * t + 0.05 * t * t, -t, 1.0 + 3.0 * t - 0.5 * 9.81 * t * t]);
    let velocity = Vector::from([2.0 + 0.1 * t, -1.0, 3.0 - 9.81 * t]);
    assert!((world.grains.place[0].centre - centre).norm() < 1e-12);
    assert!((world.grains.motion[0].velocity - velocity).norm() < 1e-12);
}

#[test]
fn one_window_of_many_substeps_is_many_windows_of_one() {
    let scene = Scene::<2>::new(glass(0.5, 0.3), hertz()).with_gravity([0.0, -9.81]);
    let pair = [Grain::at([0.0, 0.0], 1e-3).moving([1.0, 0.0]), Grain::at([2.1e-3, 2e-4], 1e-3)];
    let (mut one, mut many) = (world(&scene, &pair), world(&scene, &pair));
    run(&scene, &mut one, 4e-4, 400).unwrap();
    (0..400).for_each(|_| drop(run(&scene, &mut many, 1e-6, 1).unwrap()));
    for (a, b) in one.grains.motion.iter().zip(&many.grains.motion) {
        assert!(
            (a.velocity - b.velocity).norm() < 1e-9
                && (a.angular_velocity - b.angular_velocity).norm() < 1e-6
        );
        assert!(a.velocity.x != 0.0 && a.angular_velocity.z != 0.0);
    }
}

#[test]
fn an_empty_scene_only_ages() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    let mut world = World::new();
    let ledger = run(&scene, &mut world, 1.0, 3).unwrap();
    assert_eq!((ledger.count, ledger.mass, world.time), (0, 0.0, 1.0));
}
