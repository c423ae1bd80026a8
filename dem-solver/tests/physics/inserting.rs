use crate::scenes::{floor, glass, hertz, run, world};
use dem_solver::insertion::{Amount, Batch, Feed, Flow, Random, RandomBox, Sizes, coincident};
use dem_solver::{Domain, Grain, Scene, Vector, World, turn_over, volume};

fn batch(radius: f64) -> Batch<3> {
    Batch {
        name: "rain".into(),
        material: 0,
        sizes: Sizes::all(radius),
        velocity: Vector::zeros(),
        frozen: false,
    }
}

fn box_of(amount: Amount) -> RandomBox<3> {
    RandomBox { lower: Vector::zeros(), upper: Vector::from_element(0.02), amount }
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
    assert!(insert(Amount::Count(1), 1.0).contains(": 0 of 1 grains fitted"));
}

#[test]
fn coincident_places_are_found() {
    let scene = Scene::<3>::new(glass(0.9, 0.3), hertz());
    let at = |x: f64| Grain::at([x, 0.0, 0.0], 1e-3);
    let apart = world(&scene, &[at(0.0), at(1e-3), at(5e-3)]);
    assert_eq!(coincident(&apart.grains.place, &scene.domain), None);
    let twins = world(&scene, &[at(0.0), at(1e-3), at(5e-3), at(1e-3)]);
    assert_eq!(coincident(&twins.grains.place, &scene.domain), Some((1, 3)));
    assert_eq!(coincident::<3>(&[], &scene.domain), None);
}

#[test]
fn a_feed_keeps_its_rate_while_there_is_room_and_counts_refusals_when_there_is_none() {
    let feed = |flow: Flow| Feed {
        batch: batch(1e-3),
        lower: Vector::from([0.0, 0.0, 0.5]),
        upper: Vector::from([0.02, 0.02, 0.51]),
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
