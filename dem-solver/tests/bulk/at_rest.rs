//! Forces at rest, held against what must carry the weight.

use std::f64::consts::PI;

use dem_solver::bulk::{bulk_volume, contact_stress, contacts_at_rest, coordination};
use dem_solver::contact::Extras;
use dem_solver::contact::NormalLaw;
use dem_solver::contact::cohesion::CohesionLaw;
use dem_solver::contact::normal::{Hertz, LiggghtsHertz};
use dem_solver::wall::{Facet, Wall, Walls};
use dem_solver::{
    Grain, Material, Materials, Scene, Substep, Workspace, World, critical_time_step, substeps, window,
};
use nalgebra::Vector3;

const GLASS: Material = Material { density: 2500.0, youngs_modulus: 1e7, poissons_ratio: 0.3 };

fn glass() -> Materials {
    Materials::new(vec![GLASS], |_, _| (0.3, 0.5))
}

/// Discs that came to rest in a box: its floor of facets, its sides planes.
fn settled(law: NormalLaw) -> (Scene<2>, World<2>) {
    let side = |name: &str, x: f64, normal: f64| Wall::plane(name, 0, [x, 0.0], [normal, 0.0]);
    let floor = Facet::new([[-1.0, 0.0], [1.0, 0.0]]);
    let walls = Walls::new(vec![
        Wall::facets("floor", 0, vec![floor]),
        side("west", 0.0, 1.0),
        side("east", 0.021, -1.0),
    ]);
    let scene = Scene::<2>::new(glass(), law).with_gravity([0.0, -9.81]).with_walls(walls);
    let mut world = World::new();
    for k in 0..80 {
        let (i, j) = (f64::from(k % 10), f64::from(k / 10));
        let at = [1.05e-3 + 2.05e-3 * i + 1e-4 * (j % 3.0), 1.1e-3 + 2.05e-3 * j];
        world.add(&scene, &Grain::at(at, 1e-3));
    }
    for _ in 0..20 {
        let critical = critical_time_step(&scene, &world);
        let count = substeps(0.05, Substep::Fraction(0.5), &critical).unwrap();
        window(&scene, &mut world, &mut Workspace::new(), None, 0.05, count).unwrap();
    }
    (scene, world)
}

#[test]
fn in_a_pile_at_rest_the_contacts_of_each_grain_bear_its_weight_and_do_not_turn_it() {
    let (scene, world) = settled(NormalLaw::Hertz(Hertz { depth: 1.0 }));
    let grains = &world.grains;
    let mut force: Vec<Vector3<f64>> =
        grains.mass.iter().map(|mass| Vector3::new(0.0, -9.81 * mass, 0.0)).collect();
    let contacts = contacts_at_rest(&scene, &world);
    for contact in &contacts {
        force[contact.grain] += contact.force;
        contact.other.into_iter().for_each(|other| force[other] -= contact.force);
    }
    let weight = 9.81 * grains.mass[0];
    let worst = force.iter().map(|force| force.norm() / weight).fold(0.0, f64::max);
    assert!(worst < 1e-4, "a grain bears its weight to {worst}");
    let rubbing =
        contacts.iter().map(|contact| contact.force.cross(&contact.normal).norm()).fold(0.0, f64::max);
    assert!(rubbing > 0.1 * weight, "friction takes part");
    let stress = contact_stress(&contacts, bulk_volume(&scene, &world));
    let unequal = (stress[(0, 1)] - stress[(1, 0)]).abs() / stress.norm();
    assert!(unequal < 1e-5, "σ_xy and σ_yx differ by {unequal}");
}

#[test]
fn a_frozen_grain_is_a_wall() {
    let scene = Scene::<3>::new(glass(), NormalLaw::LiggghtsHertz(LiggghtsHertz));
    let mut world = World::new();
    // The frozen one first and last: the force is that on the other.
    for z in [-1.99e-3, 1.99e-3] {
        world.add(&scene, &Grain::at([z, 0.0, 0.0], 1e-3).frozen());
        world.add(&scene, &Grain::at([0.0, 0.0, 5.0 * z], 1e-3).frozen());
    }
    world.add(&scene, &Grain::at([0.0; 3], 1e-3));
    window(&scene, &mut world, &mut Workspace::new(), None, 1e-12, 1).unwrap();
    let contacts = contacts_at_rest(&scene, &world);
    let count = coordination(&contacts, world.grains.len());
    assert_eq!((count.touching, count.between_grains, count.on_walls), (1, 0, 2));
    assert!(contacts.iter().all(|contact| contact.force.dot(&contact.normal) < 0.0));
    assert!(contacts.iter().all(|contact| contact.branch.dot(&contact.normal) > 0.99e-3));
    let sum: Vector3<f64> = contacts.iter().map(|contact| contact.force).sum();
    assert!(sum.norm() < 1e-9 * contacts[0].force.norm());
    assert!((bulk_volume(&scene, &world) / 8e-9 - 1.0).abs() < 1e-9);
}

#[test]
fn cohesion_is_among_the_forces() {
    let materials = glass().with(|_, _, pair| pair.cohesion_energy_density = 1e5);
    let law = CohesionLaw::Sjkr;
    let scene = Scene::<3>::new(materials, NormalLaw::Hertz(Hertz { depth: 1.0 }))
        .with_extras(Extras { cohesion: Some(law), ..Extras::default() });
    let mut world = World::new();
    let distance = 1.999e-3;
    world.add(&scene, &Grain::at([0.0; 3], 1e-3));
    world.add(&scene, &Grain::at([distance, 0.0, 0.0], 1e-3));
    window(&scene, &mut world, &mut Workspace::new(), None, 1e-14, 1).unwrap();
    let contact = contacts_at_rest(&scene, &world)[0];
    let modulus = 0.5 * GLASS.youngs_modulus / (1.0 - 0.09);
    let pushing = 4.0 / 3.0 * modulus * (5e-4_f64).sqrt() * (2e-3 - distance).powf(1.5);
    let pulling = 1e5 * PI * (1e-6 - distance * distance / 4.0);
    let expected = pulling - pushing;
    let found = contact.force.dot(&contact.normal);
    assert!(expected > 0.0 && (found / expected - 1.0).abs() < 1e-6, "{found} N for {expected} N");
}
