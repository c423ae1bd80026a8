use crate::scenes::{BOUND, G, RADIUS, WINDOW, asleep, drop_one, glass, pass, scene, sleeping_heaps};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;
use dem_solver::{Grain, Scene, Vector, Workspace, World, inertia, window};

#[test]
fn the_energy_and_the_momentum_that_sleep_takes_are_counted() {
    let (v, spin) = (0.5 * BOUND.speed, 0.5 * BOUND.speed / RADIUS);
    let scene = Scene::<3>::new(glass(), NormalLaw::Hertz(Hertz { depth: 1.0 })).with_sleep(BOUND);
    let mut world = World::new();
    for k in 0..3 {
        let at = [4.0 * RADIUS * f64::from(k), 0.0, 0.0];
        world.add(&scene, &Grain::at(at, RADIUS).moving([0.0, v, 0.0]).spinning([0.0, spin, 0.0]));
    }
    let mass = world.grains.mass[0];
    let kinetic = 1.5 * (mass * v * v + inertia::<3>(mass, RADIUS) * spin * spin);
    let mut workspace = Workspace::new();
    let ledger = window(&scene, &mut world, &mut workspace, None, 1.5 * BOUND.patience(), 100).unwrap();
    let slumber = world.contacts.slumber;
    assert_eq!((asleep(&world), slumber.fallings, slumber.wakings), (3, 3, 0));
    assert!((slumber.energy / kinetic - 1.0).abs() < 1e-14 && ledger.kinetic_energy == 0.0);
    let momentum = Vector::from([0.0, 3.0 * mass * v, 0.0]);
    assert!((ledger.asleep + momentum).norm() < 1e-14 * momentum.norm());
    assert!(ledger.residual().norm() < 1e-14 * ledger.scale);
}

#[test]
fn the_books_close_while_grains_fall_asleep_and_wake() {
    let (scene, mut world) = (scene([]).with_sleep(BOUND), sleeping_heaps());
    drop_one(&scene, &mut world, 0.1);
    let before = world.contacts.slumber;
    let mut workspace = Workspace::new();
    for _ in 0..60 {
        let ledger = pass(&scene, &mut world, &mut workspace);
        assert!(ledger.residual().norm() < 1e-12 * ledger.scale, "{:?} at {}", ledger.residual(), world.time);
    }
    let after = world.contacts.slumber;
    assert!(after.wakings > before.wakings && after.fallings > before.fallings, "{after:?}");
    let total: f64 = world.grains.mass.iter().sum();
    let bound = (after.fallings - before.fallings) as f64 * total / world.grains.len() as f64;
    assert!(after.energy - before.energy < bound * BOUND.speed * BOUND.speed, "{after:?}");
}

#[test]
fn frozen_grains_carry_what_sleeps_on_them() {
    let scene = Scene::<3>::new(glass(), NormalLaw::Hertz(Hertz { depth: 1.0 }))
        .with_gravity([0.0, 0.0, -G])
        .with_sleep(BOUND);
    let mut world = World::new();
    let at = |x: f64, y: f64, z: f64| Grain::at([x * RADIUS, y * RADIUS, z * RADIUS], RADIUS);
    for (x, y) in [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0), (2.0, 2.0)] {
        world.add(&scene, &at(x, y, 0.0).frozen());
    }
    world.add(&scene, &at(1.0, 1.0, 2.0_f64.sqrt()));
    let mut workspace = Workspace::new();
    for _ in 0..40 {
        let ledger = pass(&scene, &mut world, &mut workspace);
        assert!(ledger.residual().norm() < 1e-12 * ledger.scale, "{:?}", ledger.residual());
    }
    let ledger = window(&scene, &mut world, &mut workspace, None, WINDOW, 500).unwrap();
    assert_eq!(asleep(&world), 5);
    assert!((ledger.frozen.z / -ledger.gravity.z - 1.0).abs() < 1e-3, "{:?}", ledger.frozen);
}
