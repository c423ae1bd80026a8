use std::f64::consts::PI;

use crate::scenes::{floor, glass, hertz, kinetic_energy, run, world};
use dem_solver::wall::{Cylinder, Disc, Motion, Shape, Side, Sphere, Tube, Wall, Walls};
use dem_solver::{Domain, Grain, Scene, Vector};

const G: f64 = 9.81;

fn one(shape: Shape<3>) -> Walls<3> {
    Walls::new(vec![Wall::new("round", 0, vec![shape])])
}

fn cylinder(radius: f64, side: Side) -> Shape<3> {
    Shape::Cylinder(Cylinder { point: Vector::zeros(), axis: Vector::y(), radius, side })
}

fn sphere(radius: f64, side: Side) -> Shape<3> {
    Shape::Sphere(Sphere { centre: Vector::zeros(), radius, side })
}

/// A can of this radius about the z axis, from z = 0 up.
fn can(radius: f64, length: f64) -> Vec<Shape<3>> {
    let axis = Vector::z();
    let end = |z: f64| Shape::Disc(Disc { centre: Vector::from([0.0, 0.0, z]), axis, radius });
    let shell = Tube { start: Vector::zeros(), axis, length, radius };
    vec![Shape::Tube(shell), end(0.0), end(length)]
}

/// Velocity after a flight into the wall.
fn thrown(walls: Walls<3>, place: [f64; 3], velocity: [f64; 3]) -> Vector<3> {
    let scene = Scene::<3>::new(glass(0.6, 0.3), hertz()).with_walls(walls);
    let mut world = world(&scene, &[Grain::at(place, 1e-2).moving(velocity)]);
    run(&scene, &mut world, 0.02, 8000).unwrap();
    world.grains.motion[0].velocity
}

#[test]
fn head_on_a_round_wall_is_as_hard_as_a_plane() {
    let plane = thrown(floor(), [0.0, 0.0, 1.2e-2], [0.0, 0.0, -0.5]);
    let shell = Tube { start: Vector::from([0.0, -1.0, 0.0]), axis: Vector::y(), length: 2.0, radius: 0.1 };
    let cap = Disc { centre: Vector::from([0.0, 0.0, 0.1]), axis: Vector::z(), radius: 0.1 };
    for (name, shape, height) in [
        ("roller", cylinder(0.1, Side::Outside), 0.112),
        ("ball", sphere(0.1, Side::Outside), 0.112),
        ("drum", cylinder(0.1, Side::Inside), -0.088),
        ("bowl", sphere(0.1, Side::Inside), -0.088),
        ("pipe from outside", Shape::Tube(shell), 0.112),
        ("pipe from inside", Shape::Tube(shell), -0.088),
        ("lid", Shape::Disc(cap), 0.112),
    ] {
        let velocity = thrown(one(shape), [0.0, 0.0, height], [0.0, 0.0, -0.5]);
        assert!((velocity - plane).norm() < 1e-9, "{name}: {velocity:?} {plane:?}");
    }
}

#[test]
fn a_grain_that_rolls_in_a_drum_is_a_pendulum_of_seven_fifths_of_the_length() {
    let (radius, off) = (0.1_f64, 0.05);
    for (friction, inertia) in [(0.0, 1.0), (0.6, 1.4)] {
        let scene = Scene::<3>::new(glass(0.9, friction), hertz())
            .with_gravity([0.0, 0.0, -G])
            .with_walls(one(cylinder(radius, Side::Inside)));
        // At rest 0.05 rad from the bottom, pressed in by its weight.
        let length = radius - 5e-3 + 1.2e-7;
        let at = [length * f64::sin(off), 0.0, -length * f64::cos(off)];
        let mut world = world(&scene, &[Grain::at(at, 5e-3)]);
        let period = 2.0 * PI * (inertia * length / G).sqrt() * (1.0 + off * off / 16.0);
        run(&scene, &mut world, 2.25 * period, 100_000).unwrap();
        // A quarter period after two whole ones it goes through the bottom.
        let angle = (world.grains.place[0].centre.x / length).asin();
        assert!(angle.abs() < 2e-3 * off, "{angle} of {off} at friction {friction}");
        assert!(world.grains.motion[0].velocity.x < 0.0);
    }
}

#[test]
fn a_can_holds_its_grains_and_their_energy() {
    let scene = Scene::<3>::new(glass(1.0, 0.0), hertz()).with_walls(Walls::new(vec![Wall::new(
        "can",
        0,
        can(0.02, 0.03),
    )]));
    let grain = |k: f64| {
        let at = [8e-3 * (2.0 * k).sin(), 8e-3 * (2.0 * k).cos(), 5e-3 + 5e-3 * k];
        Grain::at(at, 2e-3).moving([(3.0 * k).sin(), (5.0 * k).cos(), (7.0 * k + 1.0).sin()])
    };
    let mut world = world(&scene, &[0.0, 1.0, 2.0, 3.0, 4.0].map(grain));
    let before = kinetic_energy(&world);
    let mut bounced = 0.0;
    for _ in 0..20 {
        let ledger = run(&scene, &mut world, 0.02, 4000).unwrap();
        assert!(ledger.residual().norm() < 1e-13 * ledger.scale);
        bounced += ledger.walls.norm();
    }
    assert!(bounced > 1e-3, "{bounced} N s");
    let inside = |place: &dem_solver::Place| {
        let c = place.centre;
        c.x.hypot(c.y) < 0.0181 && c.z > 1.9e-3 && c.z < 0.0281
    };
    assert!(world.grains.place.iter().all(inside), "{:?}", world.grains.place);
    let after = kinetic_energy(&world);
    assert!((after / before - 1.0).abs() < 1e-2, "{before} J, {after} J");
}

#[test]
fn the_rim_of_a_can_is_felt_once_and_its_corner_twice() {
    let walls = || Walls::new(vec![Wall::new("can", 0, can(0.1, 0.2))]);
    let plane = thrown(floor(), [0.0, 0.0, 1.2e-2], [0.0, 0.0, -0.5]).z;
    let slant = 1.0 / 2.0_f64.sqrt();
    let off = 1.2e-2 * slant;
    let rim = thrown(walls(), [0.1 + off, 0.0, 0.2 + off], [-0.5 * slant, 0.0, -0.5 * slant]);
    assert!((rim - Vector::from([plane * slant, 0.0, plane * slant])).norm() < 1e-9, "{rim:?}");
    // Into the corner: as from a floor and a wall at once.
    let corner = thrown(walls(), [0.1 - 1.2e-2, 0.0, 1.2e-2], [0.5, 0.0, -0.5]);
    let side = Wall::plane("side", 0, [0.1, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    let bottom = Wall::plane("floor", 0, [0.0; 3], [0.0, 0.0, 1.0]);
    let square = thrown(Walls::new(vec![bottom, side]), [0.1 - 1.2e-2, 0.0, 1.2e-2], [0.5, 0.0, -0.5]);
    assert!((corner - square).norm() < 1e-9, "{corner:?} {square:?}");
}

#[test]
fn grains_cannot_tell_a_moving_round_wall_from_their_own_motion() {
    let speed = Vector::<3>::from([0.5, -0.2, 1.0]);
    let end = |shape: Shape<3>, motion: Motion<3>, velocity: [f64; 3]| {
        let walls = Walls::new(vec![Wall::new("round", 0, vec![shape]).moving(motion)]);
        let scene = Scene::<3>::new(glass(0.6, 0.3), hertz()).with_walls(walls);
        let mut world = world(&scene, &[Grain::at([1e-3, 2e-3, 0.112], 1e-2).moving(velocity)]);
        run(&scene, &mut world, 0.01, 4000).unwrap();
        world.grains.motion[0]
    };
    let shell = Tube { start: Vector::from([0.0, -1.0, 0.0]), axis: Vector::y(), length: 2.0, radius: 0.1 };
    for shape in [cylinder(0.1, Side::Outside), sphere(0.1, Side::Outside), Shape::Tube(shell)] {
        let thrown = end(shape, Motion::none(), (-speed).into());
        assert!(thrown.velocity.z > 0.3, "it was hit");
        let hit = end(shape, Motion::translation(speed.into()), [0.0; 3]);
        assert!((hit.velocity - speed - thrown.velocity).norm() < 1e-9, "{hit:?} {thrown:?}");
        assert!((hit.angular_velocity - thrown.angular_velocity).norm() < 1e-6);
    }
}

#[test]
fn a_stale_list_would_be_seen_among_round_walls_that_move() {
    let wall = |name: &str, shape: Shape<3>| Wall::new(name, 0, vec![shape]);
    let tilt = |rate: f64| Motion::rotation([0.0; 3], [rate, 0.0, 0.0]);
    let stirrer =
        Tube { start: Vector::from([0.0, -4e-3, 0.0]), axis: Vector::y(), length: 8e-3, radius: 1.5e-3 };
    let walls = Walls::new(vec![
        wall("drum", cylinder(1e-2, Side::Inside)).moving(Motion::rotation([0.0; 3], [0.0, 4.0, 0.0])),
        wall("stirrer", Shape::Tube(stirrer)).moving(tilt(5.0)),
        wall(
            "axle",
            Shape::Cylinder(Cylinder {
                point: Vector::zeros(),
                axis: Vector::y(),
                radius: 5e-4,
                side: Side::Outside,
            }),
        )
        .moving(tilt(1.0)),
    ]);
    let scene = Scene::<3>::new(glass(0.5, 0.4), hertz()).with_gravity([0.0, 0.0, -G]).with_walls(walls);
    let mut grains = Vec::new();
    for k in 0..120 {
        let [i, j, l] = [k % 6, k / 6 % 5, k / 30].map(f64::from);
        grains.push(Grain::at([1.2e-3 * (i - 2.5), 1.2e-3 * (j - 2.0), -6.5e-3 + 1.2e-3 * l], 5e-4));
    }
    let start = world(&scene, &grains);
    let (mut with_skin, mut anew) = (start.clone(), start);
    for _ in 0..2000 {
        anew.contacts.expire();
        run(&scene, &mut anew, 2e-5, 1).unwrap();
        run(&scene, &mut with_skin, 2e-5, 1).unwrap();
    }
    let built = with_skin.contacts.counters.walls;
    assert!((2..500).contains(&built), "{built} lists");
    assert!(anew.grains == with_skin.grains);
}

#[test]
fn a_drum_that_turns_about_its_own_axis_makes_no_list_old() {
    let motion = Motion::rotation([0.0, 7.0, 0.0], [0.0, 100.0, 0.0]);
    let walls = Walls::new(vec![Wall::new("drum", 0, vec![cylinder(1.0, Side::Inside)]).moving(motion)]);
    assert!(walls.largest_approach(&walls.poses(0.0, &[]), &walls.poses(0.123, &[])) < 1e-12);
}

#[test]
fn a_ball_is_felt_across_a_periodic_boundary_and_a_bowl_is_not() {
    let domain = Domain::new([-0.05; 3], [0.15; 3]).periodic([true; 3]);
    let scene = |side: Side, radius: f64| {
        Scene::<3>::new(glass(1.0, 0.0), hertz()).in_domain(domain).with_walls(one(sphere(radius, side)))
    };
    // The ball about the origin is seen at x = 0.2 from the other end of the box.
    let ball = scene(Side::Outside, 0.045);
    let mut hit = world(&ball, &[Grain::at([0.145, 0.0, 0.0], 4e-3).moving([0.5, 0.0, 0.0])]);
    run(&ball, &mut hit, 0.02, 8000).unwrap();
    assert!((hit.grains.motion[0].velocity.x + 0.5).abs() < 1e-3, "{:?}", hit.grains.motion[0].velocity);
    let bowl = scene(Side::Inside, 0.049);
    let mut kept = world(&bowl, &[Grain::at([0.0; 3], 4e-3).moving([0.5, 0.0, 0.0])]);
    run(&bowl, &mut kept, 0.12, 8000).unwrap();
    assert!((kept.grains.motion[0].velocity.x + 0.5).abs() < 1e-3, "{:?}", kept.grains.motion[0].velocity);
}

#[test]
fn a_disc_swings_in_a_circle_as_a_pendulum() {
    let circle = Sphere { centre: Vector::zeros(), radius: 0.1, side: Side::Inside };
    let scene = Scene::<2>::new(glass(0.9, 0.0), hertz())
        .with_gravity([0.0, -G])
        .with_walls(Walls::new(vec![Wall::new("bowl", 0, vec![Shape::Sphere(circle)])]));
    let (length, off) = (0.095, 0.05_f64);
    let mut world = world(&scene, &[Grain::at([length * off.sin(), -length * off.cos()], 5e-3)]);
    let period = 2.0 * PI * (length / G).sqrt() * (1.0 + off * off / 16.0);
    run(&scene, &mut world, 1.25 * period, 60_000).unwrap();
    let angle = world.grains.place[0].centre.x / length;
    assert!(angle.abs() < 3e-3 * off, "{angle} of {off}");
}
