//! Tests 1 to 3: impacts along the normal.

use crate::compare::{abscissae, compare, peers};
use crate::impact::{
    ALUMINIUM_ALLOY, ALUMINIUM_OXIDE, CAST_IRON, GLASS, Impact, LIMESTONE, MAGNESIUM_ALLOY, Surface,
};
use dem_solver::{Material, World};

const ELASTIC: Surface = Surface { restitution: 1.0, friction: 0.35 };

/// Largest normal force of an impact \[N\]. In every substep the force is Hertz's, 4/3 E* √R* δ^(3/2).
fn peak_force(mut impact: Impact, radius: f64, modulus: f64, gap: impl Fn(&World<3>) -> [f64; 2]) -> f64 {
    let (mut peak, mut deviation) = (0.0_f64, 0.0_f64);
    for _ in 0..1100 {
        let [distance, rate] = gap(&impact.world);
        let velocity = impact.world.grains.motion[0].velocity;
        impact.advance(1);
        let kick = (impact.world.grains.motion[0].velocity - velocity).norm();
        let force = impact.world.grains.mass[0] * kick / impact.step;
        // A substep is half a flight, a kick, and half a flight; the one in which they meet is no sample of the force.
        let overlap = -(distance + 0.5 * rate * impact.step);
        if overlap > rate.abs() * impact.step {
            let hertz = 4.0 / 3.0 * modulus * radius.sqrt() * overlap.powf(1.5);
            deviation = deviation.max((force / hertz - 1.0).abs());
        }
        peak = peak.max(force);
    }
    assert!(deviation < 1e-6, "{deviation} from Hertz's curve");
    peak
}

/// 4/3 E* √R* δ_m^(3/2) with δ_m = (15 m* v²/(16 √R* E*))^(2/5).
fn hertz_peak(radius: f64, mass: f64, modulus: f64, speed: f64) -> f64 {
    let deepest = (15.0 * mass * speed * speed / (16.0 * radius.sqrt() * modulus)).powf(0.4);
    4.0 / 3.0 * modulus * radius.sqrt() * deepest.powf(1.5)
}

/// Peak force, its closed form, and the published value (to its last digit) if there is one.
fn hold(name: &str, peak: f64, closed: f64) {
    println!("{name}: {peak:.2} N, closed form {closed:.2} N");
    assert!((peak / closed - 1.0).abs() < 1e-4, "{name}: {peak}, {closed}");
    let published = include_str!("reference/peak_forces.csv")
        .lines()
        .find_map(|line| line.split_once(name)?.1.strip_prefix(','));
    if let Some(published) = published {
        assert!(
            (peak - published.parse::<f64>().unwrap()).abs() < 1.0,
            "{name}: {peak}, published {published}"
        );
    }
}

#[test]
fn test_1_two_spheres_of_20_mm_at_20_metres_a_second_follow_hertz() {
    let (radius, speed) = (1e-2, 10.0);
    for (name, material) in [("glass", GLASS), ("limestone", LIMESTONE)] {
        let impact = Impact::of_two([material; 2], ELASTIC, [radius; 2], [speed, -speed], [0.0; 2]);
        let (mass, modulus) =
            (impact.world.grains.mass[0], impact.scene.materials.pair(0, 0).effective_modulus);
        let gap = |world: &World<3>| {
            let [one, other] =
                [0, 1].map(|k| (world.grains.place[k].centre.x, world.grains.motion[k].velocity.x));
            [other.0 - one.0 - 2.0 * radius, other.1 - one.1]
        };
        let peak = peak_force(impact, 0.5 * radius, modulus, gap);
        hold(name, peak, hertz_peak(0.5 * radius, 0.5 * mass, modulus, 2.0 * speed));
    }
}

#[test]
fn test_2_a_sphere_of_200_mm_on_a_rigid_wall_follows_hertz() {
    let (radius, speed) = (0.1, 0.2);
    let alloy = Material { density: 2699.0, poissons_ratio: 0.3, ..ALUMINIUM_ALLOY };
    for (name, material) in [("al_alloy", alloy), ("mg_alloy", MAGNESIUM_ALLOY)] {
        let impact = Impact::on_wall(material, ELASTIC, radius, [0.0, 0.0, -speed], 0.0);
        let (mass, modulus) =
            (impact.world.grains.mass[0], impact.scene.materials.pair(0, 1).effective_modulus);
        let gap =
            |world: &World<3>| [world.grains.place[0].centre.z - radius, world.grains.motion[0].velocity.z];
        let peak = peak_force(impact, radius, modulus, gap);
        hold(name, peak, hertz_peak(radius, mass, modulus, speed));
    }
}

#[test]
fn test_3_restitution_is_the_stated_one() {
    let speed = 3.9;
    let peers = [(ALUMINIUM_OXIDE, peers!("test3_al_oxide.csv")), (CAST_IRON, peers!("test3_cast_iron.csv"))];
    for (material, peers) in peers {
        let measured = |e: f64| {
            let surface = Surface { restitution: e, friction: 0.0 };
            let impact = Impact::on_wall(material, surface, 2.5e-3, [0.0, 0.0, -speed], 0.0);
            impact.end()[0].velocity.z / speed
        };
        compare("test 3, restitution", &peers, 1, Some, measured);
        for e in abscissae(&peers) {
            assert!((measured(e) - e).abs() < 1e-3, "e {e}: {}", measured(e));
        }
    }
}
