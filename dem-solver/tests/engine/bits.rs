//! The same bits from any lanes and any number of threads.

use dem_solver::contact::cohesion::CohesionLaw::{Capillary, Jkr, Sjkr, Sjkr2};
use dem_solver::contact::rolling::RollingLaw::{Cdt, Epsd, Epsd2};
use dem_solver::lanes::Backend;
use dem_solver::{Scene, Workspace, World, turn_over, window};

use super::scenes::{
    HERTZ, HOOKE, LIGGGHTS_HERTZ, LIGGGHTS_HOOKE, PARTIAL_SLIP, STEP, adhesive, boxed, discs, one_to_twenty,
    periodic, sticky,
};

/// The world after some windows.
fn end<const D: usize>((scene, world): &(Scene<D>, World<D>), backend: Backend, threads: usize) -> World<D> {
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
        one_to_twenty(),
        boxed(5, true, LIGGGHTS_HERTZ, 0.5),
        boxed(5, false, LIGGGHTS_HOOKE, 0.5),
        boxed(5, false, LIGGGHTS_HERTZ, 0.0),
        sticky(5, false, HERTZ, (Epsd, Sjkr)),
        sticky(5, true, HERTZ, (Epsd, Sjkr)),
        sticky(5, true, LIGGGHTS_HERTZ, (Epsd2, Sjkr2)),
        sticky(5, true, LIGGGHTS_HOOKE, (Cdt, Sjkr)),
        adhesive(5, Jkr, 0.5),
        adhesive(5, Capillary, 0.0),
    ];
    scenes.iter().enumerate().for_each(|(k, scene)| same_on_all_lanes(k, scene));
}

#[test]
fn every_set_of_lanes_computes_the_same_bits_in_two_dimensions() {
    let scenes = [discs(HERTZ, 0.5), discs(HOOKE, 0.5), discs(LIGGGHTS_HERTZ, 0.5), discs(HERTZ, 0.0)];
    scenes.iter().enumerate().for_each(|(k, scene)| same_on_all_lanes(k, scene));
}

fn same_on_all_lanes<const D: usize>(k: usize, scene: &(Scene<D>, World<D>)) {
    let all = Backend::available();
    let plain = end(scene, all[0], 1);
    assert!(plain.grains.motion != scene.1.grains.motion);
    for &backend in &all[1..] {
        assert!(end(scene, backend, 1) == plain, "scene {k}: {} differs", backend.name());
    }
}

#[test]
fn two_and_four_threads_compute_the_same_bits_as_one() {
    let scenes = [
        boxed(30, true, HERTZ, 0.5),
        boxed(30, true, PARTIAL_SLIP, 0.5),
        periodic(30, false),
        sticky(30, true, LIGGGHTS_HERTZ, (Epsd2, Sjkr2)),
        adhesive(30, Jkr, 0.5),
    ];
    for scene in scenes {
        let one = end(&scene, Backend::best(), 1);
        assert!(end(&scene, Backend::best(), 2) == one);
        assert!(end(&scene, Backend::best(), 4) == one);
    }
}
