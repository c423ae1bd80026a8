//! The same bits from any lanes and any number of threads.

use dem_solver::lanes::Backend;
use dem_solver::{Scene, Workspace, World, turn_over, window};

use super::scenes::{HERTZ, HOOKE, PARTIAL_SLIP, STEP, adhesive, boxed, periodic, sticky};
use dem_solver::contact::cohesion::CohesionLaw;

/// The world after some windows.
fn end((scene, world): &(Scene<3>, World<3>), backend: Backend, threads: usize) -> World<3> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let (mut world, mut workspace) = (world.clone(), Workspace::on(backend));
        for _ in 0..3 {
            window(scene, &mut world, &mut workspace, None, 60.0 * STEP, 60).unwrap();
            world.contacts.built_since_order = u32::MAX;
            assert!(turn_over(scene, &mut world).unwrap().order_changed);
        }
        let counters = world.contacts.counters;
        assert!(counters.inner > counters.outer, "the inner list is refreshed on its own");
        world
    })
}

#[test]
fn every_set_of_lanes_computes_the_same_bits() {
    let scenes = [
        boxed(5, false, HERTZ, 0.5),
        boxed(5, true, HERTZ, 0.5),
        boxed(5, false, HOOKE, 0.5),
        boxed(5, false, HERTZ, 0.0),
        boxed(5, true, HOOKE, 0.0),
        boxed(5, false, PARTIAL_SLIP, 0.5),
        boxed(5, true, PARTIAL_SLIP, 0.5),
        periodic(6, false),
        periodic(6, true),
        sticky(5, false),
        sticky(5, true),
        adhesive(5, CohesionLaw::Jkr, 0.5),
        adhesive(5, CohesionLaw::Capillary, 0.0),
    ];
    let all = Backend::available();
    for (k, scene) in scenes.iter().enumerate() {
        let plain = end(scene, all[0], 1);
        for &backend in &all[1..] {
            assert!(end(scene, backend, 1) == plain, "scene {k}: {} differs", backend.name());
        }
    }
}

#[test]
fn two_and_four_threads_compute_the_same_bits_as_one() {
    for scene in [
        boxed(30, true, HERTZ, 0.5),
        boxed(30, true, PARTIAL_SLIP, 0.5),
        periodic(30, false),
        sticky(30, true),
        adhesive(30, CohesionLaw::Jkr, 0.5),
    ] {
        let one = end(&scene, Backend::best(), 1);
        assert!(end(&scene, Backend::best(), 2) == one);
        assert!(end(&scene, Backend::best(), 4) == one);
    }
}
