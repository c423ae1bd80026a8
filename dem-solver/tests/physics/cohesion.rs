//! Cohesion.

use std::f64::consts::PI;

use crate::scenes::{GLASS, glass, hertz, run, world};
use dem_solver::contact::Extras;
use dem_solver::contact::cohesion::CohesionLaw;
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Grain, Scene};

#[test]
fn a_cohesive_sphere_hangs_from_the_ceiling_where_its_weight_and_the_pull_balance_the_push() {
    let (radius, density) = (1e-3, 1e5);
    let ceiling = Walls::new(vec![Wall::plane("ceiling", 0, [0.0; 3], [0.0, 0.0, -1.0])]);
    for law in [CohesionLaw::Sjkr, CohesionLaw::Sjkr2] {
        let materials = glass(0.3, 0.5).with(|_, _, pair| pair.cohesion_energy_density = density);
        let scene = Scene::<3>::new(materials, hertz())
            .with_gravity([0.0, 0.0, -9.81])
            .with_walls(ceiling.clone())
            .with_extras(Extras { cohesion: Some(law), ..Extras::default() });
        let start = Grain::at([0.0, 0.0, -0.999 * radius], radius);
        let mut ball = world(&scene, &[start]);
        run(&scene, &mut ball, 0.1, 20_000).unwrap();
        let overlap = radius + ball.grains.place[0].centre.z;
        let modulus = 0.5 * GLASS.youngs_modulus / (1.0 - GLASS.poissons_ratio.powi(2));
        let push = 4.0 / 3.0 * modulus * radius.sqrt() * overlap.powf(1.5);
        let area = match law {
            CohesionLaw::Sjkr => PI * (radius.powi(2) - (radius - overlap).powi(2)),
            _ => 2.0 * PI * radius * overlap,
        };
        let weight = GLASS.density * dem_solver::volume::<3>(radius, 1.0) * 9.81;
        let balance = push + weight - density * area;
        assert!(balance.abs() < 1e-6 * weight, "{law:?}: {balance} N at {overlap} m, {weight} N");
    }
}
