//! Scenes that meet every branch of the engine.

use dem_solver::contact::cohesion::CohesionLaw;
use dem_solver::contact::lubrication::Lubrication;
use dem_solver::contact::normal::{Hertz, Hooke, LiggghtsHertz, LiggghtsHooke};
use dem_solver::contact::rolling::RollingLaw;
use dem_solver::contact::twisting::TwistingLaw;
use dem_solver::contact::{Extras, NormalLaw};
use dem_solver::insertion::Random;
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Domain, Grain, Material, Materials, Scene, World};

pub const STEP: f64 = 2e-6;
const RADIUS: f64 = 1e-3;

pub const HERTZ: NormalLaw = NormalLaw::Hertz(Hertz { depth: 1.0 });
pub const PARTIAL_SLIP: NormalLaw = NormalLaw::HertzPartialSlip(Hertz { depth: 1.0 });
pub const HOOKE: NormalLaw = NormalLaw::Hooke(Hooke { characteristic_velocity: 1.0, depth: 1.0 });
pub const LIGGGHTS_HERTZ: NormalLaw = NormalLaw::LiggghtsHertz(LiggghtsHertz);
pub const LIGGGHTS_HOOKE: NormalLaw =
    NormalLaw::LiggghtsHooke(LiggghtsHooke { characteristic_velocity: 1.0 });

fn materials(friction: f64) -> Materials {
    let soft = Material { density: 2500.0, youngs_modulus: 5e6, poissons_ratio: 0.3 };
    let hard = Material { density: 4000.0, youngs_modulus: 2e7, poissons_ratio: 0.2 };
    Materials::new(vec![soft, hard], move |a, b| (0.5 + 0.1 * (a + b) as f64, friction))
}

/// A number in [0, 1) that follows from k.
fn scattered(k: usize) -> f64 {
    ((k as f64 + 1.0) * 0.754_877_666_246_692_7).fract()
}

/// Grains on a slightly overlapping lattice, `layers` of 10 × 10, that move and spin about; one in seven is of
/// another size and material and one in fifty is frozen where they are `mixed`.
fn heap(layers: usize, mixed: bool) -> Vec<Grain<3>> {
    let grain = |k: usize| {
        let odd = mixed && k % 7 == 3;
        let at = [k % 10, k / 10 % 10, k / 100].map(|n| (1.98 * n as f64 + 1.0) * RADIUS);
        let speed = |c: usize| 0.4 * (scattered(7 * k + c) - 0.5);
        let mut grain = Grain::at(at, if odd { 0.7 * RADIUS } else { RADIUS })
            .moving([speed(0), speed(1), speed(2)])
            .spinning([300.0 * speed(3), 300.0 * speed(4), 300.0 * speed(5)]);
        grain.material = u32::from(odd);
        if mixed && k % 50 == 49 { grain.frozen() } else { grain }
    };
    (0..100 * layers).map(grain).collect()
}

fn placed<const D: usize>(scene: &Scene<D>, grains: Vec<Grain<D>>) -> World<D> {
    let mut world = World::new();
    grains.iter().for_each(|grain| world.add(scene, grain));
    world
}

/// A heap in a box of planes under gravity.
pub fn boxed(layers: usize, mixed: bool, law: NormalLaw, friction: f64) -> (Scene<3>, World<3>) {
    let far = 20.0 * RADIUS;
    let wall = |name, point, normal| Wall::plane(name, 0, point, normal);
    let walls = vec![
        wall("floor", [0.0; 3], [0.0, 0.0, 1.0]),
        wall("west", [0.0; 3], [1.0, 0.0, 0.0]),
        wall("east", [far, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        wall("south", [0.0; 3], [0.0, 1.0, 0.0]),
        wall("north", [0.0, far, 0.0], [0.0, -1.0, 0.0]),
    ];
    let scene =
        Scene::new(materials(friction), law).with_gravity([0.0, 0.0, -9.81]).with_walls(Walls::new(walls));
    let world = placed(&scene, heap(layers, mixed));
    (scene, world)
}

/// A heap that meets its own images.
pub fn periodic(layers: usize, mixed: bool) -> (Scene<3>, World<3>) {
    let period = |n: usize| 1.98 * n as f64 * RADIUS;
    let domain = Domain::new([0.0; 3], [period(10), period(10), period(layers)]).periodic([true; 3]);
    let scene = Scene::new(materials(0.5), HERTZ).in_domain(domain);
    let world = placed(&scene, heap(layers, mixed));
    (scene, world)
}

/// The heap in a box, cohesive and hard to roll by these laws.
pub fn sticky(
    layers: usize,
    mixed: bool,
    law: NormalLaw,
    (rolling, cohesion): (RollingLaw, CohesionLaw),
) -> (Scene<3>, World<3>) {
    let (mut scene, world) = boxed(layers, mixed, law, 0.5);
    scene.materials = scene.materials.with(|a, b, pair| {
        pair.rolling_friction = 0.05 + 0.02 * (a + b) as f64;
        pair.rolling_damping_ratio = 0.3;
        pair.cohesion_energy_density = 2e4;
    });
    scene.extras = Extras { rolling: Some(rolling), cohesion: Some(cohesion), ..Extras::default() };
    (scene, world)
}

/// The heap in a box, lubricated, with bridges of liquid or necks of solid between grains that resist twisting.
pub fn adhesive(layers: usize, law: CohesionLaw, friction: f64) -> (Scene<3>, World<3>) {
    let (mut scene, world) = boxed(layers, true, HERTZ, friction);
    scene.materials = scene.materials.with(|a, b, pair| {
        pair.work_of_adhesion = 0.05 + 0.02 * (a + b) as f64;
        pair.surface_tension = 0.07;
        pair.contact_angle = 0.2;
        pair.bridge_volume_ratio = 0.01;
    });
    let film = Lubrication { viscosity: 0.01, roughness: 1e-6, cut_off: 0.2 * RADIUS };
    scene.extras = Extras {
        cohesion: Some(law),
        twisting: (friction > 0.0).then_some(TwistingLaw::Marshall),
        lubrication: Some(film),
        ..Extras::default()
    };
    (scene, world)
}

/// Discs of two sizes and materials between three lines, that move and spin about.
pub fn discs(law: NormalLaw, friction: f64) -> (Scene<2>, World<2>) {
    let far = 60.0 * RADIUS;
    let wall = |name, point, normal| Wall::plane(name, 0, point, normal);
    let walls = Walls::new(vec![
        wall("floor", [0.0; 2], [0.0, 1.0]),
        wall("west", [0.0; 2], [1.0, 0.0]),
        wall("east", [far, 0.0], [-1.0, 0.0]),
    ]);
    let scene = Scene::new(materials(friction), law).with_gravity([0.0, -9.81]).with_walls(walls);
    let disc = |k: usize| {
        let odd = k % 7 == 3;
        let at = [k % 30, k / 30].map(|n| (1.98 * n as f64 + 1.0) * RADIUS);
        let speed = |c: usize| 0.4 * (scattered(7 * k + c) - 0.5);
        let mut disc = Grain::at(at, if odd { 0.7 * RADIUS } else { RADIUS })
            .moving([speed(0), speed(1)])
            .spinning([0.0, 0.0, 300.0 * speed(2)]);
        disc.material = u32::from(odd);
        disc
    };
    let world = placed(&scene, (0..600).map(disc).collect());
    (scene, world)
}

/// Spheres of 0.25 to 5 mm that fly about in a periodic box, a few of each size touching.
pub fn one_to_twenty() -> (Scene<3>, World<3>) {
    const SIDE: f64 = 25e-3;
    let domain = Domain::new([0.0; 3], [SIDE; 3]).periodic([true; 3]);
    let scene = Scene::new(materials(0.5), HERTZ).in_domain(domain);
    let mut random = Random::new(6);
    let mut grains: Vec<Grain<3>> = Vec::new();
    for (count, radius) in [(4, 5e-3), (16, 2.5e-3), (80, 1e-3), (400, 0.25e-3)] {
        let all = grains.len() + count;
        while grains.len() < all {
            let at = [(); 3].map(|()| random.between(0.0, SIDE));
            let free = grains.iter().all(|other| {
                let apart = [0, 1, 2].map(|axis| {
                    let d = at[axis] - other.centre[axis];
                    d - SIDE * (d / SIDE).round()
                });
                apart.map(|d| d * d).iter().sum::<f64>().sqrt() > 0.995 * (radius + other.radius)
            });
            if free {
                let velocity = [(); 3].map(|()| random.between(-2.0, 2.0));
                let spin = [(); 3].map(|()| random.between(-200.0, 200.0));
                let grain = Grain::at(at, radius).moving(velocity).spinning(spin);
                grains.push(Grain { material: (grains.len() % 2) as u32, ..grain });
            }
        }
    }
    let world = placed(&scene, grains);
    (scene, world)
}
