#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::scenes::{RADIUS, body, floor, kind, member, placed, run, scene};
use dem_solver::{Substep, World, critical_time_step, substeps};

#[test]
fn a_rod_at_rest_on_a_plane_stays_at_rest() {
    let offsets = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| member([k * RADIUS, 0.0, 0.0], RADIUS));
    let scene =
        scene(1e7, (0.3, 0.5), vec![kind(&offsets)]).with_walls(floor()).with_gravity([0.0, 0.0, -9.81]);
    let mut world = World::new();
    world.add_clump(&scene, 0, placed(&scene.clumps[0], [0.0, 0.0, RADIUS], [0.0; 3], [0.0; 3], [0.0; 3]));
    let on = |world: &mut World<3>, windows: u32| {
        for _ in 0..windows {
            let count = substeps(0.01, Substep::Fraction(0.5), &critical_time_step(&scene, world)).unwrap();
            run(&scene, world, 0.01, count);
        }
    };
    on(&mut world, 20);
    let settled = body(&world, 0);
    on(&mut world, 100);
    let after = body(&world, 0);
    let moved = (after.centre - settled.centre).norm() / RADIUS;
    let turned = after.orientation.angle_to(&settled.orientation);
    println!("a rod at rest for 1 s: moved by {moved:.1e} radii, turned by {turned:.1e}");
    assert!(moved < 1e-9 && turned < 1e-9);
    assert!(after.velocity.norm() < 1e-9);
}

#[test]
fn a_rod_on_a_slope_below_the_angle_of_friction_stays_and_above_it_slides_as_a_block() {
    let offsets = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| member([k * RADIUS, 0.0, 0.0], RADIUS));
    // Along the slope it cannot roll: x is down the slope.
    for (slope, friction) in [(0.3_f64, 0.5), (0.6, 0.4)] {
        let gravity = [9.81 * slope.sin(), 0.0, -9.81 * slope.cos()];
        let scene =
            scene(1e8, (0.3, friction), vec![kind(&offsets)]).with_walls(floor()).with_gravity(gravity);
        let mut world = World::new();
        let start = [0.0, 0.0, RADIUS];
        world.add_clump(&scene, 0, placed(&scene.clumps[0], start, [0.0; 3], [0.0; 3], [0.0; 3]));
        let count = substeps(0.1, Substep::Fraction(0.5), &critical_time_step(&scene, &world)).unwrap();
        run(&scene, &mut world, 0.1, 2 * count);
        let speed = body(&world, 0).velocity.x;
        let block = 0.1 * 9.81 * (slope.sin() - friction * slope.cos()).max(0.0);
        assert!((speed - block).abs() < 2e-3 * 0.1 * 9.81, "{speed} instead of {block}");
    }
}
