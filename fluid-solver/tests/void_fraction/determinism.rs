use crate::scene::{Scene, random_grains, unit_box};
use fluid_solver::deposit::Deposit;
use fluid_solver::sample::sample;

/// Every bit of weights, void fraction, deposit and samples.
fn bits(threads: usize) -> Vec<u64> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let mut scene = Scene::<3, 4>::new(unit_box(7, false, 0.3), 0.02, 0.3);
        let grains = random_grains::<3>(5000, 0.02, 0.3);
        let volumes = vec![1e-5; grains.len()];
        let mut values = scene.void_fraction(&grains, &volumes, 0.0).unwrap();
        (0..grains.len()).for_each(|grain| values.extend(scene.weights.row(grain).1));
        let forces: Vec<[f64; 3]> = grains.iter().map(|grain| grain.position).collect();
        let (mut nodal, mut samples) =
            (vec![[0.0; 3]; scene.mesh.node_count()], vec![[0.0; 3]; grains.len()]);
        Deposit::default().apply(&scene.weights, &forces, &mut nodal);
        sample(&scene.weights, &nodal, &mut samples);
        values.extend(nodal.iter().chain(&samples).flatten());
        values.into_iter().map(f64::to_bits).collect()
    })
}

#[test]
fn one_two_and_four_threads_give_the_same_bits() {
    let one = bits(1);
    assert!(one.len() > 500_000);
    assert!(one == bits(2));
    assert!(one == bits(4));
}

#[test]
fn the_remembered_hosts_and_the_old_weights_leave_no_trace() {
    let mut fresh = Scene::<3, 4>::new(unit_box(7, true, 0.3), 0.02, 0.3);
    let grains = random_grains::<3>(1000, 0.02, 0.3);
    fresh.weigh(&grains).unwrap();
    let mut used = Scene::<3, 4>::new(unit_box(7, true, 0.3), 0.02, 0.3);
    let elsewhere: Vec<_> = random_grains::<3>(3000, 0.02, 0.3).into_iter().rev().collect();
    used.weigh(&elsewhere).unwrap();
    used.weigh(&grains).unwrap();
    assert!(used.weights == fresh.weights && used.hosts == fresh.hosts);
}

#[test]
fn rebuilding_the_weights_of_the_same_grains_takes_no_new_memory() {
    let mut scene = Scene::<3, 4>::new(unit_box(7, false, 0.0), 0.02, 0.3);
    let grains = random_grains::<3>(1000, 0.02, 0.3);
    scene.weigh(&grains).unwrap();
    let held = scene.weights.memory();
    scene.weigh(&grains).unwrap();
    assert_eq!(scene.weights.memory(), held);
}
