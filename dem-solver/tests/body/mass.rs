#![allow(clippy::print_stdout, reason = "the deviations are figures of the documentation")]

use std::f64::consts::PI;

use crate::shapes::{DENSITY, jack, member};
use dem_solver::Vector;
use dem_solver::body::{Clump, MassProperties, Member};
use nalgebra::{Matrix3, UnitQuaternion};

fn deviation(found: f64, expected: f64) -> f64 {
    (found / expected - 1.0).abs()
}

#[test]
fn spheres_that_only_touch_have_the_sum_of_their_inertia() {
    let (r, m) = (1e-3, DENSITY * 4.0 / 3.0 * PI * 1e-9);
    let pair =
        Clump::of_spheres(&[member([5.0, 0.0, 1.0], r), member([5.0, 2.0 * r, 1.0], r)], DENSITY).unwrap();
    let (along, across) = (0.8 * m * r * r, 2.8 * m * r * r);
    assert!(deviation(pair.mass(), 2.0 * m) < 1e-14);
    // The clump lies 5 m from the origin of its frame: (5 m/1 mm)² 1e-16.
    for (found, expected) in pair.moments().into_iter().zip([along, across, across]) {
        assert!(deviation(found, expected) < 1e-8, "{found} instead of {expected}");
    }
    let arm = pair.members()[0].offset;
    assert!(
        (arm.norm() - r).abs() < 1e-15 && arm.x.abs() > 0.999 * r,
        "the least moment is about the first axis"
    );
}

/// m, least and largest moment of two spheres of radius 1 and density 1, their centres d apart: solids of revolution.
fn two_spheres(d: f64) -> [f64; 3] {
    let end = d / 2.0 + 1.0;
    // Three Gauss points: exact for these polynomials of degree 4.
    let points = [(-0.6_f64.sqrt(), 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.6_f64.sqrt(), 5.0 / 9.0)];
    let mut sums = [0.0; 3];
    for (t, weight) in points {
        let x = 0.5 * end * (1.0 + t);
        let square = 1.0 - (x - d / 2.0).powi(2);
        let slice = [square, 0.5 * square * square, 0.25 * square * square + square * x * x];
        (0..3).for_each(|k| sums[k] += 2.0 * 0.5 * end * weight * PI * slice[k]);
    }
    sums
}

#[test]
fn matter_that_overlapping_spheres_share_counts_once() {
    let mut worst = 0.0_f64;
    for d in [0.1, 0.7, 1.0, 1.6, 1.999] {
        for direction in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.48, 0.64, 0.6]] {
            let half = Vector::from(direction) * (d / 2.0);
            let members = [half, -half].map(|offset| Member { offset, radius: 1.0 });
            let clump = Clump::of_spheres(&members, 1.0).unwrap();
            let [mass, along, across] = two_spheres(d);
            worst = worst.max(deviation(clump.mass(), mass));
            for (found, expected) in clump.moments().into_iter().zip([along, across, across]) {
                worst = worst.max(deviation(found, expected));
            }
        }
    }
    let inside = [member([0.0; 3], 1.0), member([0.2, 0.1, 0.3], 0.5)];
    worst = worst.max(deviation(Clump::of_spheres(&inside, 1.0).unwrap().moments()[1], 8.0 / 15.0 * PI));
    println!("mass and inertia of overlapping spheres: {worst:.1e} [1e-5]");
    assert!(worst < 1e-5, "{worst}");
}

#[test]
fn discs_that_overlap_share_their_matter_too() {
    let pair = |d: f64| [member([-d / 2.0, 0.3, 0.0], 1.0), member([d / 2.0, 0.3, 0.0], 1.0)];
    let touching = Clump::of_discs(&pair(2.0), 3.0, 0.5).unwrap();
    assert!(deviation(touching.mass(), 3.0 * PI) < 1e-14);
    assert!(deviation(touching.moments()[2], 4.5 * PI) < 1e-14);
    // Two discs of radius 1 less their lens, and the polar moment of a disc cut by the line x = 0.
    let d = 1.2_f64;
    let angle = (d / 2.0).acos();
    let area = 2.0 * (PI - angle + angle.sin() * angle.cos());
    let overlapping = Clump::of_discs(&pair(d), 1.0, 1.0).unwrap();
    let steps = 200_000;
    let polar: f64 = (0..steps)
        .map(|k| {
            // x = d/2 - cos t: smooth at the rim.
            let t = angle + (PI - angle) * (k as f64 + 0.5) / steps as f64;
            let (x, half) = (d / 2.0 - t.cos(), t.sin());
            let inside = 2.0 * half * x * x + 2.0 / 3.0 * half.powi(3);
            2.0 * inside * t.sin() * (PI - angle) / steps as f64
        })
        .sum();
    let worst = deviation(overlapping.mass(), area).max(deviation(overlapping.moments()[2], polar));
    println!("mass and inertia of overlapping discs: {worst:.1e} [1e-6]");
    assert!(worst < 1e-6, "{worst}");
}

#[test]
fn the_frame_a_clump_is_given_in_does_not_matter() {
    let turn = UnitQuaternion::from_euler_angles(0.3, -1.2, 2.0);
    let shift = Vector::from([1e-3, -2e-3, 5e-4]);
    let moved = jack().map(|m| Member { offset: turn * m.offset + shift, ..m });
    let [one, other] = [jack(), moved].map(|members| Clump::of_spheres(&members, DENSITY).unwrap());
    for (a, b) in one.moments().into_iter().zip(other.moments()) {
        assert!(deviation(a, b) < 1e-13);
    }
    // Members lie in space where the frame says.
    let none = Vector::zeros();
    for (clump, rotation, origin) in [(&one, turn, shift), (&other, UnitQuaternion::identity(), none)] {
        let body = clump.body(origin, rotation, none, none);
        for (carried, member) in body.members(clump).zip(&moved) {
            assert!((carried.centre - member.offset).norm() < 1e-17 + 1e-15 * member.offset.norm());
        }
    }
}

#[test]
fn a_stated_inertia_is_taken_as_it_is() {
    let inertia = Matrix3::new(3.0, 0.2, 0.0, 0.2, 2.5, -0.1, 0.0, -0.1, 2.0);
    let centre = Vector::from([0.1, 0.2, 0.3]);
    let properties = MassProperties { mass: 7.0, centre, inertia };
    let clump = Clump::with_mass(&jack(), &properties).unwrap();
    let spin = Vector::from([1.0, -2.0, 0.5]);
    let body = clump.body(Vector::zeros(), UnitQuaternion::identity(), Vector::zeros(), spin);
    assert_eq!(clump.mass(), 7.0);
    assert!((body.centre - centre).norm() < 1e-16);
    assert!((body.angular_momentum - inertia * spin).norm() < 1e-14);
    assert!((body.angular_velocity(&clump) - spin).norm() < 1e-14);
}
