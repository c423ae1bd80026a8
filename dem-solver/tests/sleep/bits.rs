use crate::scenes::{BOUND, asleep, drop_one, furthest, pass, scene, sleeping_heaps};
use dem_solver::lanes::Backend;
use dem_solver::{Saved, Scene, Workspace, World, window};

/// Heaps, a grain about to hit the small one.
fn struck() -> (Scene<3>, World<3>) {
    let (scene, mut world) = (scene([]).with_sleep(BOUND), sleeping_heaps());
    drop_one(&scene, &mut world, 0.05);
    (scene, world)
}

/// Some windows later.
fn end((scene, world): &(Scene<3>, World<3>), backend: Backend, threads: usize) -> World<3> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let (mut world, mut workspace) = (world.clone(), Workspace::on(backend));
        (0..3).for_each(|_| drop(pass(scene, &mut world, &mut workspace)));
        world
    })
}

#[test]
fn any_threads_and_any_lanes_give_the_same_bits() {
    let struck = struck();
    let one = end(&struck, Backend::best(), 1);
    assert!(asleep(&one) > 0 && asleep(&one) < one.grains.len(), "{} sleep", asleep(&one));
    for threads in [2, 4] {
        assert!(end(&struck, Backend::best(), threads) == one);
    }
    for backend in Backend::available() {
        assert!(end(&struck, backend, 1) == one, "{}", backend.name());
    }
}

#[test]
fn a_run_resumed_while_grains_sleep_goes_on_with_the_same_bits() {
    let (scene, mut world) = struck();
    let mut workspace = Workspace::new();
    pass(&scene, &mut world, &mut workspace);
    assert!(asleep(&world) > 0 && asleep(&world) < world.grains.len());
    let path = std::env::temp_dir().join(format!("dem-solver-asleep-{}.checkpoint", std::process::id()));
    world.write_checkpoint(&path).unwrap();
    let mut resumed = World::read_checkpoint(&path, &scene, vec![]).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(resumed == world);
    let mut saved = Saved::default();
    world.save(&mut saved);
    for _ in 0..3 {
        pass(&scene, &mut world, &mut workspace);
        pass(&scene, &mut resumed, &mut Workspace::new());
    }
    assert!(resumed == world);
    resumed.restore(&saved);
    (0..3).for_each(|_| drop(pass(&scene, &mut resumed, &mut workspace)));
    assert!(resumed == world, "so does one that is restored");
}

#[test]
fn lists_that_last_while_all_sleep_miss_nothing_that_comes_later() {
    // Against lists made anew in every step.
    let (scene, mut lasting) = struck();
    let mut anew = lasting.clone();
    let step = 1e-5;
    for _ in 0..100 {
        anew.contacts.expire();
        window(&scene, &mut anew, &mut Workspace::new(), None, step, 1).unwrap();
    }
    window(&scene, &mut lasting, &mut Workspace::new(), None, 100.0 * step, 100).unwrap();
    assert!(lasting.contacts.counters.outer + 90 < anew.contacts.counters.outer);
    assert!(asleep(&lasting) < lasting.grains.len());
    let apart = furthest(&lasting, &anew);
    assert!(apart < 1e-15, "{apart} m apart");
}
