//! Cubic packings of Hertz's spheres, squeezed by the same overlap everywhere.

use std::f64::consts::FRAC_PI_4;

use dem_solver::bulk::{
    bulk_row, bulk_titles, bulk_volume, contact_stress, contacts_at_rest, coordination, fabric,
};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Domain, Grain, Material, Materials, Scene, Workspace, World, window};

const RADIUS: f64 = 1e-3;
const OVERLAP: f64 = 1e-5;
const SPACING: f64 = 2.0 * RADIUS - OVERLAP;
const SIDE: usize = 5;
const GLASS: Material = Material { density: 2500.0, youngs_modulus: 1e9, poissons_ratio: 0.25 };

fn scene<const D: usize>(depth: f64) -> Scene<D> {
    let materials = Materials::new(vec![GLASS], |_, _| (0.5, 0.3));
    Scene { depth, ..Scene::new(materials, NormalLaw::Hertz(Hertz { depth })) }
}

/// E* of two grains, and of a grain and a wall of the same material.
fn effective_modulus() -> f64 {
    0.5 * GLASS.youngs_modulus / (1.0 - GLASS.poissons_ratio.powi(2))
}

/// The force in a contact of two spheres, 4/3 E* √(r/2) δ^(3/2).
fn force() -> f64 {
    4.0 / 3.0 * effective_modulus() * (0.5 * RADIUS).sqrt() * OVERLAP.powf(1.5)
}

/// The cubic packing with its lists; the lowest centres are at half a spacing, along z at `lowest`.
fn packing<const D: usize>(scene: &Scene<D>, lowest: f64) -> World<D> {
    let mut world = World::new();
    for k in 0..SIDE.pow(D as u32) {
        let mut at =
            std::array::from_fn(|axis| (k / SIDE.pow(axis as u32) % SIDE) as f64 * SPACING + 0.5 * SPACING);
        at[D - 1] += lowest - 0.5 * SPACING;
        world.add(scene, &Grain::at(at, RADIUS));
    }
    window(scene, &mut world, &mut Workspace::new(), None, 1e-14, 1).unwrap();
    world
}

fn close(found: f64, expected: f64) -> bool {
    (found - expected).abs() < 1e-9 * expected.abs()
}

#[test]
fn a_cubic_packing_between_plates_has_six_contacts_a_grain_and_the_plates_pressure() {
    // A wall's contact bears the same force at 2^(-1/3) of the overlap: R* is r there, r/2 between grains.
    let into_plate = OVERLAP / 2.0_f64.cbrt();
    let (n, layer) = (SIDE as f64, RADIUS - into_plate);
    let height = (n - 1.0) * SPACING + 2.0 * layer;
    let length = n * SPACING;
    let plates = Walls::new(vec![
        Wall::plane("floor", 0, [0.0; 3], [0.0, 0.0, 1.0]),
        Wall::plane("lid", 0, [0.0, 0.0, height], [0.0, 0.0, -1.0]),
    ]);
    let domain = Domain::new([0.0, 0.0, -1.0], [length, length, 1.0]).periodic([true, true, false]);
    let scene = scene::<3>(1.0).in_domain(domain).with_walls(plates);
    let world = packing(&scene, layer);
    let contacts = contacts_at_rest(&scene, &world);

    let count = coordination(&contacts, world.grains.len());
    assert_eq!((count.touching, count.between_grains, count.on_walls), (125, 350, 50));
    assert_eq!(count.mean(), 6.0);

    let fabric = fabric(&contacts);
    for (axis, share) in [125.0 / 400.0, 125.0 / 400.0, 150.0 / 400.0].into_iter().enumerate() {
        assert!(close(fabric[(axis, axis)], share), "axis {axis}: {}", fabric[(axis, axis)]);
    }
    assert!((fabric.sum() - 1.0).abs() < 1e-9, "no shear");

    let tall = (n - 1.0) * SPACING + 2.0 * RADIUS;
    let volume = bulk_volume(&scene, &world);
    assert!(close(volume, length * length * tall));
    let stress = contact_stress(&contacts, volume);
    let pressure = force() / (SPACING * SPACING);
    assert!(close(stress[(2, 2)], -pressure), "{} for {pressure} Pa", stress[(2, 2)]);
    for axis in 0..2 {
        assert!(close(stress[(axis, axis)], -pressure * n * SPACING / tall));
    }
    assert!((stress.sum() - stress.trace()).abs() < 1e-9 * pressure);
}

#[test]
fn a_cubic_packing_without_ends_is_under_an_isotropic_pressure() {
    let length = SIDE as f64 * SPACING;
    let domain = Domain::new([0.0; 3], [length; 3]).periodic([true; 3]);
    let scene = scene::<3>(1.0).in_domain(domain);
    let world = packing(&scene, 0.5 * SPACING);
    let contacts = contacts_at_rest(&scene, &world);
    assert_eq!(coordination(&contacts, world.grains.len()).mean(), 6.0);
    let (fabric, stress) = (fabric(&contacts), contact_stress(&contacts, bulk_volume(&scene, &world)));
    let pressure = force() / (SPACING * SPACING);
    for i in 0..3 {
        for j in 0..3 {
            let one = f64::from(u8::from(i == j));
            assert!((fabric[(i, j)] - one / 3.0).abs() < 1e-9);
            assert!((stress[(i, j)] + one * pressure).abs() < 1e-9 * pressure, "{stress} for {pressure} Pa");
        }
    }
}

#[test]
fn a_square_packing_of_discs_is_under_the_pressure_of_its_depth() {
    let (length, depth) = (SIDE as f64 * SPACING, 0.02);
    let domain = Domain::new([0.0; 2], [length; 2]).periodic([true; 2]);
    let scene = scene::<2>(depth).in_domain(domain);
    let world = packing(&scene, 0.5 * SPACING);
    let contacts = contacts_at_rest(&scene, &world);
    assert_eq!(coordination(&contacts, world.grains.len()).mean(), 4.0);
    let stress = contact_stress(&contacts, bulk_volume(&scene, &world));
    let pressure = FRAC_PI_4 * effective_modulus() * depth * OVERLAP / (SPACING * depth);
    assert!(close(stress[(0, 0)], -pressure) && close(stress[(1, 1)], -pressure));
    assert_eq!(stress[(2, 2)], 0.0);
}

#[test]
fn a_row_has_a_value_under_each_title_and_zeros_where_nothing_touches() {
    let scene = scene::<3>(1.0);
    let row = bulk_row(&scene, &World::new());
    assert_eq!(row.len(), bulk_titles(&scene).len() + 1);
    assert!(row.iter().all(|&value| value == 0.0));
    let nothing = Scene { normal_law: NormalLaw::None, ..scene };
    assert!(bulk_titles(&nothing).is_empty());
}
