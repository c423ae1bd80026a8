#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use crate::shapes::{DENSITY, at_rest, jack};
use dem_solver::Vector;
use dem_solver::body::{Body, Clump, Load};
use nalgebra::UnitQuaternion;

fn loads(count: usize) -> Vec<Load> {
    (0..count)
        .map(|k| {
            let k = k as f64;
            Load { force: Vector::from([1.0, k, -2.0]), torque: Vector::from([0.0, 1e-3 * k, 1e-3]) }
        })
        .collect()
}

#[test]
fn loads_on_members_give_the_body_their_momentum_and_moment() {
    let clump = Clump::of_spheres(&jack(), DENSITY).unwrap();
    let turn = UnitQuaternion::from_euler_angles(0.3, -1.2, 2.0);
    let origin = Vector::from([0.01, 0.02, -0.01]);
    let start = clump.body(origin, turn, Vector::zeros(), Vector::zeros());
    let mut body = start;
    let all = loads(5);
    body.kick(&clump, &start.gather(&clump, all.iter().copied()), 1e-3);
    let force: Vector<3> = all.iter().map(|load| load.force).sum();
    let moment: Vector<3> =
        start.members(&clump).zip(&all).map(|(m, load)| m.centre.cross(&load.force) + load.torque).sum();
    let angular = body.angular_momentum + body.centre.cross(&body.velocity) * clump.mass();
    assert!((body.velocity * clump.mass() - force * 1e-3).norm() < 1e-15 * force.norm());
    assert!((angular - moment * 1e-3).norm() < 1e-14 * moment.norm());
    assert_eq!((body.centre, body.orientation), (start.centre, start.orientation), "a kick takes no time");
}

#[test]
fn inner_loads_of_members_move_nothing() {
    let clump = Clump::of_spheres(&jack(), DENSITY).unwrap();
    let body = at_rest(&clump);
    let places: Vec<Vector<3>> = body.members(&clump).map(|member| member.centre).collect();
    // Two members push each other along the line of their centres.
    let push = (places[3] - places[1]) * 100.0;
    let none = Vector::zeros();
    let forces = [none, -push, none, push, none];
    let total = body.gather(&clump, forces.map(|force| Load { force, torque: none }));
    assert!(total.force.norm() == 0.0 && total.torque.norm() < 1e-15 * push.norm() * places[3].norm() * 10.0);
}

/// Largest deviation of the energy of a heavy body hung from a soft spring at one member, and of the vertical angular
/// momentum, which only a load through the axis keeps.
fn swing(step: f64) -> f64 {
    let clump = Clump::of_spheres(&jack(), DENSITY).unwrap();
    let spin = Vector::from([20.0, 30.0, 10.0]);
    let mut body = clump.body(Vector::zeros(), UnitQuaternion::identity(), Vector::zeros(), spin);
    let (stiffness, gravity) = (1.0, Vector::from([0.0, 0.0, -9.81]));
    let hung = |body: &Body| body.members(&clump).nth(1).unwrap().centre;
    let anchor = hung(&body);
    let energy = |body: &Body| {
        body.kinetic_energy(&clump) + 0.5 * stiffness * (hung(body) - anchor).norm_squared()
            - clump.mass() * gravity.dot(&body.centre)
    };
    let start = energy(&body);
    let mut worst = 0.0_f64;
    for _ in 0..(0.5 / step) as usize {
        body.drift(&clump, 0.5 * step);
        let pull = (anchor - hung(&body)) * stiffness;
        let none = Load { force: Vector::zeros(), torque: Vector::zeros() };
        let loads = (0..5).map(|k| if k == 1 { Load { force: pull, ..none } } else { none });
        let mut total = body.gather(&clump, loads);
        total.force += gravity * clump.mass();
        body.kick(&clump, &total, step);
        body.drift(&clump, 0.5 * step);
        worst = worst.max((energy(&body) / start - 1.0).abs());
    }
    worst
}

#[test]
fn half_a_flight_kick_half_a_flight_is_of_second_order() {
    let [coarse, fine] = [2e-4, 1e-4].map(swing);
    println!("energy of a body on a spring: {coarse:.1e} at 0.2 ms, {fine:.1e} at 0.1 ms");
    assert!((3.6..4.4).contains(&(coarse / fine)), "{coarse}/{fine}");
    assert!(fine < 1e-3, "{fine}");
}
