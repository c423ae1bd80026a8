use crate::scenes::{body, dumbbell, floor, placed, run, scene, stone};
use dem_solver::{Domain, Scene, Spin, World, turn_over};

/// Two clumps that meet above the floor near x, in a domain that wraps in x and y.
fn meeting(x: f64) -> (Scene<3>, World<3>) {
    let domain = Domain::new([0.0, 0.0, -1.0], [0.02, 0.02, 1.0]).periodic([true, true, false]);
    let scene = scene(1e7, (0.8, 0.4), vec![stone(), dumbbell()])
        .with_walls(floor())
        .with_gravity([0.0, 0.0, -9.81])
        .in_domain(domain);
    let mut world = World::new();
    let kinds = &scene.clumps;
    let one = placed(&kinds[0], [x - 3e-3, 0.01, 3e-3], [0.4, 0.2, 0.0], [0.5, 0.0, 0.0], [0.0, 200.0, 50.0]);
    let other =
        placed(&kinds[1], [x + 3e-3, 0.011, 3e-3], [0.0, 0.3, 0.7], [-0.3, 0.0, 0.0], [90.0, 0.0, 0.0]);
    world.add_clump(&scene, 0, one);
    world.add_clump(&scene, 1, other);
    (scene, world)
}

#[test]
fn clumps_meet_across_a_periodic_side_as_they_do_elsewhere() {
    let end = |x: f64| {
        let (scene, mut world) = meeting(x);
        for _ in 0..15 {
            turn_over(&scene, &mut world).unwrap();
            run(&scene, &mut world, 2e-3, 1000);
        }
        let inside = |centre: &Spin| centre.x > -2e-3 && centre.x < 0.022;
        assert!(world.grains.place.iter().all(|place| inside(&place.centre)), "members wrap");
        world
    };
    let (whole, split) = (end(0.008), end(0.018));
    for clump in 0..2 {
        let (one, other) = (body(&whole, clump), body(&split, clump));
        let apart = other.centre - one.centre - Spin::new(0.01, 0.0, 0.0);
        let apart = Spin::new(apart.x - 0.02 * (apart.x / 0.02).round(), apart.y, apart.z);
        assert!(apart.norm() < 1e-9, "{apart}");
        assert!((one.velocity - other.velocity).norm() < 1e-7);
        assert!((one.angular_momentum - other.angular_momentum).norm() < 1e-6 * one.angular_momentum.norm());
    }
}
