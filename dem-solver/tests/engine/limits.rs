//! Scenes at the edge: no law, coincident centres, numbers that are none.

use dem_solver::contact::NormalLaw;
use dem_solver::{DemError, Fault, Ledger, Scene, Workspace, World, turn_over, window};

use super::scenes::{HERTZ, STEP, boxed, periodic};

fn run(scene: &Scene<3>, world: &mut World<3>, steps: u32) -> Result<Ledger<3>, DemError> {
    window(scene, world, &mut Workspace::new(), None, f64::from(steps) * STEP, steps)
}

#[test]
fn without_a_contact_law_grains_fall_through_each_other() {
    let (scene, start) = boxed(2, false, NormalLaw::None, 0.0);
    let mut world = start.clone();
    run(&scene, &mut world, 100).unwrap();
    for (after, before) in world.grains.motion.iter().zip(&start.grains.motion) {
        assert!((after.velocity.z - before.velocity.z + 9.81 * 100.0 * STEP).abs() < 1e-15);
        assert_eq!(after.velocity.xy(), before.velocity.xy());
    }
}

#[test]
fn two_grains_in_one_place_are_named() {
    let (scene, mut world) = boxed(1, false, HERTZ, 0.5);
    world.grains.place[17].centre = world.grains.place[16].centre;
    world.grains.motion[17] = world.grains.motion[16];
    let Err(DemError::Fault { fault: Fault::Coincident { one, other }, .. }) = run(&scene, &mut world, 1)
    else {
        panic!("the step must not succeed");
    };
    assert_eq!((one.min(other), one.max(other)), (16, 17));
}

#[test]
fn a_number_that_is_none_is_named() {
    let (scene, start) = boxed(1, false, HERTZ, 0.5);
    let mut spun = start.clone();
    spun.grains.motion[5].angular_velocity.x = f64::NAN;
    let mut lost = start;
    lost.grains.place[5].centre.y = f64::NAN;
    for mut world in [spun, lost] {
        let fault = run(&scene, &mut world, 1);
        assert!(matches!(fault, Err(DemError::Fault { fault: Fault::NotFinite { .. }, .. })), "{fault:?}");
    }
}

#[test]
fn a_motion_that_all_grains_share_makes_no_list() {
    let (scene, mut world) = periodic(3, false);
    for (place, motion) in world.grains.place.iter_mut().zip(&mut world.grains.motion) {
        // Apart, so that nothing touches and nothing slows.
        place.radius *= 0.9;
        motion.velocity = [20.0, -10.0, 5.0].into();
    }
    run(&scene, &mut world, 10).unwrap();
    let before = world.contacts.counters;
    run(&scene, &mut world, 400).unwrap();
    assert_eq!(world.contacts.counters, before);
}

#[test]
fn an_empty_periodic_box_takes_its_steps() {
    let (scene, _) = periodic(1, false);
    let mut world = World::new();
    turn_over(&scene, &mut world).unwrap();
    run(&scene, &mut world, 10).unwrap();
    assert!(world.grains.is_empty());
}
