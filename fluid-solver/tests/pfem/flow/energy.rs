//! What goes over between nodes takes its velocity along; a projection takes energy and gives none.

use crate::support::{WATER, advance, block, flow, momentum, volume};
use fluid_solver::backend::pfem::cloud::Cloud;
use fluid_solver::backend::pfem::flow::Forces;
use fluid_solver::backend::pfem::remesh::energy;

const LENGTH: f64 = 0.2;

/// A square or cube of uneven cells turns about the last axis for some steps, and nothing acts on it: the largest change of its
/// mean velocity (m/s), and its largest energy as a share of the first.
fn turning<const D: usize, const N: usize>(cells: usize) -> [f64; 2] {
    let mut cloud: Cloud<D, N> = block([LENGTH; D], [cells; D], 0.2);
    for (v, x) in cloud.velocity.iter_mut().zip(&cloud.place) {
        (v[0], v[1]) = (-10.0 * (x[1] - 0.5 * LENGTH), 10.0 * (x[0] - 0.5 * LENGTH));
    }
    let mean = |cloud: &Cloud<D, N>| momentum(cloud).map(|momentum| momentum / volume(cloud));
    let (start, first, mut worst) = (mean(&cloud), energy(&cloud).kinetic, [0.0f64; 2]);
    let forces = Forces { gravity: [0.0; D], grains: None };
    advance(&mut flow(WATER, 1e-8), &mut cloud, &[], &forces, 2e-3, 0..15, |cloud, _| {
        let change = (0..D).map(|k| (mean(cloud)[k] - start[k]).abs()).fold(0.0, f64::max);
        worst = [worst[0].max(change), worst[1].max(energy(cloud).kinetic / first)];
    });
    worst
}

#[test]
fn a_body_that_turns_in_space_keeps_its_momentum_and_its_energy() {
    for ([momentum, energy], gained) in [(turning::<2, 3>(10), 5e-5), (turning::<3, 4>(5), 2e-4)] {
        println!("a body that turns: momentum {momentum:e} m/s, energy 1 + {:e}", energy - 1.0);
        assert!(momentum <= 2e-7, "{momentum:e} m/s");
        assert!(energy <= 1.0 + gained, "{energy}");
    }
}

#[test]
fn a_film_flatter_than_a_sliver_gains_no_energy_after_a_blow_to_a_node_of_it() {
    for thickness in [0.02, 0.005, 0.001] {
        let mut cloud: Cloud<3, 4> = block([1.0, 1.0, 0.25 * thickness], [4, 4, 1], 0.0);
        let struck = cloud.place.iter().position(|x| x[..2] == [0.5; 2] && x[2] > 0.0).unwrap();
        cloud.velocity[struck][2] = -1.0;
        let forces = Forces { gravity: [0.0; 3], grains: None };
        let mut last = energy(&cloud).kinetic;
        advance(&mut flow(WATER, 1e-8), &mut cloud, &[], &forces, 1e-9, 0..10, |cloud, _| {
            let kinetic = energy(cloud).kinetic;
            assert!(kinetic <= (1.0 + 1e-6) * last, "{thickness}: {}", kinetic / last);
            last = kinetic;
        });
    }
}
