//! Test 5: a sphere of 20 µm hits a wall at 5 m/s along its normal and at any speed along it; no energy is lost to damping.

use crate::compare::{compare, peers};
use crate::curve::Curve;
use crate::impact::{Impact, POLYETHYLENE, STEEL, Surface};
use dem_solver::Material;

const SPEED: f64 = 5.0;
const RADIUS: f64 = 1e-5;
const SURFACE: Surface = Surface { restitution: 1.0, friction: 0.3 };

const REBOUND: &str = include_str!("reference/test5_rebound.csv");
const SPIN: &str = include_str!("reference/test5_spin.csv");

/// Tangential speed of the surface and spin after the impact, as parts of μ v_n, at the incident speed x μ v_n.
fn rebound(material: Material, x: f64) -> [f64; 2] {
    let unit = SURFACE.friction * SPEED;
    let end = &Impact::on_wall(material, SURFACE, RADIUS, [x * unit, 0.0, -SPEED], 0.0).end()[0];
    let spin = RADIUS * end.angular_velocity.y;
    [(end.velocity.x - spin) / unit, -spin / unit]
}

#[test]
fn beyond_seven_the_sphere_slides_all_along() {
    for material in [STEEL, POLYETHYLENE] {
        for x in [8.0, 10.0, 13.0, 20.0] {
            let [surface, spin] = rebound(material, x);
            assert!(
                (surface - (x - 7.0)).abs() < 1e-3 && (spin + 5.0).abs() < 1e-3,
                "{x}: {surface}, {spin}"
            );
        }
    }
}

/// Where a part of the contact sticks every program is 0.1 to 0.8 off: no claim but that of the table is made there.
#[test]
fn beside_finite_elements_and_three_other_programs() {
    for (name, material, peers) in [
        ("steel", STEEL, peers!("test5_steel.csv")),
        ("polyethylene", POLYETHYLENE, peers!("test5_polyethylene.csv")),
    ] {
        for (quantity, what, text) in [(0, "rebound", REBOUND), (1, "spin", SPIN)] {
            let elements = Curve::published(text, "fem");
            let found = |x: f64| rebound(material, x)[quantity];
            let title = format!("test 5, {what}, {name}, finite elements");
            let errors = compare(&title, &peers, 1 + quantity, |x| elements.at(x), found);
            assert!(
                errors[0] < errors[2],
                "nearer than LAMMPS, whose law is the nearest to ours: {errors:?}"
            );
        }
    }
}
