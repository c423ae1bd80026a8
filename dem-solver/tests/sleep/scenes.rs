//! Heaps that several claims share.

use std::sync::OnceLock;

use dem_solver::contact::NormalLaw;
use dem_solver::contact::normal::Hertz;
use dem_solver::wall::{Wall, Walls};
use dem_solver::{
    Grain, Ledger, Material, Materials, Scene, SleepBound, Spin, Substep, Workspace, World,
    critical_time_step, substeps, turn_over, window,
};

pub const RADIUS: f64 = 1e-3;
pub const G: f64 = 9.81;
/// Heaps along x and y, and how far apart they are, in radii.
const HEAPS_ALONG: u32 = 12;
const HEAPS_ACROSS: u32 = 10;
const SPACING: f64 = 10.0;
/// Height of a grain in the hollow of four, in radii.
const HOLLOW: f64 = std::f64::consts::SQRT_2;
/// Grains of the first chunk.
pub const FIRST: usize = 1024;
/// A time in which much can happen.
pub const WINDOW: f64 = 5e-3;

/// As a case has it by default.
pub const BOUND: SleepBound = SleepBound { speed: 1.4e-5, acceleration: 1e-3 * G };

/// A soft glass.
pub fn glass() -> Materials {
    let glass = Material { density: 2500.0, youngs_modulus: 2e6, poissons_ratio: 0.3 };
    Materials::new(vec![glass], |_, _| (0.1, 0.5))
}

/// Heaps need no walls but these.
pub fn scene(walls: impl IntoIterator<Item = Wall<3>>) -> Scene<3> {
    let law = NormalLaw::Hertz(Hertz { depth: 1.0 });
    let walls = Walls::new(walls.into_iter().collect());
    Scene::new(glass(), law).with_gravity([0.0, 0.0, -G]).with_walls(walls)
}

/// One window at half the critical step, as a run does it.
pub fn pass(scene: &Scene<3>, world: &mut World<3>, workspace: &mut Workspace<3>) -> Ledger<3> {
    turn_over(scene, world).unwrap();
    let count = substeps(WINDOW, Substep::Fraction(0.5), &critical_time_step(scene, world)).unwrap();
    window(scene, world, workspace, None, WINDOW, count).unwrap()
}

/// Windows until this time \[s\].
pub fn run(scene: &Scene<3>, world: &mut World<3>, until: f64) {
    let mut workspace = Workspace::new();
    while world.time < until - 0.5 * WINDOW {
        pass(scene, world, &mut workspace);
    }
}

/// How many grains sleep.
pub fn asleep(world: &World<3>) -> usize {
    let chunks = world.contacts.chunks.iter().zip(&world.contacts.quiet);
    chunks.filter(|(_, quiet)| quiet.is_asleep()).map(|(chunk, _)| chunk.rows.len()).sum()
}

/// Heaps of four grains on nine frozen ones, in rows along x, asleep: two chunks.
///
/// Every grain is held by four others. In a bed poured at random without resistance to rolling and twisting a few in loose
/// cages roll or spin for ever, and keep their chunks awake.
pub fn sleeping_heaps() -> World<3> {
    static HEAPS: OnceLock<World<3>> = OnceLock::new();
    HEAPS
        .get_or_init(|| {
            let (scene, mut world) = (scene([]).with_sleep(BOUND), World::new());
            for heap in 0..HEAPS_ALONG * HEAPS_ACROSS {
                let foot = [heap / HEAPS_ACROSS, heap % HEAPS_ACROSS].map(|index| SPACING * f64::from(index));
                let at = |x: u32, y: u32, lift: f64| {
                    let place = [foot[0] + f64::from(x), foot[1] + f64::from(y), lift];
                    Grain::at(place.map(|x| x * RADIUS), RADIUS)
                };
                (0..9).for_each(|k| world.add(&scene, &at(2 * (k % 3), 2 * (k / 3), 0.0).frozen()));
                (0..4).for_each(|k| world.add(&scene, &at(1 + 2 * (k % 2), 1 + 2 * (k / 2), HOLLOW)));
            }
            while asleep(&world) < world.grains.len() {
                assert!(world.time < 1.0, "{} of {} sleep", asleep(&world), world.grains.len());
                let until = world.time + 0.02;
                run(&scene, &mut world, until);
            }
            world
        })
        .clone()
}

/// Height of the top of the highest grain \[m\].
pub fn top(world: &World<3>) -> f64 {
    world.grains.place.iter().map(|place| place.centre.z + place.radius).fold(0.0, f64::max)
}

/// Row of a grain.
pub fn row(world: &World<3>, id: u64) -> usize {
    world.grains.id.iter().position(|&of_row| of_row == id).unwrap()
}

/// A grain that falls into the hollow on top of the last heap, about to touch it; its identity.
pub fn drop_one(scene: &Scene<3>, world: &mut World<3>, speed: f64) -> u64 {
    let foot = [HEAPS_ALONG - 1, HEAPS_ACROSS - 1].map(|index| SPACING * f64::from(index));
    let at = [foot[0] + 2.1, foot[1] + 2.05, 2.0 * HOLLOW + 0.4].map(|x| x * RADIUS);
    world.add(scene, &Grain::at(at, RADIUS).moving([0.0, 0.0, -speed]));
    world.born - 1
}

/// Furthest way between the same grains of two worlds \[m\].
pub fn furthest(one: &World<3>, other: &World<3>) -> f64 {
    let mut place = vec![Spin::zeros(); other.born as usize];
    other.grains.id.iter().zip(&other.grains.place).for_each(|(&id, at)| place[id as usize] = at.centre);
    let ways =
        one.grains.id.iter().zip(&one.grains.place).map(|(&id, at)| (at.centre - place[id as usize]).norm());
    ways.fold(0.0, f64::max)
}
