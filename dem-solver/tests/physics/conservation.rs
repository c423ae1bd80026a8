use crate::scenes::{floor, gas, glass, hertz, hooke, run, world};
use dem_solver::{Grain, Scene, Spin, World};

fn angular_momentum(world: &World<3>) -> Spin {
    let grains = &world.grains;
    (0..grains.len())
        .map(|k| {
            let (m, place) = (&grains.motion[k], &grains.place[k]);
            place.centre.cross(&m.velocity) * grains.mass[k] + m.angular_velocity / m.inverse_inertia
        })
        .sum()
}

#[test]
fn a_rubbing_gas_keeps_its_momentum_to_rounding() {
    for law in [hertz(), hooke()] {
        let (scene, mut world) = gas(law, 0.8, 0.5, 0.012);
        let ledger = run(&scene, &mut world, 5e-3, 1000).unwrap();
        assert!(
            ledger.kinetic_energy < 0.9 * crate::scenes::kinetic_energy(&gas(law, 0.8, 0.5, 0.012).1),
            "it did collide"
        );
        let scale: f64 = world
            .grains
            .motion
            .iter()
            .zip(&world.grains.mass)
            .map(|(m, mass)| mass * m.velocity.norm())
            .sum();
        assert!(ledger.residual().norm() < 1e-12 * scale, "{}", ledger.residual().norm() / scale);
    }
}

#[test]
fn a_rubbing_cloud_keeps_its_angular_momentum_to_rounding() {
    let (_, mut world) = gas(hertz(), 0.8, 0.5, 0.0105);
    let scene = Scene::<3>::new(glass(0.8, 0.5), hertz());
    world.grains.place.iter_mut().for_each(|place| place.centre *= 0.8);
    let before = angular_momentum(&world);
    let scale: f64 = (0..world.grains.len())
        .map(|k| {
            let (m, place) = (&world.grains.motion[k], &world.grains.place[k]);
            world.grains.mass[k] * m.velocity.norm() * place.centre.norm()
                + m.angular_velocity.norm() / m.inverse_inertia
        })
        .sum();
    run(&scene, &mut world, 2e-3, 2000).unwrap();
    let change = (angular_momentum(&world) - before).norm();
    assert!(change < 1e-12 * scale, "{}", change / scale);
}

#[test]
fn gravity_walls_and_frozen_grains_account_for_all_momentum() {
    let scene = Scene::<3>::new(glass(0.7, 0.4), hertz()).with_gravity([1.0, 0.0, -9.81]).with_walls(floor());
    let mut grains = vec![Grain::at([0.0, 0.0, 0.0], 2e-3).frozen()];
    for k in 0..8 {
        let k = f64::from(k);
        grains.push(
            Grain::at([1e-3 * (k - 3.5), 2e-4 * k, 3.2e-3 + 2.1e-3 * k], 1e-3).moving([0.1, 0.0, -1.0]),
        );
    }
    let mut world = world(&scene, &grains);
    let (mut walls, mut frozen) = (0.0_f64, 0.0_f64);
    for _ in 0..20 {
        let ledger = run(&scene, &mut world, 1e-3, 200).unwrap();
        assert!(
            ledger.residual().norm() < 1e-13 * ledger.scale,
            "{}",
            ledger.residual().norm() / ledger.scale
        );
        walls = walls.max(ledger.walls.norm() / ledger.scale);
        frozen = frozen.max(ledger.frozen.norm() / ledger.scale);
    }
    assert!(walls > 0.1 && frozen > 0.1, "both were hit: {walls}, {frozen}");
}
