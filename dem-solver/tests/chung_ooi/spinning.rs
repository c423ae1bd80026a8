//! Test 6: a sphere of 200 mm that spins falls on a wall at 0.2 m/s along its normal.

use crate::compare::{abscissae, compare, peers};
use crate::curve::{Curve, READING};
use crate::impact::{ALUMINIUM_ALLOY, Impact, NYLON, Surface};
use dem_solver::Material;

pub const SPEED: f64 = 0.2;
pub const RADIUS: f64 = 0.1;
pub const SURFACE: Surface = Surface { restitution: 0.5, friction: 0.4 };

/// β = −v_t'/v_t of the surface at the point of contact, for this v_t/v_n.
pub fn beta(material: Material, ratio: f64) -> f64 {
    let impact = Impact::on_wall(material, SURFACE, RADIUS, [0.0, 0.0, -SPEED], -ratio * SPEED / RADIUS);
    let end = &impact.end()[0];
    -(end.velocity.x - RADIUS * end.angular_velocity.y) / (ratio * SPEED)
}

/// β of a surface that slides all along.
pub fn sliding(ratio: f64) -> f64 {
    incidence(ratio) - 1.0
}

/// 7/2 μ (1 + e) v_n/v_t, the abscissa of the published curves: sliding to sticking.
pub fn incidence(ratio: f64) -> f64 {
    3.5 * SURFACE.friction * (1.0 + SURFACE.restitution) / ratio
}

#[test]
fn a_sphere_of_fast_spin_slides_all_along() {
    for material in [ALUMINIUM_ALLOY, NYLON] {
        for ratio in [2.856, 3.464, 4.289, 5.495, 7.464, 11.34, 22.86] {
            let (found, closed) = (beta(material, ratio), sliding(ratio));
            assert!((found - closed).abs() < 1e-3, "{ratio}: {found}, {closed}");
        }
    }
}

/// Towards sticking (slow spins, abscissae of 3 and more) the published β goes to −0.1 to −0.3; ours and the three programs'
/// go to 0, since their tangential dashpots take the spin out of a contact that sticks.
#[test]
fn the_surface_speed_is_nearer_to_the_published_curves_than_that_of_three_other_programs() {
    for (name, material, peers) in [
        ("al_alloy", ALUMINIUM_ALLOY, peers!("test6_al_alloy.csv")),
        ("nylon", NYLON, peers!("test6_nylon.csv")),
    ] {
        let curve = Curve::published(include_str!("reference/test6_beta.csv"), name);
        let answer = |ratio: f64| curve.at(incidence(ratio));
        let found = |ratio: f64| beta(material, ratio);
        let [here, others @ ..] = compare(&format!("test 6, beta, {name}"), &peers, 2, answer, found);
        assert!(others.iter().all(|other| here < *other), "{here}, {others:?}");
        for ratio in abscissae(&peers).into_iter().filter(|ratio| incidence(*ratio) < 1.3) {
            let Some(published) = answer(ratio) else { continue };
            let error = beta(material, ratio) - published;
            assert!(error.abs() < READING * curve.span(), "{name}, {ratio}: {error}");
        }
    }
}
