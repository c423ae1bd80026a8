//! Bonds in the step of a world.

use dem_solver::bond::{Bond, BondLaw, Bonds, Cohesive};
use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;
use dem_solver::wall::{Wall, Walls};
use dem_solver::{
    Deletion, Grain, Ledger, Material, Materials, Saved, Scene, Vector, Where, Workspace, World,
    critical_time_step, momentum, turn_over, window,
};

use crate::assembly::cement;

const RADIUS: f64 = 1e-3;

/// Springs of cement that bear this stress.
fn cohesive(strength: f64) -> BondLaw {
    BondLaw::Cohesive(Cohesive {
        modulus: 1e7,
        poissons_ratio: 0.25,
        area_factor: 1.0,
        tensile_strength: strength,
        shear_strength: strength,
        internal_friction: 0.0,
        damping_ratio: 0.1,
    })
}

fn scene(law: BondLaw) -> Scene<3> {
    let stone = Material { density: 2500.0, youngs_modulus: 1e7, poissons_ratio: 0.3 };
    let materials = Materials::new(vec![stone], |_, _| (0.5, 0.4));
    Scene::new(materials, NormalLaw::Hertz(Hertz { depth: 1.0 })).with_bond_laws(vec![law])
}

/// A cube of n³ grains that overlap by 1 %, each bonded to its nearest neighbours, thrown and spun.
fn cube(scene: &Scene<3>, n: u64, velocity: [f64; 3]) -> World<3> {
    let (mut world, mut bonds) = (World::new(), vec![]);
    let spacing = 1.98 * RADIUS;
    let strides = [1, n, n * n];
    for k in 0..n * n * n {
        let place = strides.map(|stride| k / stride % n);
        let grain = Grain::at(place.map(|p| p as f64 * spacing + RADIUS), RADIUS);
        world.add(scene, &grain.moving(velocity).spinning([20.0, -10.0, 5.0]));
        for axis in (0..3).filter(|&axis| place[axis] + 1 < n) {
            let mut separation = Vector::zeros();
            separation[axis] = spacing;
            bonds.push(Bond::new([k, k + strides[axis]], 0, separation));
        }
    }
    world.bonds = Bonds::new(bonds).unwrap();
    world
}

fn run(scene: &Scene<3>, world: &mut World<3>, steps: u32) -> Ledger<3> {
    let step = 0.5 * critical_time_step(scene, world).step;
    window(scene, world, &mut Workspace::new(), None, step * f64::from(steps), steps).unwrap()
}

fn on_threads<R: Send>(threads: usize, work: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

/// A cube of two chunks that breaks on a floor.
fn crash() -> (Scene<3>, World<3>) {
    let floor = Walls::new(vec![Wall::plane("floor", 0, [0.0; 3], [0.0, 0.0, 1.0])]);
    let scene = scene(cohesive(2e4)).with_walls(floor);
    let world = cube(&scene, 11, [0.3, 0.0, -2.0]);
    (scene, world)
}

#[test]
fn a_breaking_body_gives_the_same_bits_on_any_number_of_threads_and_after_a_restart() {
    let (scene, start) = crash();
    let half = |world: &mut World<3>| drop(run(&scene, world, 150));
    let end = |threads: usize| {
        let mut world = start.clone();
        on_threads(threads, || (0..2).for_each(|_| half(&mut world)));
        world
    };
    let one = end(1);
    let broken = one.bonds.iter().filter(|bond| bond.failure.is_some()).count();
    assert!(one.contacts.chunks.len() > 1 && broken > 10 && broken < one.bonds.len(), "{broken} broke");
    assert!(one == end(2) && one == end(4));

    let path = std::env::temp_dir().join(format!("dem-solver-bonds-{}.checkpoint", std::process::id()));
    let mut world = start;
    half(&mut world);
    world.write_checkpoint(&path).unwrap();
    let mut resumed = World::read_checkpoint(&path, &scene, vec![]).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(resumed == world);
    half(&mut resumed);
    assert!(resumed == one);
    let mut saved = Saved::default();
    world.save(&mut saved);
    half(&mut world);
    world.restore(&saved);
    half(&mut world);
    assert!(world == one);
}

#[test]
fn bonds_are_internal_forces() {
    let scene = scene(BondLaw::ParallelBond(cement()));
    let mut world = cube(&scene, 4, [1.0, 0.5, -0.2]);
    let before = momentum(&world);
    let ledger = run(&scene, &mut world, 400);
    assert!(dem_solver::bond_energy(&scene, &world).unwrap() > 1e-9, "the bonds are loaded");
    assert!((momentum(&world) - before).norm() < 1e-13 * before.norm());
    assert!(ledger.residual().norm() < 1e-13 * ledger.scale);
}

#[test]
fn a_cohesive_bond_takes_the_place_of_the_contact_until_it_breaks() {
    let pair = |strength: f64, speed: f64| {
        let scene = scene(cohesive(strength));
        let mut world = World::new();
        world.add(&scene, &Grain::at([0.0; 3], RADIUS));
        world.add(&scene, &Grain::at([1.98 * RADIUS, 0.0, 0.0], RADIUS).moving([speed, 0.0, 0.0]));
        let separation = Vector::from([1.98 * RADIUS, 0.0, 0.0]);
        world.bonds = Bonds::new(vec![Bond::new([0, 1], 0, separation)]).unwrap();
        run(&scene, &mut world, 50);
        world
    };
    let rest = pair(1e9, 0.0);
    assert!(rest.grains.motion.iter().all(|motion| motion.velocity.norm() == 0.0), "they overlap, unpushed");
    let torn = pair(1.0, 1e-3);
    assert!(torn.bonds.iter().all(|bond| bond.failure.is_some()));
    assert!(torn.grains.motion[0].velocity.x < -1e-3, "contact pushes them apart");
}

#[test]
fn bonds_go_with_the_grains_that_are_removed() {
    let place = Where::Beyond(dem_solver::wall::Plane {
        point: Vector::from([2.5 * RADIUS, 0.0, 0.0]),
        normal: Vector::from([-1.0, 0.0, 0.0]),
    });
    let scene = Scene {
        deletions: vec![Deletion { name: "out".into(), place }],
        ..scene(BondLaw::ParallelBond(cement()))
    };
    let mut world = cube(&scene, 2, [0.0; 3]);
    turn_over(&scene, &mut world).unwrap();
    assert_eq!((world.grains.len(), world.bonds.len(), world.bonds.broken().orphaned), (4, 4, 8));
    run(&scene, &mut world, 1);
}
