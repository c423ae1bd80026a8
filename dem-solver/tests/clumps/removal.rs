use crate::scenes::{dumbbell, placed, run, scene, stone};
use dem_solver::insertion::{
    Amount, Batch, BoxRegion, ClumpStart, Feed, Flow, Orientation, Random, RandomFill, Region, Sizes,
};
use dem_solver::wall::Plane;
use dem_solver::{Deletion, Domain, Escape, Grain, Scene, Spin, Vector, Where, World, momentum, turn_over};

fn with_two() -> (Scene<3>, World<3>) {
    let scene = scene(1e7, (0.8, 0.4), vec![stone(), dumbbell()]);
    let mut world = World::new();
    world.add(&scene, &Grain::at([0.0, 0.0, 0.01], 1e-3));
    let kinds = &scene.clumps;
    world.add_clump(&scene, 0, placed(&kinds[0], [0.0; 3], [0.0; 3], [0.1, 0.0, 0.0], [0.0; 3]));
    world.add_clump(&scene, 1, placed(&kinds[1], [0.01, 0.0, 0.0], [0.0; 3], [0.3, 0.0, 0.0], [0.0; 3]));
    (scene, world)
}

#[test]
fn a_deletion_takes_a_clump_whole_when_its_centre_of_mass_is_in_it() {
    let (mut scene, mut world) = with_two();
    let before = momentum(&world);
    // Behind the plane are the second clump's centre and one of its members.
    let plane = Plane { point: Vector::from([0.0099, 0.0, 0.0]), normal: Vector::from([-1.0, 0.0, 0.0]) };
    scene.deletions.push(Deletion { name: "out".into(), place: Where::Beyond(plane) });
    let turnover = turn_over(&scene, &mut world).unwrap();
    assert_eq!((turnover.removed.count, world.taken[0].count), (2, 1));
    let mass = scene.clumps[1].shape.mass();
    assert!((world.taken[0].mass - mass).abs() < 1e-15 * mass && turnover.removed.mass == mass);
    assert!((momentum(&world) + turnover.removed.momentum - before).norm() < 1e-15 * before.norm());
    assert_eq!((world.bodies.as_slice().len(), world.grains.len()), (1, 5));
    run(&scene, &mut world, 1e-3, 100);
}

#[test]
fn a_clump_escapes_whole_and_only_with_its_centre() {
    let (scene, mut world) = with_two();
    let mut scene = scene.in_domain(Domain::new([-1e-4, -1.0, -1.0], [0.0101, 1.0, 1.0]));
    run(&scene, &mut world, 1e-5, 1);
    scene.escape = Escape::Remove;
    run(&scene, &mut world, 1e-3, 100);
    let removed = turn_over(&scene, &mut world).unwrap().removed;
    assert_eq!((removed.count, world.bodies.as_slice().len()), (2, 1));
}

fn batch(scene: &Scene<3>) -> Batch<3> {
    Batch {
        name: "stones".into(),
        material: 0,
        sizes: Sizes::All(scene.clumps[0].shape.bounding_radius()),
        velocity: Vector::zeros(),
        frozen: false,
        clump: Some(ClumpStart {
            kind: 0,
            orientation: Orientation::Random,
            angular_velocity: Spin::zeros(),
        }),
    }
}

#[test]
fn clumps_fill_a_region_to_a_share_of_their_own_volume_and_overlap_nothing() {
    let scene = scene(1e7, (0.8, 0.4), vec![stone()]);
    let region = Region::Box(BoxRegion { lower: Vector::zeros(), upper: Vector::from_element(0.03) });
    let mut world = World::new();
    let fill = RandomFill { region, amount: Amount::SolidFraction(0.04) };
    fill.insert(&scene, &mut world, &batch(&scene), &mut Random::new(1)).unwrap();
    let filled = world.bodies.as_slice().len() as f64 * scene.clumps[0].volume / 0.03_f64.powi(3);
    assert!((filled - 0.04).abs() < scene.clumps[0].volume / 0.03_f64.powi(3));
    assert!(dem_solver::insertion::overlaps(&scene, &world, 0.0).is_empty());
    let axes = world.bodies.as_slice().iter().map(|clump| clump.body.orientation * Spin::x());
    let (count, mean) = (world.bodies.as_slice().len() as f64, axes.sum::<Spin>());
    assert!((mean / count).norm() < 3.0 / count.sqrt(), "turned every way");
}

#[test]
fn a_feed_gives_birth_to_clumps_at_its_mass_rate() {
    let scene = scene(1e7, (0.8, 0.4), vec![stone()]);
    let mass = scene.clumps[0].shape.mass();
    let mut world = World::new();
    world.feeds.push(Feed {
        batch: batch(&scene),
        region: Region::Box(BoxRegion { lower: Vector::zeros(), upper: Vector::from_element(0.03) }),
        flow: Flow::Mass(10.0 * mass),
        start: 0.0,
        stop: 1.0,
        random: Random::new(2),
        fed: 0.0,
        count: 0,
        refused: 0,
        waiting: None,
    });
    world.time = 1.0;
    let born = turn_over(&scene, &mut world).unwrap().born;
    assert_eq!((world.bodies.as_slice().len(), born.count, world.feeds[0].count), (10, 40, 10));
    assert!((born.mass - 10.0 * mass).abs() < 1e-14 * born.mass);
    run(&scene, &mut world, 1e-3, 100);
}
