use crate::scenes::{floor, glass, hertz, run, world};
use dem_solver::insertion::{
    Amount, Batch, BoxRegion, CylinderRegion, Feed, Flow, Partner, Random, RandomFill, Region, Sizes, Space,
    SphereRegion, Uniform, coincident, overlaps,
};
use dem_solver::wall::{Plane, Wall, Walls};
use dem_solver::{
    Deletion, Domain, Escape, Grain, Grains, Scene, Taken, Vector, Where, World, turn_over, volume,
};

fn batch(radius: f64) -> Batch<3> {
    Batch {
        name: "rain".into(),
        material: 0,
        sizes: Sizes::All(radius),
        velocity: Vector::zeros(),
        frozen: false,
        clump: None,
    }
}

fn box_of(amount: Amount) -> RandomFill<3> {
    let region = BoxRegion { lower: Vector::zeros(), upper: Vector::from_element(0.02) };
    RandomFill { region: Region::Box(region), amount }
}

#[test]
fn a_random_box_has_no_overlap_and_stays_inside_even_across_a_periodic_side() {
    let domain = Domain::new([0.0; 3], [0.02; 3]).periodic([true, false, false]);
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz()).in_domain(domain).with_walls(floor());
    let mut world = World::new();
    box_of(Amount::SolidFraction(0.25))
        .insert(&scene, &mut world, &batch(1e-3), &mut Random::new(1))
        .unwrap();
    let solid = world.grains.len() as f64 * volume::<3>(1e-3, 1.0) / 0.02_f64.powi(3);
    assert!((solid - 0.25).abs() < 0.5 * volume::<3>(1e-3, 1.0) / 0.02_f64.powi(3) + 1e-12);
    let places = &world.grains.place;
    assert!(places.iter().all(|place| place.centre.z >= 1e-3 && place.centre.z <= 0.019));
    assert!(places.iter().any(|place| place.centre.x < 1e-3), "grains reach across the periodic side");
    for (k, a) in places.iter().enumerate() {
        for b in &places[..k] {
            for shift in [-0.02, 0.0, 0.02] {
                assert!((a.centre - b.centre + Vector::from([shift, 0.0, 0.0])).norm() >= 2e-3);
            }
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_grains_and_another_seed_others() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    let fill = |seed: u64| {
        let mut world = World::new();
        box_of(Amount::Count(50)).insert(&scene, &mut world, &batch(5e-4), &mut Random::new(seed)).unwrap();
        world
    };
    assert!(fill(1) == fill(1) && fill(1) != fill(2));
}

#[test]
fn a_full_box_says_how_many_fitted() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    let insert = |amount: Amount, radius: f64| {
        box_of(amount)
            .insert(&scene, &mut World::new(), &batch(radius), &mut Random::new(1))
            .unwrap_err()
            .to_string()
    };
    let message = insert(Amount::Count(10_000), 2e-3);
    assert!(
        message.starts_with("insertion rain: ") && message.contains("of 10000 grains fitted"),
        "{message}"
    );
    let fitted: usize = message["insertion rain: ".len()..].split(' ').next().unwrap().parse().unwrap();
    assert!((40..100).contains(&fitted), "{message}");
    assert!(
        message.contains("of diameter 0.0040 m, met a grain at ") && message.contains(" full;"),
        "{message}"
    );
    let wide = insert(Amount::Count(1), 1.0);
    assert!(
        wide.contains(": 0 of 1 grains fitted: the next, of diameter 2.0000 m, is wider than the region"),
        "{wide}"
    );
    // A floor at half height leaves no room below, and a wall in the way is told as such.
    let high = Walls::new(vec![Wall::plane("high", 0, [0.0, 0.0, 0.0185], [0.0, 0.0, 1.0])]);
    let scene = scene.with_walls(high);
    let fill = box_of(Amount::Count(1));
    let walled = fill.insert(&scene, &mut World::new(), &batch(1e-3), &mut Random::new(1)).unwrap_err();
    assert!(walled.to_string().contains("met a grain at 0 and a wall at 100000"), "{walled}");
}

#[test]
fn round_regions_are_filled_to_their_solid_fraction_and_nothing_sticks_out() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    let (lower, upper) = (Vector::from([0.0, 0.0, 0.01]), Vector::from([0.03, 0.0, 0.03]));
    let rod = Region::Cylinder(CylinderRegion { start: lower, end: upper, radius: 8e-3 });
    let ball = Region::Sphere(SphereRegion { centre: lower, radius: 1e-2 });
    for region in [rod, ball] {
        let mut world = World::new();
        let fill = RandomFill { region: region.clone(), amount: Amount::SolidFraction(0.2) };
        let sizes = Sizes::Uniform(Uniform { smallest: 3e-4, largest: 9e-4 });
        fill.insert(&scene, &mut world, &Batch { sizes, ..batch(1e-3) }, &mut Random::new(8)).unwrap();
        let solid: f64 = world.grains.place.iter().map(|place| volume::<3>(place.radius, 1.0)).sum();
        assert!((solid / region.volume() - 0.2).abs() < 1e-3, "{}", solid / region.volume());
        assert!(world.grains.place.iter().all(|place| region.holds(&place.centre)));
        assert!(overlaps(&scene, &world, 0.0).is_empty());
    }
}

#[test]
fn overlaps_at_the_start_are_found_across_periodic_sides_and_in_walls() {
    let domain = Domain::new([0.0, 0.0, -1.0], [0.1, 0.1, 1.0]).periodic([true, true, false]);
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz()).in_domain(domain).with_walls(floor());
    let at = |x: f64, z: f64| Grain::at([x, 0.05, z], 1e-3);
    let grains = [at(0.001, 0.01), at(0.0991, 0.01), at(0.05, 0.01), at(0.05199, 0.01), at(0.07, 9.5e-4)];
    let found = overlaps(&scene, &world(&scene, &grains), 0.01);
    let pairs: Vec<_> = found.iter().map(|overlap| (overlap.grain, overlap.with)).collect();
    assert_eq!(pairs, [(0, Partner::Grain(1)), (4, Partner::Wall(0))]);
    assert!((found[0].fraction - 0.05).abs() < 1e-9 && (found[1].fraction - 0.025).abs() < 1e-9, "{found:?}");
    let frozen = grains.map(Grain::frozen);
    assert!(overlaps(&scene, &world(&scene, &frozen), 0.01).is_empty());
}

#[test]
fn deletions_take_what_is_in_them_and_book_it() {
    let region = Region::Sphere(SphereRegion { centre: Vector::from([0.0, 0.0, 0.1]), radius: 0.01 });
    let ground = Plane { point: Vector::zeros(), normal: Vector::z() };
    let deletion = |name: &str, place: Where<3>| Deletion { name: name.into(), place };
    let scene = Scene {
        deletions: vec![deletion("hole", Where::Within(region)), deletion("ground", Where::Beyond(ground))],
        escape: Escape::Remove,
        ..Scene::<3>::new(glass(0.9, 0.3), hertz())
            .with_gravity([0.0, 0.0, -9.81])
            .in_domain(Domain::new([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]))
    };
    let fall = |x: f64, z: f64| Grain::at([x, 0.0, z], 1e-3);
    let aside = Grain::at([0.99, 0.0, 0.5], 1e-3).moving([1.0, 0.0, 0.0]);
    let mut world =
        world(&scene, &[fall(0.0, 0.12), fall(0.0, 0.13), fall(0.5, 0.05), fall(0.5, 0.9), aside]);
    let mass = world.grains.mass[0];
    for _ in 0..100 {
        run(&scene, &mut world, 2e-3, 20).unwrap();
        turn_over(&scene, &mut world).unwrap();
    }
    let taken = |count: u64| Taken { count, mass: count as f64 * mass };
    assert_eq!(world.taken, [taken(2), taken(1), taken(1)]);
    assert_eq!((world.grains.id.as_slice(), world.removed, world.born), ([3].as_slice(), 4, 5));
}

#[test]
fn coincident_places_are_found() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    let at = |x: f64| Grain::at([x, 0.0, 0.0], 1e-3);
    let apart = world(&scene, &[at(0.0), at(1e-3), at(5e-3)]);
    assert_eq!(coincident(&apart.grains, &scene.domain), None);
    let twins = world(&scene, &[at(0.0), at(1e-3), at(5e-3), at(1e-3)]);
    assert_eq!(coincident(&twins.grains, &scene.domain), Some((1, 3)));
    assert_eq!(coincident::<3>(&Grains::new(), &scene.domain), None);
}

#[test]
fn a_feed_keeps_its_rate_while_there_is_room_and_counts_refusals_when_there_is_none() {
    let feed = |flow: Flow| Feed {
        batch: batch(1e-3),
        region: Region::Box(BoxRegion {
            lower: Vector::from([0.0, 0.0, 0.5]),
            upper: Vector::from([0.02, 0.02, 0.51]),
        }),
        flow,
        start: 0.05,
        stop: 0.15,
        random: Random::new(9),
        fed: 0.0,
        count: 0,
        refused: 0,
        waiting: None,
    };
    let fed = |gravity: f64, flow: Flow| {
        let scene = Scene::<3>::new(glass(0.9, 0.3), hertz()).with_gravity([0.0, 0.0, gravity]);
        let mut world = World::new();
        world.feeds.push(feed(flow));
        for _ in 0..40 {
            run(&scene, &mut world, 5e-3, 50).unwrap();
            turn_over(&scene, &mut world).unwrap();
        }
        (world.grains.len(), world.feeds[0].refused)
    };
    let mass = 2500.0 * volume::<3>(1e-3, 1.0);
    assert_eq!(fed(-9.81, Flow::Number(1000.0)).0, 100);
    assert_eq!(fed(-9.81, Flow::Mass(1000.0 * mass)).0, 100);
    // Without gravity nothing makes room.
    let (count, refused) = fed(0.0, Flow::Number(20_000.0));
    assert!(count < 400 && refused > 5, "{count} fed, {refused} refused");
}
