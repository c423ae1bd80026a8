use crate::scenes::{BOUND, G, RADIUS, asleep, glass, pass, scene, sleeping_heaps};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;
use dem_solver::{Grain, Scene, SleepBound, Workspace, World, window};

/// Bounds wide enough to catch what must not sleep.
const WIDE: SleepBound = SleepBound { speed: 0.01, acceleration: 0.5 * G };

fn lone(gravity: f64, bound: SleepBound, grain: Grain<3>) -> (Scene<3>, World<3>) {
    let scene = Scene::<3>::new(glass(), NormalLaw::Hertz(Hertz { depth: 1.0 }))
        .with_gravity([0.0, 0.0, -gravity])
        .with_sleep(bound);
    let mut world = World::new();
    world.add(&scene, &grain);
    (scene, world)
}

#[test]
fn heaps_at_rest_sleep_and_their_foot_carries_them() {
    let (scene, mut world) = (scene([]).with_sleep(BOUND), sleeping_heaps());
    let places = world.grains.place.clone();
    let mut workspace = Workspace::new();
    for _ in 0..5 {
        let ledger = pass(&scene, &mut world, &mut workspace);
        assert_eq!(asleep(&world), world.grains.len());
        assert_eq!(ledger.kinetic_energy, 0.0);
        let weight = -ledger.gravity.z;
        assert!((ledger.frozen.z / weight - 1.0).abs() < 1e-4, "{} of {weight}", ledger.frozen.z);
        assert!(ledger.asleep.norm() < 1e-4 * weight, "held by {}", ledger.asleep.norm() / weight);
        assert!(ledger.residual().norm() < 1e-13 * ledger.scale, "{:?}", ledger.residual());
    }
    assert!(world.grains.place == places);
    assert!(world.contacts.slumber.fallings >= 1200);
}

#[test]
fn a_long_rest_costs_a_hundredth() {
    let (scene, mut world) = (scene([]).with_sleep(BOUND), sleeping_heaps());
    let before = world.contacts.slumber;
    let (windows, substeps) = (4, 500);
    for _ in 0..windows {
        window(&scene, &mut world, &mut Workspace::new(), None, 5e-3, substeps).unwrap();
    }
    let steps = u64::from(windows * substeps) * world.grains.len() as u64;
    let after = world.contacts.slumber;
    assert_eq!(after.grain_steps - before.grain_steps, steps);
    let worked = steps - (after.grain_steps_without_forces - before.grain_steps_without_forces);
    // Once a window all forces are found.
    assert!(worked * 100 <= steps, "{worked} of {steps} grain-steps");
}

#[test]
fn a_grain_at_the_top_of_its_flight_stays_awake() {
    for bound in [BOUND, WIDE] {
        let (scene, mut world) = lone(G, bound, Grain::at([0.0; 3], RADIUS).moving([0.0, 0.0, 0.1]));
        let mut workspace = Workspace::new();
        for _ in 0..40 {
            window(&scene, &mut world, &mut workspace, None, 5e-4, 50).unwrap();
            assert_eq!(asleep(&world), 0);
        }
        let t = world.time;
        assert!((world.grains.place[0].centre.z - (0.1 * t - 0.5 * G * t * t)).abs() < 1e-15);
        assert!(world.grains.motion[0].velocity.z < 0.0, "it has turned");
    }
}

#[test]
fn a_grain_that_spins_in_place_stays_awake_and_a_slower_one_does_not() {
    for (surface_speed, sleeps) in [(1.01, 0), (0.99, 1)] {
        let spin = surface_speed * WIDE.speed / RADIUS;
        let (scene, mut world) = lone(0.0, WIDE, Grain::at([0.0; 3], RADIUS).spinning([spin, 0.0, 0.0]));
        window(&scene, &mut world, &mut Workspace::new(), None, 1.5 * WIDE.patience(), 100).unwrap();
        assert_eq!(asleep(&world), sleeps);
    }
}

#[test]
fn only_what_was_quiet_long_enough_sleeps() {
    let (scene, mut world) = lone(0.0, WIDE, Grain::at([0.0; 3], RADIUS));
    for (share, sleeps) in [(0.9, 0), (0.2, 1)] {
        window(&scene, &mut world, &mut Workspace::new(), None, share * WIDE.patience(), 100).unwrap();
        assert_eq!(asleep(&world), sleeps, "at {} s", world.time);
    }
}
