#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::shapes::{DENSITY, jack, with_moments};
use dem_solver::Vector;
use dem_solver::body::{Body, Clump};
use dem_solver::{inertia, volume};
use nalgebra::UnitQuaternion;

/// Complete elliptic integral of the first kind, by the arithmetic-geometric mean.
fn elliptic_k(k_squared: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k_squared).sqrt());
    while (a - b).abs() > 1e-15 * a {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    FRAC_PI_2 / a
}

/// Time between flips of a body that spins about its intermediate axis at 1 rad/s and a little about its third.
///
/// Source: Landau & Lifshitz, Mechanics (3rd ed. 1976), section 37.
fn time_between_flips([i1, i2, i3]: [f64; 3], little: f64) -> f64 {
    let (twice_energy, square) = (i2 + i3 * little * little, i2 * i2 + (i3 * little).powi(2));
    let rate = ((i3 - i2) * (square - twice_energy * i1) / (i1 * i2 * i3)).sqrt();
    let k_squared = (i2 - i1) * (twice_energy * i3 - square) / ((i3 - i2) * (square - twice_energy * i1));
    2.0 * elliptic_k(k_squared) / rate
}

/// Mean time between flips, measured over ten of them.
fn measured(moments: [f64; 3], little: f64, step: f64) -> f64 {
    let (clump, mut body) = with_moments(moments, [0.0, 1.0, little]);
    let spin = |body: &Body| body.orientation.inverse_transform_vector(&body.angular_momentum).y;
    let (mut flips, mut time, mut before) = (vec![], 0.0, spin(&body));
    while flips.len() < 11 {
        body.drift(&clump, step);
        let now = spin(&body);
        if now * before < 0.0 {
            flips.push(time + step * before / (before - now));
        }
        time += step;
        before = now;
    }
    (flips[10] - flips[0]) / 10.0
}

#[test]
fn a_spin_about_the_intermediate_axis_flips_when_jacobis_functions_say_so() {
    let (moments, little) = ([1.0, 2.0, 2.5], 1e-3);
    let exact = time_between_flips(moments, little);
    let [coarse, fine] = [0.1, 0.05].map(|step| (measured(moments, little, step) / exact - 1.0).abs());
    println!("time between flips: {coarse:.1e} in steps of 0.1 rad, {fine:.1e} in half of them");
    assert!(fine < 1e-3, "{fine}");
    assert!((3.5..4.5).contains(&(coarse / fine)), "second order: {coarse}/{fine}");
}

#[test]
fn spins_about_the_other_axes_stay() {
    for (axis, spin) in [(0, [1.0, 1e-3, 1e-3]), (2, [1e-3, 1e-3, 1.0])] {
        let (clump, mut body) = with_moments([1.0, 2.0, 2.5], spin);
        let start = body.angular_momentum[axis];
        for _ in 0..10_000 {
            body.drift(&clump, 0.1);
            let now = body.orientation.inverse_transform_vector(&body.angular_momentum)[axis];
            assert!((now / start - 1.0).abs() < 1e-4, "axis {axis}: {now} instead of {start}");
        }
    }
}

#[test]
fn a_symmetrical_body_precesses_exactly_however_long_the_step() {
    for moments in [[1.0, 1.0, 1.7], [1.0, 1.6, 1.6], [1.3; 3]] {
        let spin = [0.3, -0.4, 0.5];
        let step = 2.3;
        let (clump, mut body) = with_moments(moments, spin);
        let start = body;
        // Precession about L at |L|/I_e, spin about the axis of the figure at (1/I_f - 1/I_e) l_f.
        let (figure, equal) = if moments[0] == moments[1] { (2, moments[0]) } else { (0, moments[2]) };
        let momentum = start.orientation.inverse_transform_vector(&start.angular_momentum);
        let own = momentum[figure] * (1.0 / clump.moments()[figure] - 1.0 / equal);
        let mut axis = Vector::zeros();
        axis[figure] = 1.0;
        for k in 1..=1000 {
            body.drift(&clump, step);
            let time = f64::from(k) * step;
            let expected = UnitQuaternion::from_scaled_axis(start.angular_momentum * (time / equal))
                * start.orientation
                * UnitQuaternion::from_scaled_axis(axis * (own * time));
            let angle = body.orientation.angle_to(&expected);
            assert!(angle < 1e-11, "{moments:?}, step {k}: {angle}");
        }
    }
}

#[test]
fn in_1e5_turns_the_energy_does_not_drift() {
    let (clump, mut body) = with_moments([1.0, 2.0, 2.5], [0.6, 0.7, 0.4]);
    let energy = body.kinetic_energy(&clump);
    let step = TAU / 50.0;
    let (mut early, mut late) = (0.0_f64, 0.0_f64);
    for turn in 0..100_000 {
        for _ in 0..50 {
            body.drift(&clump, step);
        }
        let deviation = (body.kinetic_energy(&clump) / energy - 1.0).abs();
        let worst = if turn < 1000 { &mut early } else { &mut late };
        *worst = worst.max(deviation);
    }
    println!("energy of a free body, 50 steps a turn: {early:.1e} in 1e3 turns, {late:.1e} in 1e5");
    assert!(early < 0.01, "{early}");
    assert!(late < 1.01 * early, "bounded: {late} after {early}");
}

#[test]
fn the_flight_can_be_undone() {
    let (clump, start) = with_moments([1.0, 2.0, 2.5], [0.6, 0.7, 0.4]);
    let mut body = start;
    (0..1000).for_each(|_| body.drift(&clump, 0.1));
    (0..1000).for_each(|_| body.drift(&clump, -0.1));
    assert!(body.orientation.angle_to(&start.orientation) < 1e-12);
}

/// Σ m x × v + I ω over the spheres of a clump that do not overlap.
fn angular_momentum_of_members(clump: &Clump, body: &Body) -> Vector<3> {
    let members = body.members(clump).zip(clump.members());
    members
        .map(|(carried, member)| {
            let mass = DENSITY * volume::<3>(member.radius, 1.0);
            let own = carried.angular_velocity * inertia::<3>(mass, member.radius);
            carried.centre.cross(&carried.velocity) * mass + own
        })
        .sum()
}

#[test]
fn the_members_of_a_tumbling_clump_keep_their_angular_momentum_to_rounding() {
    let clump = Clump::of_spheres(&jack(), DENSITY).unwrap();
    let spin = Vector::from([100.0, 150.0, -80.0]);
    let mut body = clump.body(Vector::zeros(), UnitQuaternion::identity(), Vector::zeros(), spin);
    let start = angular_momentum_of_members(&clump, &body);
    let mut worst = (body.angular_momentum - start).norm() / start.norm();
    for _ in 0..100_000 {
        body.drift(&clump, 1e-4);
        worst = worst.max((angular_momentum_of_members(&clump, &body) - start).norm() / start.norm());
    }
    println!("angular momentum of the members of a tumbling clump, 300 turns: {worst:.1e} [1e-13]");
    assert!(worst < 1e-13, "{worst}");
}
