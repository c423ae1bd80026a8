//! Tests 7 and 8: two spheres that spin meet head on.

use crate::compare::{Peers, abscissae, compare, peers};
use crate::impact::{ALUMINIUM_ALLOY, COPPER, Impact, NYLON, rigid};
use crate::spinning::{RADIUS, SPEED, SURFACE, beta, sliding};
use dem_solver::Material;

/// β of two like spheres that spin the same way; each comes at the speed of a sphere on a wall.
fn beta_of_like(material: Material, ratio: f64) -> f64 {
    let spin = ratio * SPEED / RADIUS;
    let impact = Impact::of_two([material; 2], SURFACE, [RADIUS; 2], [SPEED, -SPEED], [spin; 2]);
    let end = impact.end();
    let surface = |side: f64, k: usize| end[k].velocity.y + side * RADIUS * end[k].angular_velocity.z;
    -(surface(1.0, 0) - surface(-1.0, 1)) / (2.0 * ratio * SPEED)
}

/// β of a spinning sphere that hits another, five times as large, a hundred thousand times as heavy and at rest.
fn beta_on_heavy(material: Material, heavy: Material, ratio: f64) -> f64 {
    let heavy = Material { density: 1e3 * heavy.density, ..heavy };
    let (large, spin) = (5.0 * RADIUS, ratio * SPEED / RADIUS);
    let impact = Impact::of_two([material, heavy], SURFACE, [RADIUS, large], [SPEED, 0.0], [spin, 0.0]);
    let end = impact.end();
    let one = end[0].velocity.y + RADIUS * end[0].angular_velocity.z;
    let other = end[1].velocity.y - large * end[1].angular_velocity.z;
    -(one - other) / (ratio * SPEED)
}

#[test]
fn test_7_like_spheres_of_opposite_spins_do_not_feel_them() {
    for ratio in abscissae(&peers!("test7_al_alloy_counter.csv")) {
        let spin = ratio * SPEED / RADIUS;
        let impact =
            Impact::of_two([ALUMINIUM_ALLOY; 2], SURFACE, [RADIUS; 2], [SPEED, -SPEED], [spin, -spin]);
        let end = impact.end();
        assert_eq!([end[0].velocity.y, end[1].velocity.y], [0.0; 2]);
        assert_eq!([end[0].angular_velocity.z, end[1].angular_velocity.z], [spin, -spin]);
        assert!((end[0].velocity.x / -SPEED - SURFACE.restitution).abs() < 1e-3);
    }
}

#[test]
fn test_7_and_8_are_test_6_seen_from_elsewhere() {
    let (alloy, copper, nylon) = (ALUMINIUM_ALLOY, COPPER, NYLON);
    type Found = fn(f64) -> f64;
    let series: [(&str, Material, Found, Peers); 5] = [
        (
            "7, aluminium alloy",
            alloy,
            |x| beta_of_like(ALUMINIUM_ALLOY, x),
            peers!("test7_al_alloy_same.csv"),
        ),
        ("7, copper", copper, |x| beta_of_like(COPPER, x), peers!("test7_copper_same.csv")),
        (
            "8a, aluminium alloy",
            alloy,
            |x| beta_on_heavy(ALUMINIUM_ALLOY, rigid(ALUMINIUM_ALLOY), x),
            peers!("test8a_al_alloy.csv"),
        ),
        ("8a, nylon", nylon, |x| beta_on_heavy(NYLON, rigid(NYLON), x), peers!("test8a_nylon.csv")),
        (
            "8b, aluminium alloy",
            alloy,
            |x| beta_on_heavy(ALUMINIUM_ALLOY, ALUMINIUM_ALLOY, x),
            peers!("test8b_al_alloy.csv"),
        ),
    ];
    for (name, material, found, peers) in series {
        let mut largest = 0.0_f64;
        for ratio in abscissae(&peers) {
            let difference = found(ratio) - beta(material, ratio);
            largest = largest.max(difference.abs());
            assert!(difference.abs() < 1e-3, "{name}, {ratio}: {difference}");
        }
        println!("test {name}: {largest:.1e} from test 6");
        let sliding = |ratio: f64| (ratio > 2.8).then(|| sliding(ratio));
        let errors = compare(&format!("test {name}, beta, sliding"), &peers, 7, sliding, found);
        assert!(errors[0] < 1e-3, "{name}: {errors:?}");
    }
}
