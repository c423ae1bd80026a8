use std::sync::Arc;

use crate::scenes::{RADIUS, body, kinetic_energy, member, run};
use dem_solver::body::{Clump, ClumpKind};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hooke;
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Material, Materials, Scene, Spin, World};
use nalgebra::UnitQuaternion;

#[test]
fn in_the_plane_a_pair_of_discs_bounces_as_the_exact_impulse_says_and_stays_in_the_plane() {
    let (r, depth, speed, angle) = (RADIUS, 0.01, 0.01, 0.5_f64);
    let discs = [member([-0.6 * r, 0.0, 0.0], r), member([0.6 * r, 0.0, 0.0], r)];
    let shape = Arc::new(Clump::of_discs(&discs, 2500.0, depth).unwrap());
    let material = Material { density: 2500.0, youngs_modulus: 1e11, poissons_ratio: 0.3 };
    let materials = Materials::new(vec![material], |_, _| (1.0, 0.0));
    let law = NormalLaw::Hooke(Hooke { characteristic_velocity: 1.0, depth });
    let floor = Walls::new(vec![Wall::plane("floor", 0, [0.0; 2], [0.0, 1.0])]);
    let kind = ClumpKind { shape: shape.clone(), material: 0, volume: shape.mass() / 2500.0 };
    let scene = Scene::<2>::new(materials, law).with_walls(floor).with_clumps(vec![kind]);
    let turn = UnitQuaternion::from_scaled_axis(Spin::new(0.0, 0.0, angle));
    let start = Spin::new(0.0, 0.6 * r * angle.sin() + r + 1e-8, 0.0);
    let mut world = World::new();
    world.add_clump(&scene, 0, shape.body(start, turn, Spin::new(0.0, -speed, 0.0), Spin::zeros()));
    let energy = kinetic_energy(&world);
    run(&scene, &mut world, 4e-5, 4000);
    let after = body(&world, 0);
    let lever = 0.6 * r * angle.cos();
    let impulse = 2.0 * speed / (1.0 / shape.mass() + lever * lever / shape.moments()[2]);
    let spin = after.angular_velocity(&shape);
    assert!(
        (after.velocity.y - (impulse / shape.mass() - speed)).abs() < 1e-3 * speed,
        "{}",
        after.velocity.y
    );
    assert!((spin.z.abs() - lever * impulse / shape.moments()[2]).abs() < 1e-3 * spin.norm(), "{spin}");
    assert!((kinetic_energy(&world) - energy).abs() < 1e-4 * energy);
    assert_eq!((after.centre.z, after.velocity.z, spin.x, spin.y), (0.0, 0.0, 0.0, 0.0));
}
