//! Scenes that meet every branch of the engine.

use dem_solver::contact::cohesion::CohesionLaw;
use dem_solver::contact::lubrication::Lubrication;
use dem_solver::contact::normal::{Hertz, Hooke};
use dem_solver::contact::rolling::RollingLaw;
use dem_solver::contact::twisting::TwistingLaw;
use dem_solver::contact::{Extras, NormalLaw};
use dem_solver::wall::{Wall, Walls};
use dem_solver::{Domain, Grain, Material, Materials, Scene, World};

pub const STEP: f64 = 2e-6;
const RADIUS: f64 = 1e-3;

pub const HERTZ: NormalLaw = NormalLaw::Hertz(Hertz { depth: 1.0 });
pub const PARTIAL_SLIP: NormalLaw = NormalLaw::HertzPartialSlip(Hertz { depth: 1.0 });
pub const HOOKE: NormalLaw = NormalLaw::Hooke(Hooke { characteristic_velocity: 1.0, depth: 1.0 });

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

fn placed(scene: &Scene<3>, grains: Vec<Grain<3>>) -> World<3> {
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

/// The heap in a box, cohesive and hard to roll.
pub fn sticky(layers: usize, mixed: bool) -> (Scene<3>, World<3>) {
    let (mut scene, world) = boxed(layers, mixed, HERTZ, 0.5);
    scene.materials = scene.materials.with(|a, b, pair| {
        pair.rolling_friction = 0.05 + 0.02 * (a + b) as f64;
        pair.rolling_damping_ratio = 0.3;
        pair.cohesion_energy_density = 2e4;
    });
    scene.extras =
        Extras { rolling: Some(RollingLaw::Epsd), cohesion: Some(CohesionLaw::Sjkr), ..Extras::default() };
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
