use crate::scenes::{
    BOUND, FIRST, G, RADIUS, WINDOW, asleep, drop_one, furthest, pass, row, run, scene, sleeping_heaps, top,
};
use dem_solver::wall::{Motion, Wall};
use dem_solver::{Scene, Workspace, World, window};
use interface::HydroRow;

/// The same with sleep and without.
fn both(scene: &Scene<3>, world: &World<3>, work: impl Fn(&Scene<3>, &mut World<3>)) -> [World<3>; 2] {
    [Some(BOUND), None].map(|sleep| {
        let (scene, mut world) = (Scene { sleep, ..scene.clone() }, world.clone());
        work(&scene, &mut world);
        world
    })
}

#[test]
fn a_grain_dropped_on_a_sleeping_heap_wakes_it_and_comes_to_rest_where_it_would() {
    let (scene, mut world) = (scene([]), sleeping_heaps());
    let dropped = drop_one(&scene, &mut world, 0.1);
    let start = world.time;
    let before = world.contacts.slumber;
    let [slept, waked] = both(&scene, &world, |scene, world| run(scene, world, start + 0.2));
    let after = slept.contacts.slumber;
    assert!(after.wakings > before.wakings, "{after:?}");
    let slept_on = slept.contacts.slumber.grain_steps - before.grain_steps;
    assert!(slept_on > 0 && asleep(&slept) >= FIRST, "the far heaps sleep on");
    assert_eq!(waked.contacts.slumber.fallings, before.fallings, "the other never slept");
    let place = |world: &World<3>| world.grains.place[row(world, dropped)].centre;
    let apart = (place(&slept) - place(&waked)).norm();
    assert!(apart < 1e-3 * RADIUS, "{apart} m apart");
    let all = furthest(&slept, &waked);
    assert!(all < 1e-3 * RADIUS, "furthest {all} m");
    assert!(slept.grains.motion[row(&slept, dropped)].velocity.norm() < BOUND.speed);
}

#[test]
fn drag_wakes_where_it_moves_grains_and_is_passed_on_where_it_does_not() {
    let (scene, world) = (scene([]), sleeping_heaps());
    // As a share of the weight, upwards.
    for (share, wakes) in [(0.5e-3, false), (1.5, true)] {
        let rows: Vec<HydroRow> = world
            .grains
            .mass
            .iter()
            .map(|mass| HydroRow {
                exchange_coefficient: share * mass * G,
                fluid_velocity: [0.0, 0.0, 1.0],
                ..Default::default()
            })
            .collect();
        let [slept, waked] = both(&scene, &world, |scene, world| {
            let mut workspace = Workspace::new();
            let ledger = window(scene, world, &mut workspace, Some(&rows), WINDOW, 500).unwrap();
            assert!(ledger.residual().norm() < 1e-12 * ledger.scale, "{:?}", ledger.residual());
            let movers = rows.iter().zip(&world.grains.motion).filter(|(_, motion)| !motion.is_frozen());
            let given: f64 = movers.map(|(row, _)| row.exchange_coefficient * WINDOW).sum();
            let drag = if wakes { ledger.drag.z / given } else { 1.0 };
            assert!(drag > 0.9 && (wakes || (ledger.drag.z / given - 1.0).abs() < 1e-6));
            let rest = workspace.impulse.iter().map(|impulse| (impulse.drag + impulse.other).norm());
            let most = rest.fold(0.0, f64::max);
            let moves = wakes || scene.sleep.is_none();
            assert!(moves || most == 0.0, "what a sleeping grain feels is held: {most} N s");
        });
        assert_eq!(asleep(&slept), if wakes { 0 } else { slept.grains.len() });
        let apart = furthest(&slept, &waked);
        assert!(apart < 1e-4 * RADIUS, "{share}: {apart} m apart");
    }
}

#[test]
fn a_wall_that_comes_down_wakes_a_heap_when_it_touches() {
    let world = sleeping_heaps();
    let (speed, above) = (0.05, 5e-4);
    let motion = Motion::translation([0.0, 0.0, -speed]);
    let height = top(&world) + above + speed * world.time;
    let lid = Wall::plane("lid", 0, [0.0, 0.0, height], [0.0, 0.0, -1.0]).moving(motion);
    let start = world.time;
    let (scene, mut pressed) = (scene([lid]).with_sleep(BOUND), world.clone());
    run(&scene, &mut pressed, start + 0.5 * above / speed);
    assert_eq!(asleep(&pressed), pressed.grains.len(), "nothing touches yet");
    run(&scene, &mut pressed, start + 1.5 * above / speed);
    assert!(asleep(&pressed) < FIRST, "{} sleep", asleep(&pressed));
    assert!(top(&pressed) < top(&world) - 0.1 * above, "the lid went down with the grains below it");
}

#[test]
fn grains_fall_when_what_they_rest_on_is_taken_away() {
    let (scene, mut world) = (scene([]).with_sleep(BOUND), sleeping_heaps());
    let middle = 0.5 * top(&world);
    let staying: Vec<u32> = (0..world.grains.len() as u32)
        .filter(|&row| world.grains.place[row as usize].centre.z > middle)
        .collect();
    world.removed += (world.grains.len() - staying.len()) as u64;
    world.reorder(&staying);
    assert_eq!(asleep(&world), world.grains.len());
    let ledger = pass(&scene, &mut world, &mut Workspace::new());
    assert_eq!(asleep(&world), 0);
    let fall = -G * WINDOW;
    let mean = ledger.momentum.z / ledger.mass;
    assert!(mean < 0.9 * fall, "{mean} of {fall} m/s");
}
